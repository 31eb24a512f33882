#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Types what TUTORIAL.md says, in a temporary folder, and compares what is printed with what stands there, but for
# numbers:   tutorial_test.sh BUILD_DIR
# Writes what is printed into the document:   tutorial_test.sh BUILD_DIR --update
set -uo pipefail
build=$(cd "${1:?usage: tutorial_test.sh BUILD_DIR [--update]}" && pwd)
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
document=$root/validation/user/TUTORIAL.md
work=$(mktemp -d)
export XDG_CACHE_HOME=$work/cache
trap 'rm -rf "$work"' EXIT

# A tree as the text expects it: the kit, the rules, the build; and a `stiction` that builds nothing but a new rule.
mkdir -p "$work/tree/build" "$work/tree/solver/friction/rules"
cd "$work/tree" || exit 1
ln -s "$root/validation" validation
ln -s "$build" build/release
cat >stiction <<SCRIPT
#!/usr/bin/env bash
set -euo pipefail
command=\$1
shift
case \$command in
  validate) exec "$build/validate" "\$@" --no-page ;;
  engine) exec "$build/engine" "\$@" ;;
  compare)
    [ -z "\$(ls solver/friction/rules)" ] || exec "$work/with_rules" "\$@" --no-page
    exec "$build/compare" "\$@" --no-page
    ;;
esac
exit 2
SCRIPT
cat >"$work/with_rules" <<SCRIPT
#!/usr/bin/env bash
exec "$root/validation/user/compare_with_rules.py" "$build" "$root" "$work" "\$@"
SCRIPT
chmod +x stiction "$work/with_rules"

export COLUMNS=80 TERM=dumb NO_COLOR=1
exec python3 - "$document" "$work" "${2:-}" <<'PYTHON'
import difflib
import pathlib
import re
import subprocess
import sys
import time

document, work, update = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3] == "--update"
tree = pathlib.Path(work, "tree")
# A directive, or none, before a fenced block.
BLOCK = re.compile(r"(?:<!-- (\w+): (\S+) -->\n)?```(\w*)\n(.*?)```\n", re.S)


def masked(text):
    """What must be the same: words, not numbers, nor how they fill their columns."""
    text = re.sub(r"\b[0-9a-f]{12}\b\+?", "REVISION", text)
    text = re.sub(r"[-+−]?\d+(?:[.,:]\d+)*(?:e[-+]?\d+)?", "#", text)
    text = re.sub(r"[<≤]? *# *(?:%|×)|exact", "#", text)
    text = re.sub(r"#(?:-?#|T#|Z|\s*min)+", "#", text)
    return [" ".join(line.split()) for line in text.splitlines() if line.strip()]


text = document.read_text()
result, at, printed, command, faults = "", 0, None, "", 0
for block in BLOCK.finditer(text):
    word, value, language, content = block.groups()
    replaced = block.group(0)
    if word == "file":
        (tree / value).write_text(content)
        printed = None
    elif language == "sh":
        began = time.monotonic()
        done = subprocess.run(["bash", "-c", content], cwd=tree, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        printed = done.stdout.replace(f"{tree}/", "")
        command = content.strip().splitlines()[-1].strip()
        wanted = int(value) if word == "exit" else 0
        print(f"{time.monotonic() - began:6.1f} s  {command}", flush=True)
        if done.returncode != wanted:
            sys.exit(f"FAIL  exit code {done.returncode}, not {wanted}, of: {command}\n{done.stdout}")
    elif language == "text" and printed is not None:
        if update:
            replaced = "```text\n" + "".join(line.rstrip() + "\n" for line in printed.strip("\n").splitlines()) + "```\n"
        elif masked(content) != masked(printed):
            faults += 1
            print(f"FAIL  not what stands below: {command}")
            print("\n".join("      " + line for line in difflib.unified_diff(masked(content), masked(printed), "document", "printed", lineterm="")))
        printed = None
    result += text[at : block.start()] + replaced
    at = block.end()
if update:
    document.write_text(result + text[at:])
sys.exit(1 if faults else 0)
PYTHON
