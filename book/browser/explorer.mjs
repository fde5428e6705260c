// The explorer: its sliders move the force, its forces are the command's, its link holds the state, and it is
// quick, by keyboard, on a phone, dark and light.

import { execFileSync } from "node:child_process";
import { existsSync, readdirSync, readFileSync, statSync } from "node:fs";
import path from "node:path";

// The same iteration in other arithmetic: a browser has no fused multiply and add. The full theory ends at a
// residual of 1e-6, reached in single precision: of 3,000 random cases two arithmetics differed by
// 6e-13 in the middle, 3e-12 in nine of ten and 1.3e-10 at most.
const TOLERANCE = 1e-9;
const LARGEST_PAGE = 1_100_000; // bytes of the engine, the scripts and the style
const CASES = [
  "#ab=1&xi=0&chi=2",
  "#ab=0.2&xi=0.7&eta=-0.1&chi=0.3",
  "#ab=3&poisson=0.4&xi=-0.4&eta=0.9&chi=-1.5&resolution=fast",
  "#units=si",
  "#units=si&ux=0&uy=2e-3&phi=0.19",
  "#units=si&G1=80&s1=0.3&rx1=0.00635&ry1=0.00635&G2=2.6&s2=0.4&rx2=flat&ry2=flat&N=200&mu=0.1&ux=1e-3&phi=9",
];
const SCREENS = {
  light: { colorScheme: "light" },
  dark: { colorScheme: "dark", hash: "#units=si&ux=0&uy=2e-3&phi=0.19&along=1&force=fy&colour=traction" },
  phone: {
    colorScheme: "light", hash: "#ab=1&xi=0&chi=2&along=2&force=fy",
    viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, isMobile: true, hasTouch: true,
  },
};

export async function explorer(place) {
  if (!existsSync(path.join(place.site, "explorer/engine-wasm.js"))) {
    console.log("the explorer was left out, and is not tested");
    return [];
  }
  const faults = [...size(place)];
  for (const check of [slider, forces, link, screens, frames]) faults.push(...(await check(place)));
  return faults.map((fault) => `explorer: ${fault}`);
}

function size({ site }) {
  const folder = path.join(site, "explorer");
  const bytes = readdirSync(folder).reduce((sum, name) => sum + statSync(path.join(folder, name)).size, 0);
  console.log(`explorer: ${(bytes / 1e6).toFixed(2)} MB`);
  return bytes < LARGEST_PAGE ? [] : [`${bytes} bytes`];
}

async function opened(place, options) {
  const page = await place.open("explorer.html", options);
  await page.waitForFunction(() => window.explorer, null, { timeout: 60_000 });
  return page;
}

const whole = (page) => page.waitForFunction(() => document.body.dataset.explorer === "whole", null, { timeout: 120_000 });
const force = (page, name) => page.$eval(`#${name}`, (output) => Number(output.dataset.value));
const settled = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

// By keyboard alone: Tab leads to the slider, an arrow moves it, and the force with it.
async function slider(place) {
  const page = await opened(place, { hash: "#ab=1&xi=-0.5" });
  await whole(page);
  const before = await force(page, "fx");
  await page.focus("#poisson");
  await page.keyboard.press("Tab");
  const faults = [];
  const focused = await page.evaluate(() => document.activeElement.id);
  if (focused !== "xi-slider") faults.push(`Tab leads to ${focused}`);
  for (let k = 0; k < 25; k++) await page.keyboard.press("ArrowLeft");
  await settled(page);
  const typed = Number(await page.inputValue("#xi")), after = await force(page, "fx");
  if (Math.abs(typed + 0.75) > 1e-9) faults.push(`25 arrows lead to xi = ${typed}`);
  if (!(after < before - 0.1)) faults.push(`the force goes from ${before} to ${after}`);
  faults.push(...(await compared(place, page)));
  await page.context().close();
  return faults;
}

// Every theory's force at several cases, against the command that solves the file which the page offers.
async function forces(place) {
  const faults = [];
  let largest = 0;
  for (const hash of CASES) {
    const page = await opened(place, { hash });
    await settled(page);
    for (const theory of await page.$$eval("#theory option", (all) => all.map(({ value }) => value))) {
      await page.selectOption("#theory", theory);
      await settled(page);
      faults.push(...(await compared(place, page, (difference) => (largest = Math.max(largest, difference)))));
    }
    await page.context().close();
  }
  console.log(`explorer: forces of ${CASES.length} cases by every theory differ by at most ${largest.toExponential(1)} from the command's`);
  return faults;
}

async function compared(place, page, note = () => {}) {
  const downloading = page.waitForEvent("download");
  await page.click("#download");
  const file = path.join(place.pictures, "case.toml");
  await (await downloading).saveAs(file);
  const solved = JSON.parse(run(place.creepage, ["solve", file, "--json"]));
  const faults = [];
  for (const name of ["fx", "fy", "mz"]) {
    const [here, there] = [await force(page, name), solved.dimensionless[name]];
    note(Math.abs(here - there));
    if (!(Math.abs(here - there) <= TOLERANCE)) {
      faults.push(`${name} is ${here} here and ${there} by the command, of\n${readFileSync(file, "utf8")}`);
    }
  }
  return faults;
}

// What the command prints; its code 3 says that a solution is in doubt, and the solution is there.
function run(command, words) {
  try {
    return execFileSync(command, words, { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] });
  } catch (error) {
    if (error.status !== 3) throw error;
    return error.stdout;
  }
}

async function link(place) {
  const page = await opened(place, { hash: "#ab=2&eta=0.4&theory=fastsim" });
  await page.fill("#chi", "0.8");
  await settled(page);
  const hash = await page.evaluate(() => location.hash);
  const again = await opened(place, { hash });
  await settled(again);
  const [one, other] = [await force(page, "fy"), await force(again, "fy")];
  await page.context().close();
  await again.context().close();
  return one === other ? [] : [`the link ${hash} gives ${other} in place of ${one}`];
}

async function screens(place) {
  const faults = [];
  for (const [name, options] of Object.entries(SCREENS)) {
    const page = await opened(place, options);
    await whole(page);
    await page.screenshot({ path: path.join(place.pictures, `explorer-${name}.png`), fullPage: true });
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
    if (wide > 0) faults.push(`${name}: ${wide} pixels too wide`);
    await page.context().close();
  }
  return faults;
}

// Time of a frame as the slider moves: solution, picture, a part of the curves.
async function frames(place) {
  for (const resolution of ["fast", "standard"]) {
    const page = await opened(place, { hash: `#ab=1.33&chi=0.3&resolution=${resolution}` });
    await whole(page);
    const times = [];
    for (let k = 0; k < 30; k++) {
      await page.$eval("#xi-slider", (slider, xi) => {
        slider.value = xi;
        slider.dispatchEvent(new Event("input"));
      }, -1 + 0.06 * k);
      await settled(page);
      times.push(await page.evaluate(() => [window.explorer.lastFrame, window.explorer.solveTime]));
    }
    const median = (k) => times.map((time) => time[k]).sort((a, b) => a - b)[15].toFixed(1);
    console.log(`explorer: a frame at ${resolution} takes ${median(0)} ms, of which the solution ${median(1)} ms`);
    await page.context().close();
  }
  return [];
}
