// Renders every formula of a site where it stands: those of the guide, and the `math` blocks of the
// library's reference. A formula that KaTeX does not take ends the build.
//
//     node book/formulas.mjs KATEX SITE

import fs from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

const [katexDirectory, site] = process.argv.slice(2);
const { default: katex } = await import(pathToFileURL(path.resolve(katexDirectory, "dist/katex.mjs")));

const FORMS = [
  [/<(span|div) class="arithmatex">\\\(([^]*?)\\\)<\/\1>/g, false],
  [/<(span|div) class="arithmatex">\\\[([^]*?)\\\]<\/\1>/g, true],
  [/<(pre) class="language-math">(?:<code>)?([^]*?)(?:<\/code>)?<\/pre>/g, true],
];
const ENTITIES = { amp: "&", lt: "<", gt: ">", quot: '"', "#39": "'", "#x27": "'" };

function tex(html) {
  return html.replace(/&(amp|lt|gt|quot|#39|#x27);/g, (_, name) => ENTITIES[name]);
}

function render(html, displayMode) {
  const options = { displayMode, throwOnError: true, strict: "error" };
  const formula = katex.renderToString(tex(html), options);
  return displayMode ? `<div class="formula" tabindex="0">${formula}</div>` : formula;
}

function page(file) {
  const before = fs.readFileSync(file, "utf8");
  let after = before;
  for (const [form, displayMode] of FORMS) {
    after = after.replace(form, (_, tag, formula) => render(formula, displayMode));
  }
  if (after === before) return 0;
  const style = path.posix.relative(path.dirname(file), path.join(site, "katex/katex.min.css"));
  fs.writeFileSync(file, after.replace("</head>", `<link rel="stylesheet" href="${style}"></head>`));
  return 1;
}

let pages = 0;
for (const file of fs.readdirSync(site, { recursive: true })) {
  if (!file.endsWith(".html")) continue;
  try {
    pages += page(path.join(site, file));
  } catch (error) {
    console.error(`${file}: ${error.message}`);
    process.exit(1);
  }
}
console.log(`formulas rendered on ${pages} pages`);
