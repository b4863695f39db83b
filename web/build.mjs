// Bundles the page. `node build.mjs` writes it beside the server; `--to FOLDER` writes it elsewhere, to compare.
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const asked = process.argv.indexOf("--to");
const out = asked < 0 ? join(here, "../python/wireprint/window/static") : process.argv[asked + 1];
mkdirSync(out, { recursive: true });

const result = await build({
  absWorkingDir: here,
  entryPoints: ["src/main.tsx"],
  outfile: join(out, "studio.js"),
  write: false,
  bundle: true,
  minify: true,
  format: "iife",
  globalName: "made",
  loader: { ".css": "text" },
  target: "es2022",
  jsx: "automatic",
  jsxImportSource: "preact",
  legalComments: "none",
  metafile: true,
  logLevel: "warning",
});

// What a page shows is the state of its modules, and a notebook may have several views of one widget, which import
// this once: so each page runs the program anew.
writeFileSync(
  join(out, "studio.js"),
  `function program() {${result.outputFiles[0].text}return made;}
const own = document.querySelector("[data-wireprint]");
if (own) program().start(own);
export default { render: ({ model, el }) => program().widget(model, el) };
`,
);

// The licence of each package that is in the bundle, in the order of their names.
const packages = new Set();
for (const input of Object.keys(result.metafile.inputs)) {
  const found = input.match(/node_modules\/((?:@[^/]+\/)?[^/]+)\//);
  if (found) packages.add(found[1]);
}
const licences = [...packages].sort().map((name) => {
  const folder = join(here, "node_modules", name);
  const { version, license } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
  const text = readFileSync(join(folder, "LICENSE"), "utf8").trim();
  return `${name} ${version} (${license})\n\n${text}\n`;
});
writeFileSync(
  join(out, "licences.txt"),
  `studio.js holds these packages besides wireprint's own code.\n\n${licences.join("\n----\n\n")}`,
);
copyFileSync(join(here, "src/index.html"), join(out, "index.html"));
