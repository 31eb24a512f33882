#!/usr/bin/env node
// SPDX-License-Identifier: GPL-3.0-or-later
// Sets up and bundles the report program: node reports/web/build.mjs [--tests]
// Everything it makes is in build/web (or $STICTION_WEB_BUILD): the installed packages, the page's
// bundles and report.mjs, which needs nothing beside that folder. Does nothing when up to date.
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import {
  copyFileSync,
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  writeFileSync,
} from "node:fs";
import { createRequire } from "node:module";
import { dirname, join, relative, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const source = dirname(fileURLToPath(import.meta.url));
export const build = resolve(process.env.STICTION_WEB_BUILD ?? join(source, "../../build/web"));

const PACKAGE_FILES = ["package.json", "package-lock.json", ".npmrc"];

function hash_of(files, extra = "") {
  const hash = createHash("sha256").update(extra);
  for (const file of files)
    hash.update(relative(source, file)).update("\0").update(readFileSync(file));
  return hash.digest("hex");
}

function is_stamped(stamp, value) {
  const file = join(build, stamp);
  return existsSync(file) && readFileSync(file, "utf8") === value;
}

// Copies the package files and runs npm ci there, so that node_modules is never in the source tree.
function install(with_tests) {
  const files = PACKAGE_FILES.map((name) => join(source, name));
  const wanted = hash_of(files);
  if (is_stamped("installed-with-tests", wanted)) return;
  if (!with_tests && is_stamped("installed", wanted)) return;
  mkdirSync(build, { recursive: true });
  for (const name of PACKAGE_FILES) copyFileSync(join(source, name), join(build, name));
  console.error(`stiction report: installing npm packages in ${build}`);
  const args = ["ci", "--ignore-scripts", "--loglevel=error"];
  if (!with_tests) args.push("--omit=dev");
  try {
    execFileSync("npm", args, { cwd: build, stdio: ["ignore", "ignore", "inherit"] });
  } catch {
    throw new Error(`npm could not install the packages; run \`npm ci\` in ${build} to see why`);
  }
  writeFileSync(join(build, with_tests ? "installed-with-tests" : "installed"), wanted);
}

function sources_in(folder) {
  return readdirSync(folder, { withFileTypes: true })
    .filter((entry) => entry.name !== "test")
    .flatMap((entry) => {
      const path = join(folder, entry.name);
      return entry.isDirectory() ? sources_in(path) : [path];
    })
    .sort();
}

// The packages whose code is in the bundles, with their licence texts.
function licences_of(metafiles) {
  const folders = new Set();
  for (const { inputs } of metafiles) {
    for (const input of Object.keys(inputs)) {
      const found = /^(.*node_modules\/(?:@[^/]+\/)?[^/]+)\//.exec(input);
      if (found) folders.add(found[1]);
    }
  }
  const packages = [...folders].sort().map((folder) => {
    const description = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
    const file = readdirSync(folder).find((name) => /^(licen[cs]e|copying)/i.test(name));
    return {
      name: description.name,
      version: description.version,
      licence: typeof description.license === "string" ? description.license : "see text",
      text: file ? readFileSync(join(folder, file), "utf8").trim() : "",
    };
  });
  const unique = new Map(packages.map((one) => [`${one.name}@${one.version}`, one]));
  return [...unique.values()].sort((a, b) => (a.name < b.name ? -1 : 1));
}

async function bundle() {
  const wanted = hash_of([...sources_in(source), join(source, "../record/schema.json")]);
  if (is_stamped("bundled", wanted)) return;
  const esbuild = createRequire(join(build, "package.json"))("esbuild");
  const common = {
    absWorkingDir: build,
    bundle: true,
    charset: "ascii",
    legalComments: "none",
    logLevel: "warning",
    metafile: true,
    minify: true,
    nodePaths: [join(build, "node_modules")],
  };
  const in_page = (entry, name) =>
    esbuild.build({
      ...common,
      entryPoints: [join(source, entry)],
      format: "iife",
      target: ["chrome100", "firefox113", "safari16.4"],
      outfile: join(build, "bundle", name),
    });
  const results = await Promise.all([
    in_page("page/main.js", "page.js"),
    in_page("page/widgets/plot_code.js", "plot.js"),
    in_page("player/player.js", "player.js"),
    in_page("style/page.css", "page.css"),
    in_page("style/manual.css", "manual.css"),
    esbuild.build({
      ...common,
      minify: false,
      entryPoints: [join(source, "report.mjs")],
      format: "esm",
      platform: "node",
      target: "node18",
      banner: { js: "#!/usr/bin/env node" },
      outfile: join(build, "report.mjs"),
    }),
  ]);
  const licences = licences_of(
    results
      .slice(0, 5)
      .map((result) => result.metafile)
      .map(absolute),
  );
  writeFileSync(join(build, "bundle", "licences.json"), JSON.stringify(licences));
  writeFileSync(join(build, "bundled"), wanted);
}

function absolute(metafile) {
  const inputs = Object.fromEntries(
    Object.entries(metafile.inputs).map(([path, value]) => [resolve(build, path), value]),
  );
  return { inputs };
}

try {
  install(process.argv.includes("--tests"));
  await bundle();
} catch (error) {
  console.error(`stiction report: ${error.message}`);
  process.exit(2);
}
