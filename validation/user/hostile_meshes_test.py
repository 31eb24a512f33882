#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh files that no honest program wrote: hostile_meshes_test.py BUILD_DIR [COUNT]

`validate PROBLEM --check-only` reads COUNT (300) surfaces, each a good one changed by chance: bytes,
counts, numbers, indices, lines, line endings, what is cut off. It must say of each what it is, or one
sentence of what is wrong, within a limit of time and memory. Every change follows from --seed and its
number alone, so that --only N does one of them again.
"""
import argparse
import collections
import concurrent.futures
import os
import pathlib
import random
import re
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time

TIME_LIMIT = 30.0        # s, of one file; the mesher itself is given up after MESHER_LIMIT
MESHER_LIMIT = 20.0      # s
MEMORY_LIMIT = 1024.0    # MB, of the program and the mesher

PROBLEM = """
title = "a mesh"
duration = 0.01
[[body]]
name = "body"
shape = "surface"
file = "FILE"
cell_size = 0.5
most_tetrahedra = 2000
time_limit = LIMIT
mass = 1.0
position = [0, 0, 1]
[[check]]
observable = "speed"
expected = 0.0981
tolerance = 1e-3
reason = "it is never run"
"""


# ---- good surfaces, as points and faces, and every way to write them -------------------------------

def tetrahedron():
    return [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]


def cube(low=0.0, high=1.0):
    points = [tuple(high if k >> axis & 1 else low for axis in range(3)) for k in range(8)]
    squares = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return points, [face for a, b, c, d in squares for face in ((a, b, c), (a, c, d))]


def hollow():
    (outer, faces), (inner, _) = cube(), cube(0.25, 0.75)
    return outer + inner, faces + [(8 + a, 8 + c, 8 + b) for a, b, c in faces]


def words(numbers):
    return " ".join(f"{number:g}" for number in numbers)


def off(points, faces):
    lines = ["OFF", f"{len(points)} {len(faces)} 0", *map(words, points), *("3 " + words(face) for face in faces)]
    return ("\n".join(lines) + "\n").encode()


def binary_off(points, faces):
    return (b"OFF BINARY\n" + struct.pack(">3i", len(points), len(faces), 0) +
            b"".join(struct.pack(">3f", *point) for point in points) +
            b"".join(struct.pack(">5i", 3, *face, 0) for face in faces))


def obj(points, faces):
    lines = ["# a body", "o body", *("v " + words(point) for point in points), "vn 0 0 1",
             *("f " + " ".join(f"{corner + 1}//1" for corner in face) for face in faces)]
    return ("\n".join(lines) + "\n").encode()


def ply(points, faces, kind):
    header = [f"ply\nformat {kind} 1.0\ncomment a body\nelement vertex {len(points)}",
              "property float x\nproperty float y\nproperty float z",
              f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"]
    order = {"binary_little_endian": "<", "binary_big_endian": ">"}.get(kind)
    if order:
        body = b"".join(struct.pack(order + "3f", *point) for point in points)
        body += b"".join(struct.pack(order + "B3i", 3, *face) for face in faces)
    else:
        body = "".join(words(point) + "\n" for point in points).encode()
        body += "".join("3 " + words(face) + "\n" for face in faces).encode()
    return "\n".join(header).encode() + body


def stl(points, faces):
    lines = ["solid body"]
    for face in faces:
        lines += ["facet normal 0 0 0", "outer loop", *("vertex " + words(points[k]) for k in face), "endloop", "endfacet"]
    return ("\n".join([*lines, "endsolid body"]) + "\n").encode()


def binary_stl(points, faces):
    return (b"binary".ljust(80) + struct.pack("<I", len(faces)) +
            b"".join(struct.pack("<12fH", 0, 0, 0, *(x for k in face for x in points[k]), 0) for face in faces))


WAYS = {
    "off": ("off", off),
    "binary-off": ("off", binary_off),
    "obj": ("obj", obj),
    "ply": ("ply", lambda *mesh: ply(*mesh, "ascii")),
    "little-ply": ("ply", lambda *mesh: ply(*mesh, "binary_little_endian")),
    "big-ply": ("ply", lambda *mesh: ply(*mesh, "binary_big_endian")),
    "stl": ("stl", stl),
    "binary-stl": ("stl", binary_stl),
}
GOOD = [mesh() for mesh in (tetrahedron, cube, hollow)]

# ---- changes: bytes and chance → bytes -------------------------------------------------------------

NUMBER = re.compile(rb"(?<![\w.])[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")


def some_number(data, chance, becomes):
    found = list(NUMBER.finditer(data))
    if not found:
        return data
    one = chance.choice(found)
    return data[:one.start()] + becomes(one.group()) + data[one.end():]


def flipped(data, chance):
    changed = bytearray(data)
    for _ in range(chance.choice((1, 1, 2, 8, 32))):
        if changed:
            changed[chance.randrange(len(changed))] ^= 1 << chance.randrange(8)
    return bytes(changed)


def other_bytes(data, chance):
    changed = bytearray(data)
    for _ in range(chance.choice((1, 4))):
        if changed:
            changed[chance.randrange(len(changed))] = chance.randrange(256)
    return bytes(changed)


def larger_count(data, chance):
    """A whole number, or four bytes that may be one."""
    if chance.random() < 0.5 and len(data) > 90:
        at = chance.choice((80, 11, 15, data.find(b"end_header\n") + 11 + chance.randrange(40)))
        count = struct.pack(chance.choice("<>") + "I", chance.choice((100, 65535, 2**24, 2**31 - 1, 2**31, 2**32 - 1)))
        return data[:at] + count + data[at + 4:]
    factor = chance.choice((2, 10, 1000, 10**6, 10**9, 10**15, 10**25))
    return some_number(data, chance, lambda word: b"%d" % max(-1e300, min(float(word) * factor + chance.randrange(3), 1e300)))


def odd_number(data, chance):
    odd = [b"nan", b"-nan", b"inf", b"-inf", b"1e308", b"-1e308", b"1.8e308", b"1e400", b"1e-320", b"0x10", b"1,5",
           b"", b"-", b"1e", b"--1", b"1" * 400, b"0." + b"0" * 400 + b"1"]
    if chance.random() < 0.3 and len(data) > 100:
        at = chance.randrange(84, len(data))
        bits = chance.choice((0x7FC00000, 0x7F800000, 0xFF800000, 0x7F7FFFFF, 0x00000001, 0x80000000))
        return data[:at] + struct.pack(chance.choice("<>") + "I", bits) + data[at + 4:]
    for _ in range(chance.choice((1, 1, 5))):
        data = some_number(data, chance, lambda word: chance.choice(odd))
    return data


def odd_index(data, chance):
    index = chance.choice((-1, -2, -1000, 99, 2**31 - 1, 2**31, -2**31, 2**32, 2**63, 2**64, -2**63))
    if chance.random() < 0.3 and len(data) > 100:
        at = chance.randrange(84, len(data))
        return data[:at] + struct.pack(chance.choice("<>") + "q", index % 2**63)[:4] + data[at + 4:]
    return some_number(data, chance, lambda word: str(index).encode())


def huge(data, chance):
    """All coordinates times a factor."""
    factor = chance.choice((1e-300, 1e-40, 1e-17, 1e-6, 1e6, 1e30, 1e150, 1e300))
    return NUMBER.sub(lambda word: word.group() if word.group().isdigit() and chance.random() < 0.5
                      else b"%.17g" % (float(word.group()) * factor), data)


def lines_changed(data, chance):
    lines = data.splitlines(keepends=True)
    for _ in range(chance.choice((1, 1, 3))):
        if not lines:
            break
        at, count = chance.randrange(len(lines)), chance.choice((1, 1, 4))
        some = lines[at:at + count]
        what = chance.randrange(4)
        if what == 0:
            del lines[at:at + count]
        elif what == 1:
            lines[at:at] = some * chance.choice((1, 1, 100))
        elif what == 2:
            del lines[at:at + count]
            to = chance.randrange(len(lines) + 1)
            lines[to:to] = some
        else:
            lines[at] = lines[at].rstrip(b"\r\n")
    return b"".join(lines)


def cut_off(data, chance):
    return data[:chance.randrange(len(data) + 1)]


def line_endings(data, chance):
    ends = chance.choice(([b"\r\n"], [b"\r"], [b"\n", b"\r\n", b"\r"], [b"\n\n"], [b" \t\n"], [b"\n", b"\0\n"], [b"\x0b"]))
    return b"".join(line + chance.choice(ends) for line in data.split(b"\n"))


def header_alone(data, chance):
    lines = data.splitlines(keepends=True)
    last = lines.index(b"end_header\n") + 1 if b"end_header\n" in lines else chance.randrange(1, 4)
    kept = b"".join(lines[:last])
    if chance.random() < 0.5:
        kept = b"".join(line for line in lines[:last] if chance.random() < 0.8)
    return kept if chance.random() < 0.7 else kept + chance.randbytes(chance.randrange(200))


def joined(data, chance):
    mesh = chance.choice(GOOD)
    other = chance.choice(list(WAYS.values()))[1](*mesh)
    return data + other if chance.random() < 0.5 else data[:chance.randrange(len(data) + 1)] + other[chance.randrange(len(other)):]


def words_put_in(data, chance):
    word = chance.choice((b"# ", b"comment ", b"property list uint double q\n", b"property float x\n", b"element face 3\n",
                          b"element edge 1000000\n", b"property list uchar uchar vertex_indices\n", b"end_header\n", b"COFF\n",
                          b"STNOFF\n", b"4nOFF 7\n", b"BINARY\n", b"vertex 1 2\n", b"f 1 2 3 4 5\n", b"f\n", b"v\n", b"endsolid\n",
                          b"\0" * 8, b"\xff" * 8, b"\xef\xbb\xbf", b"9" * 30, b"9" * 20000, b" " * 20000, b"\x1b[2J"))
    at = chance.choice((0, chance.randrange(len(data) + 1), data.find(b"\n", chance.randrange(len(data) + 1)) + 1))
    return data[:at] + word + data[at:]


CHANGES = [flipped, other_bytes, larger_count, odd_number, odd_index, huge, lines_changed, cut_off, line_endings,
           header_alone, joined, words_put_in]


def change(seed, number):
    """The name of a way to write, the bytes, and what was done to them."""
    chance = random.Random(f"{seed}/{number}")
    way = list(WAYS)[number % len(WAYS)]
    data = WAYS[way][1](*chance.choice(GOOD))
    done = [chance.choice(CHANGES) for _ in range(chance.choice((1, 1, 1, 2, 3)))]
    for one in done:
        data = one(data, chance)
    return way, data, "+".join(one.__name__ for one in done)


# ---- the program -----------------------------------------------------------------------------------

def run(command, folder):
    """Exit code (minus a signal's number), stdout, stderr, MB at most, whether it took too long."""
    with tempfile.TemporaryFile() as output, tempfile.TemporaryFile() as errors:
        child = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=output, stderr=errors,
                                 start_new_session=True)
        late = threading.Event()

        def stop():
            late.set()
            os.killpg(child.pid, signal.SIGKILL)

        clock = threading.Timer(TIME_LIMIT, stop)
        clock.start()
        _, status, usage = os.wait4(child.pid, 0)
        clock.cancel()
        child.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        errors.seek(0)
        return child.returncode, output.read(), errors.read(), usage.ru_maxrss / 1024, late.is_set()


def faults_of(code, output, errors, memory, late):
    faults = []
    if late:
        return [f"it took longer than {TIME_LIMIT:g} s"]
    if code not in (0, 1, 2, 3):
        faults.append(f"exit code {code}")
    if memory > MEMORY_LIMIT:
        faults.append(f"{memory:.0f} MB")
    if code == 0 and (b"tetrahedra" not in output or errors):
        faults.append(f"it says of a good one {errors!r}")
    errors = re.sub(rb"^meshing mesh.*\n", b"", errors)  # told of what takes longer
    if code != 0 and (output or errors.count(b"\n") != 1 or not errors.endswith(b"\n") or len(errors) > 600):
        faults.append(f"no single sentence: {(output + errors)!r}")
    # A refusal is told with its reason; the mesher may be stopped, but not fail.
    if re.search(rb"signal \d|mesher (ended|was killed|wrote|failed)|CGAL ERROR|memory ran out|std::", errors):
        faults.append(f"the mesher fell over: {errors!r}")
    if re.search(rb"[\0-\x09\x0b-\x1f\x7f]", errors):
        faults.append(f"control characters: {errors!r}")
    return faults


class Campaign:
    def __init__(self, build, seed, folder, keep):
        self.validate, self.seed, self.folder, self.keep = str(build / "validate"), seed, folder, keep
        self.local = threading.local()

    def own_folder(self):
        if not hasattr(self.local, "folder"):
            self.local.folder = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
            for suffix in ("off", "obj", "ply", "stl"):
                text = PROBLEM.replace("FILE", f"mesh.{suffix}").replace("LIMIT", f"{MESHER_LIMIT:g}")
                (self.local.folder / f"{suffix}.toml").write_text(text)
        return self.local.folder

    def one(self, number):
        folder = self.own_folder()
        way, data, done = change(self.seed, number)
        suffix = WAYS[way][0]
        (folder / f"mesh.{suffix}").write_bytes(data)
        began = time.monotonic()
        ended = run([self.validate, f"{suffix}.toml", "--check-only"], folder)
        took = time.monotonic() - began
        faults = faults_of(*ended)
        if faults and self.keep:
            self.keep.mkdir(parents=True, exist_ok=True)
            (self.keep / f"{self.seed}-{number}.{suffix}").write_bytes(data)
        return number, way, done, faults, took, ended


def reason(errors):
    """A refusal without the names and numbers in it."""
    return re.sub(r"[-\d.e+ ]*\d[-\d.e+ ]*", " N ", errors.decode(errors="replace").split(": ", 3)[-1].strip())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("count", type=int, nargs="?", default=300)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=int, help="this change alone, and what the program says of it")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--keep", type=pathlib.Path, help="folder for files of which something wrong was said")
    arguments = parser.parse_args()

    codes, ways, reasons = collections.Counter(), collections.Counter(), collections.Counter()
    meshed, stopped = collections.Counter(), []
    slowest, largest, failures = (0.0, None), (0.0, None), 0
    with tempfile.TemporaryDirectory() as name:
        os.environ["XDG_CACHE_HOME"] = os.path.join(name, "cache")
        campaign = Campaign(arguments.build.resolve(), arguments.seed, name, arguments.keep)
        for way, (suffix, write) in WAYS.items():  # or the campaign shows nothing
            folder = campaign.own_folder()
            (folder / f"mesh.{suffix}").write_bytes(write(*cube()))
            ended = run([campaign.validate, f"{suffix}.toml", "--check-only"], folder)
            if ended[0] != (2 if way == "binary-off" else 0) or faults_of(*ended):
                failures += 1
                print(f"FAIL    a good {way}: {ended[2].decode(errors='replace')}")
        numbers = range(arguments.count) if arguments.only is None else [arguments.only]
        with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
            for number, way, done, faults, took, ended in pool.map(campaign.one, numbers):
                code, output, errors, memory, late = ended
                codes["too late" if late else code] += 1
                ways[way] += 1
                meshed[way] += code == 0
                if b"mesher was stopped after" in errors:
                    stopped.append(number)
                if code:
                    reasons[reason(errors)] += 1
                slowest, largest = max(slowest, (took, number)), max(largest, (memory, number))
                for fault in faults:
                    failures += 1
                    print(f"FAIL    {number} ({way}, {done}): {fault[:600]}", flush=True)
                if arguments.only is not None:
                    print((output + errors).decode(errors="replace"), end="")
    print(f"{sum(ways.values())} files, seed {arguments.seed}: " + ", ".join(f"{way} {n}" for way, n in ways.items()))
    print("exit codes: " + ", ".join(f"{code}: {n}" for code, n in sorted(codes.items(), key=str)))
    print("meshed: " + ", ".join(f"{way} {n}" for way, n in meshed.items()))
    print(f"slowest {slowest[0]:.2f} s (change {slowest[1]}), most memory {largest[0]:.0f} MB (change {largest[1]})")
    print(f"mesher stopped at its limit of {MESHER_LIMIT:g} s: {len(stopped)} {stopped[:20] or ''}")
    for text, n in reasons.most_common(25):
        print(f"{n:8} {text[:150]}")
    print(f"{failures} fail")
    sys.exit(1 if failures else 0)


main()
