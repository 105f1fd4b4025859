// Bundles the two pages, the client's and the status page, and their tests.
//
//   node build.mjs --packages FOLDER --descriptor FILE --page FOLDER --status FOLDER
//     [--tests FOLDER]
//
// packages: holds node_modules, which never lies in the source folder. descriptor: amalgam.proto's,
// as `protoc --descriptor_set_out` writes it. page, status: what the server is to serve, at the web
// port and at the admin port. tests: the tests of tests/web, for `node --test`, and the tools beside
// them.
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
    status: { type: "string" },
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
    "amalgam-status": join(here, "status/source"),
  },
};

/** Bundles a page's sources and puts its other files beside them. */
async function makePage(entries, files, outdir) {
  mkdirSync(outdir, { recursive: true });
  await build({
    ...common,
    entryPoints: entries.map((file) => join(here, file)),
    entryNames: "[name]",
    outdir,
    target: ["chrome107", "firefox110", "safari16.4"],
    minify: true,
    legalComments: "eof",
  });
  cpSync(join(here, files), outdir, { recursive: true });
  cpSync(join(here, "shared/icon.svg"), join(outdir, "icon.svg"));
}

const client = ["main", "worker", "lens_worker", "board_page"].map((name) => `source/${name}.js`);
client.push("source/style.css");
await makePage(client, "page", options.page);
await makePage(["status/source/main.js", "status/source/style.css"], "status/page", options.status);

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
