// Looks at a built guide with a browser, Chromium without a window and without a network.
//
//     node book/browser/run.mjs SITE CREEPAGE CHROMIUM PLAYWRIGHT AXE [explorer | wheelset | search | readable]

import { mkdirSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { pathToFileURL } from "node:url";

import { explorer } from "./explorer.mjs";
import { readable } from "./readable.mjs";
import { search } from "./search.mjs";
import { wheelset } from "./wheelset.mjs";

const [site, creepage, executablePath, playwright, axe] = process.argv.slice(2, 7).map((name) => path.resolve(name));
const only = process.argv[7];
const { chromium } = createRequire(import.meta.url)(playwright);

const browser = await chromium.launch({ executablePath, args: ["--no-sandbox", "--disable-gpu"] });
const pictures = path.join(path.dirname(site), "book-screens");
mkdirSync(pictures, { recursive: true });
const faults = [];
const place = {
  site,
  creepage,
  pictures,
  axe: path.join(axe, "axe.min.js"),
  address: (page, hash = "") => pathToFileURL(path.join(site, page)).href + hash,
  // A page of its own, which tells of what goes wrong in it.
  async open(page, { hash = "", ...options } = {}) {
    const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, offline: true, ...options });
    const opened = await context.newPage();
    opened.on("pageerror", (error) => faults.push(`${page}: ${error.message}`));
    await opened.goto(place.address(page, hash));
    return opened;
  },
};
try {
  for (const look of [explorer, wheelset, search, readable].filter(({ name }) => !only || name === only)) faults.push(...(await look(place)));
} catch (error) {
  faults.push(error.stack);
} finally {
  await browser.close();
}
for (const fault of faults) console.log(fault);
console.log(`in the browser: ${faults.length} faults`);
process.exit(faults.length ? 1 : 0);
