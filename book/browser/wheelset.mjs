// The explorer of a wheelset: it follows the pointer and the keyboard, its exact forces are the command's, its link
// holds the state, on a phone, dark and light; and the time of its frames.

import { execFileSync } from "node:child_process";
import { existsSync, readdirSync, statSync, writeFileSync } from "node:fs";
import path from "node:path";

// The same iterations in other arithmetic, without a fused multiply and add: they end after the same steps, 1e-8 of mu N
// apart in these cases. One step more or less would be 1e-4.
const TOLERANCE = 1e-6;
const LARGEST_PAGE = 1_700_000; // bytes of the engine, the scripts and the style
// Of mu N: on its own 132 cases FASTSIM errs by 3.5 % as a root mean square; this is three times that.
const LARGEST_DIFFERENCE = 0.105;
const CASES = {
  straight: "",
  curve: "#y=6.4&yaw=3&curvature=-2.5&speed=15",
  "two-point": "#wheel=cone-1%3A20&inclination=20&y=6.25",
  light: "#load=50&mu=0.1&y=-4&yaw=-1&resolution=fast",
};
const SCREENS = {
  "straight-light": { colorScheme: "light", hash: CASES.straight },
  "curve-dark": { colorScheme: "dark", hash: `${CASES.curve}&colour=traction` },
  "two-point-light": { colorScheme: "light", hash: `${CASES["two-point"]}&colour=pressure` },
  "curve-phone": {
    colorScheme: "light", hash: CASES.curve,
    viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, isMobile: true, hasTouch: true,
  },
};

export async function wheelset(place) {
  if (!existsSync(path.join(place.site, "wheelset-explorer/engine-wasm.js"))) {
    console.log("the explorer of a wheelset was left out, and is not tested");
    return [];
  }
  const faults = [...size(place)];
  for (const check of [drag, file, forces, link, screens, frames]) faults.push(...(await check(place)));
  return faults.map((fault) => `explorer of a wheelset: ${fault}`);
}

function size({ site }) {
  const bytes = ["wheelset-explorer", "explorer"]
    .flatMap((folder) => readdirSync(path.join(site, folder)).map((name) => path.join(site, folder, name)))
    .filter((name) => !name.endsWith(path.join("/explorer", "engine-wasm.js")))
    .reduce((sum, name) => sum + statSync(name).size, 0);
  console.log(`explorer of a wheelset: ${(bytes / 1e6).toFixed(2)} MB`);
  return bytes < LARGEST_PAGE ? [] : [`${bytes} bytes`];
}

async function opened(place, options) {
  const page = await place.open("wheelset-explorer.html", options);
  await page.waitForFunction(() => window.explorer, null, { timeout: 60_000 });
  await whole(page);
  return page;
}

const whole = (page) => page.waitForFunction(() => document.body.dataset.explorer === "whole", null, { timeout: 120_000 });
const failure = (page) => page.$eval("#failure", (words) => words.textContent);
const shown = (page) => page.evaluate(() => window.explorer.answer.wheels.map(({ force }) => force));

// The pointer moves the wheelset to scale; arrow keys move and turn it.
async function drag(place) {
  const page = await opened(place, { hash: "#y=0" }), faults = [];
  const box = await (await page.$("#front")).boundingBox();
  const before = await shown(page);
  await page.mouse.move(box.x + 100, box.y + 100);
  await page.mouse.down();
  await page.mouse.move(box.x + 115, box.y + 100, { steps: 5 });
  await page.mouse.up();
  await whole(page);
  const [y, scale] = await page.evaluate(() => [window.explorer.state.y, window.explorer.front.scale]);
  if (Math.abs(y - (15 / scale) * 1e3) > 0.006) faults.push(`15 pixels move it by ${y} mm`);
  const after = await shown(page);
  if (!(after[0][0] > before[0][0] + 1000)) faults.push(`the left wheel's force goes from ${before[0]} to ${after[0]}`);
  await page.focus("#front");
  for (let k = 0; k < 10; k++) await page.keyboard.press("ArrowDown");
  await whole(page);
  const yaw = await page.evaluate(() => window.explorer.state.yaw);
  if (Math.abs(yaw - 1) > 1e-9) faults.push(`ten arrows turn it to ${yaw} mrad`);
  if (await failure(page)) faults.push(await failure(page));
  await page.context().close();
  return faults;
}

// A wheel's own file; and one that is none, which leaves words.
async function file(place) {
  const page = await opened(place, {}), faults = [];
  const cone = path.join(place.pictures, "cone.txt"), none = path.join(place.pictures, "none.txt");
  const points = [];
  for (let k = -60; k <= 40; k++) {
    const y = k, z = y < -35 ? 0.05 * 35 + Math.min(28, 0.12 * (y + 35) ** 2) : -0.05 * y;
    points.push(`${y} ${z}`);
  }
  writeFileSync(cone, points.join("\n"));
  writeFileSync(none, "no profile at all\n");
  const taken = (role, name) => page.waitForFunction(([role, name]) => window.explorer.state[role] === name, [role, name]);
  await page.setInputFiles("#wheel-file", cone);
  await taken("wheel", "cone.txt");
  await whole(page);
  const conicity = Number(await page.$eval("#conicity", (words) => words.textContent));
  if (Math.abs(conicity - 0.05) > 2e-3) faults.push(`a cone 1:20 has the conicity ${conicity}: ${await failure(page)}`);
  await page.setInputFiles("#rail-file", none);
  await taken("rail", "none.txt");
  await whole(page);
  if (!(await failure(page))) faults.push("a file that is no profile is taken");
  await page.selectOption("#rail", "UIC60");
  await whole(page);
  if (await failure(page)) faults.push(`after a wrong file: ${await failure(page)}`);
  await page.context().close();
  return faults;
}

// Exact forces at several cases, against the command that solves the file which the page offers.
async function forces(place) {
  const faults = [];
  let largest = 0;
  for (const [name, hash] of Object.entries(CASES)) {
    const page = await opened(place, { hash });
    const downloading = page.waitForEvent("download");
    await page.click("#download");
    const file = path.join(place.pictures, "wheelset.toml");
    await (await downloading).saveAs(file);
    const solved = JSON.parse(execFileSync(place.creepage, ["wheelset", file, "--json"], { encoding: "utf8" }));
    const said = (await page.$$eval("#cautions li", (all) => all.map((item) => item.textContent))).join("; ");
    if (said !== (solved.caution ?? "")) faults.push(`${name}: cautions are "${said}" here, "${solved.caution}" by the command`);
    const mu = await page.evaluate(() => window.explorer.state.mu);
    for (const [k, force] of (await shown(page)).entries()) {
      const { longitudinal_n: x, lateral_n: y, vertical_n: z } = solved[["left", "right"][k]].force;
      const there = [x, y, z];
      for (const [part, axis] of ["x", "y", "z"].entries()) {
        const apart = Math.abs(force[part] - there[part]) / (mu * there[2]);
        largest = Math.max(largest, apart);
        if (!(apart < TOLERANCE)) faults.push(`${name}: F_${axis} of wheel ${k} is ${force[part]} here, ${there[part]} by the command`);
      }
    }
    await page.context().close();
  }
  console.log(`explorer of a wheelset: exact forces of ${Object.keys(CASES).length} cases differ by at most ${largest.toExponential(1)} of mu N from the command's`);
  return faults;
}

async function link(place) {
  const page = await opened(place, { hash: "#y=4&yaw=-2" });
  await page.fill("#mu", "0.2");
  await whole(page);
  const hash = await page.evaluate(() => location.hash);
  const again = await opened(place, { hash });
  const [one, other] = [await shown(page), await shown(again)];
  await page.context().close();
  await again.context().close();
  return JSON.stringify(one) === JSON.stringify(other) ? [] : [`the link ${hash} gives ${other} in place of ${one}`];
}

async function screens(place) {
  const faults = [];
  for (const [name, options] of Object.entries(SCREENS)) {
    const page = await opened(place, options);
    if (await failure(page)) faults.push(`${name}: ${await failure(page)}`);
    await page.screenshot({ path: path.join(place.pictures, `wheelset-${name}.png`), fullPage: true });
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
    if (wide > 0) faults.push(`${name}: ${wide} pixels too wide`);
    await page.context().close();
  }
  return faults;
}

// Time from a change to its picture; frames a second while the wheelset follows a pointer to and fro, which moves by
// `step` (mm) sixty times a second: a pixel is .3 mm. At rest the time of the full theory, and how far FASTSIM
// is off.
async function frames(place) {
  const faults = [];
  for (const [name, hash] of Object.entries({ tread: "#y=1", flange: "#y=6.4&yaw=3" })) {
    for (const step of [0.02, 0.3]) {
      const page = await opened(place, { hash });
      const [times, perSecond] = await page.evaluate(async (step) => {
        const { explorer } = window, draw = explorer.draw.bind(explorer), from = explorer.state.y;
        let drawn = () => {};
        explorer.draw = () => {
          draw();
          drawn();
        };
        const aside = (k) => 5 - Math.abs(((k + 5) % 20) - 10);
        const moved = (k) => explorer.set({ y: Number((from - step * aside(k)).toFixed(2)) });
        const times = [];
        for (let k = 1; k <= 20; k++) {
          const start = performance.now();
          await new Promise((done) => {
            drawn = done;
            moved(k);
          });
          times.push(performance.now() - start);
        }
        let [count, k] = [0, 0];
        drawn = () => count++;
        const start = performance.now();
        await new Promise((done) => {
          const timer = setInterval(() => {
            if (performance.now() - start < 2000) return moved(++k);
            clearInterval(timer);
            done();
          }, 1000 / 60);
        });
        const perSecond = (1000 * count) / (performance.now() - start);
        drawn = () => {};
        return [times.sort((a, b) => a - b), perSecond];
      }, step);
      await whole(page);
      await page.waitForFunction(() => Number.isFinite(window.explorer.off()), null, { timeout: 60_000 });
      const [exact, off] = await page.evaluate(() => [window.explorer.answer.time, window.explorer.off()]);
      console.log(`explorer of a wheelset: on the ${name} in steps of ${step} mm a frame takes ${times[10].toFixed(0)} ms, ` +
        `${perSecond.toFixed(0)} frames a second; the full theory ${exact.toFixed(0)} ms, ${(100 * off).toFixed(2)} % of mu N away`);
      if (!(off < LARGEST_DIFFERENCE)) faults.push(`FASTSIM is ${off} of mu N off on the ${name}`);
      await page.context().close();
    }
  }
  return faults;
}
