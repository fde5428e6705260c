// Creep-force curves, a few forces at a time so that the page stays quick.
"use strict";

const POINTS = 65; // a power of two and one: from coarse to fine
const BUDGET = 9; // ms of a frame
const INKS = {
  exact: "#2f7fd6", variational: "#b26bd6", fastrip: "#d14f8f", fastsim: "#e07b20", strip: "#8a9a1a",
  polach: "#1fa083", "shen-hedrick-elkins": "#b08040", "vermeulen-johnson": "#7f8fa6", linear: "#8a8a8a",
  saturated: "#c94c4c",
};

// Places of a curve, the ends first and then ever finer between.
const ORDER = (() => {
  const order = [0, POINTS - 1];
  for (let step = (POINTS - 1) / 2; step >= 1; step /= 2) {
    for (let k = step; k < POINTS - 1; k += 2 * step) order.push(k);
  }
  return order;
})();

class Curves {
  constructor(canvas, engine) {
    this.canvas = canvas;
    this.engine = engine;
    this.key = "";
  }

  // What is to be drawn; forces that are known already are kept.
  want(state, contact, creepage, range) {
    const along = Number(state.along), fixed = creepage.map((part, k) => (k === along ? null : part));
    const names = state.curves.split(",").filter(Boolean);
    const key = JSON.stringify([contact, fixed, range, state.resolution]);
    if (key !== this.key) Object.assign(this, { key, forces: {}, times: {}, failures: {} });
    Object.assign(this, { state, contact, creepage, range, along, names });
  }

  at(k) {
    return this.range * ((2 * k) / (POINTS - 1) - 1);
  }

  // Solves for as long as a frame allows; true when nothing is left.
  advance() {
    const start = performance.now();
    for (const place of ORDER) {
      for (const name of this.names) {
        this.forces[name] ??= new Array(POINTS).fill(undefined);
        if (this.failures[name] || this.forces[name][place] !== undefined) continue;
        this.solve(name, place);
        if (performance.now() - start > BUDGET) return false;
      }
    }
    return true;
  }

  solve(name, place) {
    const creepage = this.creepage.map((part, k) => (k === this.along ? this.at(place) : part));
    const start = performance.now();
    try {
      this.forces[name][place] = this.engine.solve(name, this.state.resolution, creepage).force;
    } catch (error) {
      this.failures[name] = error.message;
      return;
    }
    const time = (this.times[name] ??= { sum: 0, count: 0 });
    // The first force of a theory prepares it.
    if (this.forces[name].filter(Boolean).length > 1) {
      time.sum += performance.now() - start;
      time.count += 1;
    }
  }

  // Mean time of a solution, in words.
  time(name) {
    const { sum, count } = this.times[name] ?? {};
    if (this.failures[name]) return "out of its range";
    if (!count) return "";
    const mean = sum / count;
    return mean >= 0.1 ? `${show(mean)} ms` : `${show(mean * 1e3)} µs`;
  }

  draw(force) {
    const sheet = paper(this.canvas, 0.75, 360);
    const value = (of) => (this.state.force === "f" ? Math.hypot(of.fx, of.fy) : of[this.state.force]);
    const box = { left: 46, right: sheet.width - 14, top: 14, bottom: sheet.height - 44 };
    const low = this.state.force === "f" ? 0 : -1.1;
    const across = (x) => box.left + ((x / this.range + 1) / 2) * (box.right - box.left);
    const up = (y) => box.bottom - ((y - low) / (1.1 - low)) * (box.bottom - box.top);
    this.axes(sheet, box, across, up, low);
    sheet.pen.save();
    sheet.pen.beginPath();
    sheet.pen.rect(box.left, box.top, box.right - box.left, box.bottom - box.top);
    sheet.pen.clip();
    this.names.forEach((name) => this.line(sheet, name, across, up, value));
    sheet.pen.restore();
    this.point(sheet, across(this.creepage[this.along]), up(value(force)), box);
  }

  axes({ pen, ink, faint, width, height }, box, across, up, low) {
    const unit = creepageUnits(this.state, this.contact)[this.along];
    pen.strokeStyle = faint;
    pen.fillStyle = ink;
    pen.lineWidth = 1;
    pen.textAlign = "center";
    for (const tick of ticks(this.range * unit)) {
      rule(pen, [across(tick / unit), box.top], [across(tick / unit), box.bottom]);
      pen.fillText(String(tick), across(tick / unit), box.bottom + 17);
    }
    pen.textAlign = "right";
    for (const tick of low < 0 ? [-1, -0.5, 0, 0.5, 1] : [0, 0.25, 0.5, 0.75, 1]) {
      rule(pen, [box.left, up(tick)], [box.right, up(tick)]);
      pen.fillText(String(tick), box.left - 6, up(tick) + 5);
    }
    pen.textAlign = "center";
    const { name, unit: words } = FIELDS[CREEPAGES[this.state.units][this.along]];
    pen.fillText(words ? `${name} (${words})` : name, (box.left + box.right) / 2, height - 8);
  }

  line({ pen }, name, across, up, value) {
    pen.strokeStyle = INKS[name];
    pen.lineWidth = 2.2;
    pen.setLineDash(dashes(name));
    pen.beginPath();
    (this.forces[name] ?? []).forEach((force, k) => {
      if (force) pen.lineTo(across(this.at(k)), up(value(force)));
    });
    pen.stroke();
    pen.setLineDash([]);
  }

  point({ pen, strong, faint }, x, y, box) {
    pen.strokeStyle = strong;
    pen.setLineDash([2, 3]);
    rule(pen, [x, box.top], [x, box.bottom]);
    pen.setLineDash([]);
    pen.fillStyle = strong;
    pen.beginPath();
    pen.arc(x, Math.min(Math.max(y, box.top), box.bottom), 5, 0, 2 * Math.PI);
    pen.fill();
  }
}

const DASHES = [[9, 4], [3, 3], [12, 4, 3, 4], [6, 6]];

function dashes(name) {
  return name === "exact" ? [] : DASHES[Object.keys(INKS).indexOf(name) % DASHES.length];
}

// A piece of a theory's line, for the list of theories.
function sample(name) {
  return `<svg width="34" height="8" aria-hidden="true"><path d="M1 4H33" stroke="${INKS[name]}"` +
    ` stroke-width="2.4" stroke-dasharray="${dashes(name).join(" ")}"/></svg>`;
}
