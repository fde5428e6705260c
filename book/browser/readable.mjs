// Every page by axe: contrast, names of what can be pressed, order of headings, keyboard, dark and light.

import { readdirSync } from "node:fs";

const ALL = { type: "tag", values: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa"] };
// What depends on the colour scheme.
const COLOURS = { type: "rule", values: ["color-contrast", "link-in-text-block"] };

export async function readable(place) {
  const faults = [], names = readdirSync(place.site, { recursive: true })
    .filter((name) => name.endsWith(".html") && !name.startsWith("reference"));
  const page = await place.open("index.html");
  for (const name of names) {
    await page.goto(place.address(name), { waitUntil: "domcontentloaded" });
    await page.addScriptTag({ path: place.axe });
    const looked = { light: await look(page, "default", ALL), dark: await look(page, "slate", COLOURS) };
    for (const [scheme, violations] of Object.entries(looked)) {
      for (const { id, nodes } of violations) {
        const where = nodes.slice(0, 3).map(({ target }) => target.join(" ")).join("; ");
        faults.push(`${name}, ${scheme}: ${id}, ${nodes.length} times: ${where}`);
      }
    }
  }
  await page.context().close();
  console.log(`axe: ${names.length} pages in light and dark, ${faults.length} faults`);
  return faults;
}

// What axe finds in one of the colour schemes, without the change from one to the other.
function look(page, scheme, rules) {
  return page.evaluate(async ([scheme, rules]) => {
    document.head.insertAdjacentHTML("beforeend", "<style>* { transition: none !important }</style>");
    document.body.dataset.mdColorScheme = scheme;
    return (await axe.run({ runOnly: rules })).violations;
  }, [scheme, rules]);
}
