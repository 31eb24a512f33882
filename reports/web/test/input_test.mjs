// SPDX-License-Identifier: GPL-3.0-or-later
// What the program says to input that is not as it should be.
import assert from "node:assert/strict";
import {
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  symlinkSync,
  writeFileSync,
} from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { gunzipSync } from "node:zlib";
import {
  check,
  HOSTILE,
  lines_of,
  make_run,
  old_check,
  old_record,
  record,
  varied_records,
} from "./records.mjs";
import { make_page, report } from "./report.mjs";
import { temporary_folder } from "./temporary.mjs";

const good = lines_of([record(), record({ case: "other" })]);

function refused(words, message) {
  const { status, err, out } = report(...words);
  assert.equal(status, 2, out);
  assert.match(err, message);
  assert.doesNotMatch(err, /\n\s+at /, "a stack trace is no message");
}

test("the page stands in the run's folder unless told otherwise", () => {
  const folder = make_run(good);
  const { status, out } = report(folder);
  assert.equal(status, 0);
  assert.match(out, /report\.html/);
  assert.ok(existsSync(join(folder, "report.html")));
  assert.ok(!readdirSync(folder).some((name) => name.endsWith(".partial")));
});

test("an out-dir is read by its 'latest'", () => {
  const folder = make_run(good, "2025-11-20T23-41-05Z");
  symlinkSync("2025-11-20T23-41-05Z", join(dirname(folder), "latest"));
  assert.equal(report(dirname(folder)).status, 0);
});

// Runs of an out-dir, by their names.
function out_dir(runs) {
  const folder = temporary_folder();
  for (const [name, text] of Object.entries(runs)) {
    mkdirSync(join(folder, name));
    writeFileSync(join(folder, name, "records.jsonl"), text);
  }
  return folder;
}

test("an out-dir without 'latest' is read by its newest run that has a record", () => {
  const folder = out_dir({
    "2025-11-20T23-41-05Z": good,
    "2025-11-20T23-41-06Z-2": good,
    "2025-11-20T23-41-06Z-10": good,
    "2025-11-20T23-41-07Z": "",
    "2026-other": good,
  });
  const { status, out } = report(folder);
  assert.equal(status, 0);
  assert.match(out, /2025-11-20T23-41-06Z-10\/report\.html/);
});

test("a comparison says what changed, by its exit code too, and leaves the run's own page", () => {
  const verdicts = (...list) =>
    lines_of(list.map((verdict, i) => record({ case: `case/${i}`, verdict })));
  const folder = out_dir({
    "2025-11-20T23-41-05Z": verdicts("pass", "pass", "fail"),
    "2025-11-20T23-41-06Z": verdicts("pass", "fail", "pass"),
    "2025-11-20T23-41-07Z": lines_of([record({ case: "another" })]),
  });
  const [before, after, foreign] = readdirSync(folder)
    .sort()
    .map((name) => join(folder, name));
  report(after);
  const own = readFileSync(join(after, "report.html"), "utf8");
  const { status, out } = report(after, "--against", before);
  assert.equal(status, 1);
  assert.match(
    out,
    /Against 2025-11-20T23-41-05Z: 2 verdicts changed, 1 better, 1 worse, of 3 compared\./,
  );
  assert.match(out, /verdict worse {2}case\/1: pass → fail/);
  assert.equal(readFileSync(join(after, "report.html"), "utf8"), own);
  assert.ok(existsSync(join(after, "report-against-2025-11-20T23-41-05Z.html")));
  const same = report(before, "--against", before);
  assert.equal(same.status, 0);
  assert.match(same.out, /0 verdicts changed, 0 better, 0 worse, of 3 compared/);
  refused([after, "--against", foreign], /no case of 2025-11-20T23-41-07Z is in this run too/);
});

test("nothing to show is refused in words", () => {
  refused([], /name the folder of a run/);
  refused(["/does/not/exist"], /does not exist/);
  refused([dirname(make_run(good))], /holds no records\.jsonl/);
  refused([make_run("")], /is empty: no case was finished/);
  refused([make_run("\u0000\u0001\u0002 no JSON\n")], /no record can be read \(line 1: not JSON\)/);
  refused([make_run('{"schema_version":1')], /line 1 is cut off/);
  refused([make_run(good), "--limit", "none"], /--limit needs a number/);
  refused([make_run(good), "--no-such-option"], /no-such-option/);
  refused(
    [make_run(good), "--out", "/proc/none/report.html"],
    /cannot write \/proc\/none\/report\.html/,
  );
});

test("a newer schema is named", () => {
  refused([make_run(lines_of([record({ schema_version: 5 })]))], /schema version 5 is newer/);
});

// The text of a page's index, packed or not.
function index_of(file) {
  const [, encoding, text] = /data-asset="index" data-encoding="(\w+)">([^<]*)</.exec(
    readFileSync(file, "utf8"),
  );
  return encoding === "gzip" ? gunzipSync(Buffer.from(text, "base64")).toString() : text;
}

test("a run that was cut off is shown with a warning", () => {
  const folder = make_run(good + good.slice(0, 300));
  const { status, err } = report(folder);
  assert.equal(status, 0);
  assert.match(err, /line 3: the run was cut off/);
  assert.match(index_of(join(folder, "report.html")), /the run was cut off/);
});

test("a last line without its line break is a record all the same", () => {
  const folder = make_run(good.trimEnd());
  const { err } = report(folder);
  assert.equal(err, "");
});

test("broken lines are named and left out", () => {
  const bad = [
    { ...record(), checks: undefined },
    { ...record(), verdict: "maybe" },
    { ...record(), cost: { ...record().cost, steps: -1 } },
    { ...record(), series: [{ name: "", unit: "", x_name: "", x_unit: "", x: [1], y: [] }] },
    [],
    null,
    7,
  ];
  const { status, err } = report(make_run(good + lines_of(bad)));
  assert.equal(status, 0);
  assert.match(err, /line 3: checks: the required field is missing/);
  assert.match(err, /line 4: verdict: unknown word "maybe"/);
  assert.match(err, /line 5: cost\.steps: expected a whole number/);
  assert.match(err, /line 6: series\[0\]: has not as many x as y/);
  assert.match(err, /line 7: expected an object/);
});

test("a fault deep in a record is named by its path", () => {
  const checks = [record().checks[0], { ...record().checks[0], value: "7" }];
  assert.match(
    report(make_run(good + lines_of([record({ checks })]))).err,
    /line 3: checks\[1\]\.value: expected a number/,
  );
});

test("fields that a reader does not know, and missing ones that it need not, are no fault", () => {
  const { title, error, notes, series, state_hash, settings, ...rest } = record();
  assert.equal(report(make_run(lines_of([{ ...rest, later: { x: 1 } }]))).err, "");
});

test("of several runs a broken one is left out", () => {
  const { status, err } = report(make_run(good), make_run(""));
  assert.equal(status, 0);
  assert.match(err, /is empty/);
});

test("a recording that is missing, broken or outside the run is left out", () => {
  const folder = make_run(
    lines_of(
      ["frames/none.bin", "frames/bad.bin", "../box.bin", "/etc/passwd"].map((frames, i) =>
        record({ case: `case ${i}`, frames }),
      ),
    ),
  );
  mkdirSync(join(folder, "frames"), { recursive: true });
  writeFileSync(join(folder, "frames", "bad.bin"), "STFR but cut off");
  const { status, err } = report(folder);
  assert.equal(status, 0);
  assert.match(err, /none\.bin is missing/);
  assert.match(err, /bad\.bin cannot be read/);
  assert.match(err, /box\.bin stands outside/);
  assert.match(err, /passwd stands outside/);
});

test("the size limit leaves out what is largest and says so", () => {
  const big = Array.from({ length: 400 }, (_, i) =>
    record({
      case: `big/${i}`,
      series: [
        {
          name: "noise",
          unit: "1",
          x_name: "time",
          x_unit: "s",
          x: Array.from({ length: 300 }, (_, k) => k),
          y: Array.from({ length: 300 }, (_, k) => Math.sin(i * 1000 + k * k)),
        },
      ],
    }),
  );
  const folder = make_run(lines_of(big));
  const { err, out } = report(folder, "--limit", "1.0");
  assert.match(err, /were left out, largest first/);
  const megabytes = Number(/\(([\d.]+) MB\)/.exec(out)[1]);
  assert.ok(megabytes <= 1.0, out);
});

test("each plot becomes an SVG file", () => {
  const folder = make_run(lines_of(varied_records()));
  const svg = join(folder, "plots");
  const { status, out } = report(folder, "--svg", svg);
  assert.equal(status, 0);
  const files = readdirSync(svg);
  assert.match(out, new RegExp(`Plots: ${files.length} SVG files`));
  for (const kind of [
    "work-precision",
    "series",
    "convergence",
    "scaling",
    "threshold",
    "prediction",
    "work-precision",
    "phases",
  ]) {
    const name = files.find((file) => file.includes(kind));
    assert.ok(name, `no ${kind} plot`);
    const text = readFileSync(join(svg, name), "utf8");
    assert.match(text, /^<svg /);
    assert.match(text, /<path[^>]* d="M/);
    assert.doesNotMatch(text, /NaN|undefined|\$[a-z]/);
  }
});

test("SVG files of hostile names are plain files with escaped text", () => {
  const folder = make_run(
    lines_of([
      record({
        case: `../../x/${HOSTILE}`,
        series: [{ name: HOSTILE, unit: "m", x_name: "time", x_unit: "s", x: [1, 2], y: [1, 2] }],
      }),
    ]),
  );
  report(folder, "--svg", join(folder, "plots"));
  for (const name of readdirSync(join(folder, "plots"))) {
    assert.match(name, /^[\w.=-]+\.svg$/);
    assert.doesNotMatch(readFileSync(join(folder, "plots", name), "utf8"), /<(script|img)/);
  }
});

test("the policy forbids everything but the page's own scripts and style", () => {
  const html = readFileSync(make_page(make_run(good)), "utf8");
  const policy = /Content-Security-Policy" content="([^"]+)"/.exec(html)[1];
  assert.match(policy, /default-src 'none'/);
  assert.doesNotMatch(policy, /unsafe|http|connect-src|\*/);
  assert.doesNotMatch(
    html.replace(/<script type="text\/plain"[^]*?<\/script>/g, ""),
    /(src|href)="(?!data:)/,
  );
});

test("half a band is named", () => {
  const half = record({ checks: [check({ band: [0.1] })] });
  const old_half = old_record({ checks: [old_check({ expected_low: 0.1 })] });
  const { err } = report(make_run(lines_of([record(), half, old_half])));
  assert.match(err, /line 2: checks\[0\]\.band: expected 2 numbers/);
  assert.match(err, /line 3: checks\[0\]\.band\[1\]: expected a number/);
});
