// Bundles the page and its tests.
//
//   node build.mjs --packages FOLDER --descriptor FILE --page FOLDER [--tests FOLDER]
//
// packages: holds node_modules, which never lies in the source folder. descriptor: amalgam.proto's,
// as `protoc --descriptor_set_out` writes it. page: what the server is to serve. tests: the tests
// of tests/web, for `node --test`, and the tools beside them.
import { cpSync, mkdirSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";

const here = dirname(fileURLToPath(import.meta.url));
const testFolder = resolve(here, "../../tests/web");

const { values: options } = parseArgs({
  options: {
    packages: { type: "string" },
    descriptor: { type: "string" },
    page: { type: "string" },
    tests: { type: "string" },
  },
});
const packages = resolve(options.packages);
const { build } = createRequire(join(packages, "package.json"))("esbuild");

const common = {
  bundle: true,
  format: "esm",
  logLevel: "warning",
  nodePaths: [join(packages, "node_modules")],
  loader: { ".binpb": "binary" },
  alias: {
    "amalgam.binpb": resolve(options.descriptor),
    "amalgam-page": join(here, "source"),
  },
};

mkdirSync(options.page, { recursive: true });
await build({
  ...common,
  entryPoints: ["main", "worker", "lens_worker", "board_page"].map((name) =>
    join(here, `source/${name}.js`),
  ),
  entryNames: "[name]",
  outdir: options.page,
  target: ["chrome107", "firefox110", "safari16.4"],
  minify: true,
  legalComments: "eof",
});
cpSync(join(here, "page"), options.page, { recursive: true });

if (options.tests) {
  const tests = readdirSync(testFolder, { recursive: true }).filter(
    (file) => file.endsWith(".test.js") || file.startsWith("tools/"),
  );
  await build({
    ...common,
    platform: "node",
    target: "node18",
    entryPoints: tests.map((file) => join(testFolder, file)),
    outbase: testFolder,
    outdir: options.tests,
    outExtension: { ".js": ".mjs" },
    // These find files of their own beside themselves.
    external: ["playwright-core", "ws"],
  });
}
