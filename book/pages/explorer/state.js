// What the page shows, its defaults, and the link that holds it.
"use strict";

const DEFAULTS = {
  units: "plain",
  ab: 1.33, poisson: 0.28, xi: -0.8, eta: 0, chi: 0,
  // The upper body is 1, the lower 2: shear modulus in GPa, Poisson's ratio, radii along and across.
  G1: 82, s1: 0.28, rx1: 0.46, ry1: Infinity,
  G2: 82, s2: 0.28, rx2: Infinity, ry2: 0.3,
  N: 80e3, mu: 0.3, ux: -1.5e-3, uy: 0, phi: 0,
  theory: "exact", resolution: "standard", colour: "areas",
  curves: "exact,fastsim,linear", force: "f", along: "0",
};

const BALL = {
  units: "si", G1: 80, s1: 0.3, rx1: 6.35e-3, ry1: 6.35e-3,
  G2: 80, s2: 0.3, rx2: 24.7e-3, ry2: -6.604e-3, N: 200, mu: 0.1,
};
const PRESETS = {
  "a driven wheel": { units: "si" },
  "a wheel in a curve": { units: "si", ux: 0, uy: 2e-3, phi: 0.19, along: "1", force: "fy" },
  "a ball in a bearing": { ...BALL, ux: 0, phi: 9, along: "2", force: "fy" },
  "a circle, longitudinal creepage": { ab: 1 },
  "a circle in pure spin": { ab: 1, xi: 0, chi: 2, along: "2", force: "fy" },
  "a slender ellipse across": { ab: 0.2, xi: 0.7, chi: 0.3, curves: "exact,strip,fastsim" },
};

const CREEPAGES = { plain: ["xi", "eta", "chi"], si: ["ux", "uy", "phi"] };
const WORDS = new Set(["units", "theory", "resolution", "colour", "curves", "force", "along"]);
const CHOICES = {
  units: ["plain", "si"],
  resolution: RESOLUTIONS,
  colour: ["areas", "traction", "pressure", "slip"],
  force: ["f", "fx", "fy", "mz"],
  along: ["0", "1", "2"],
};

// The state of a link; what it leaves out, or what makes no sense, is the default.
function fromLink(hash, theories) {
  const state = { ...DEFAULTS };
  const known = { ...CHOICES, theory: theories };
  for (const [key, text] of new URLSearchParams(hash.replace(/^#/, ""))) {
    if (!Object.hasOwn(DEFAULTS, key)) continue;
    if (!WORDS.has(key)) {
      const number = readNumber(text);
      if (!Number.isNaN(number)) state[key] = number;
    } else if (key === "curves") {
      state.curves = text.split(",").filter((name) => theories.includes(name)).join(",");
    } else if (known[key].includes(text)) {
      state[key] = text;
    }
  }
  return state;
}

function toLink(state) {
  const link = new URLSearchParams();
  for (const key of Object.keys(DEFAULTS)) {
    if (state[key] !== DEFAULTS[key]) link.set(key, writeNumber(state[key]));
  }
  return "#" + link.toString().replaceAll("%2C", ",");
}

// xi, eta, chi of the state in the units of its contact: the same three divisions as the command's.
function creepage(state, units) {
  const [x, y, spin] = CREEPAGES[state.units].map((key) => state[key]);
  if (state.units === "plain") return [x, y, spin];
  return [x / units.slip, y / units.slip, (spin * units.length) / units.slip];
}

// How much one of xi, eta, chi is in the units that the state is given in.
function creepageUnits(state, units) {
  if (state.units === "plain") return [1, 1, 1];
  return [units.slip, units.slip, units.slip / units.length];
}
