// What the page shows, its defaults, the link that holds it, and the case file.
"use strict";

const FIELDS = {
  y: { name: "to the right, y", unit: "mm", range: [-8, 8], step: 0.01 },
  yaw: { name: "yaw, positive turns the right end back", unit: "mrad", range: [-15, 15], step: 0.05 },
  curvature: { name: "curvature of the track, positive to the right", unit: "1/km", range: [-5, 5], step: 0.02 },
  speed: { name: "speed", unit: "m/s", range: [1, 100], step: 0.5 },
  load: { name: "load of the axle", unit: "kN", range: [20, 350], step: 1 },
  mu: { name: "friction", range: [0.02, 0.8], step: 0.01 },
  radius: { name: "radius of the wheels", unit: "m" },
  back: { name: "between the flange backs", unit: "m" },
  inclination: { name: "rails incline by 1 to, 0 for upright", unit: "1/slope" },
  gauge: { name: "gauge", unit: "m" },
  below: { name: "measured below the rails' top", unit: "m" },
};
const PLACE = ["y", "yaw", "curvature", "speed", "load", "mu"];
const SIZES = ["radius", "back", "inclination", "gauge", "below"];

const DEFAULTS = {
  wheel: "S1002", rail: "UIC60",
  y: 3, yaw: 0, curvature: 0, speed: 20, load: 120, mu: 0.3,
  radius: 0.46, back: 1.36, inclination: 40, gauge: 1.435, below: 0.014,
  resolution: "standard", colour: "areas",
};
const PRESETS = {
  "straight track, off its centre": {},
  "the leading wheelset in a curve": { y: 6.4, yaw: 3, curvature: -2.5, speed: 15 },
  "two-point contact": { wheel: "cone-1:20", inclination: 20, y: 6.25, yaw: 0 },
  "the trailing wheelset": { y: -1.5, yaw: 0.3, curvature: -2.5, speed: 15 },
  "a light wheelset, wet rails": { load: 50, mu: 0.1, y: -4, yaw: -1 },
};
const CHOICES = {
  resolution: ["fast", "standard", "fine"],
  colour: ["areas", "traction", "pressure", "slip"],
};

// The state of a link; what it leaves out, or what makes no sense, is the default. A file's content is in no link.
function fromLink(hash, profiles) {
  const state = { ...DEFAULTS };
  const known = { ...CHOICES };
  for (const role of ["wheel", "rail"]) {
    known[role] = profiles.filter((one) => one.role === role).map(({ name }) => name);
  }
  for (const [key, text] of new URLSearchParams(hash.replace(/^#/, ""))) {
    if (known[key]?.includes(text)) state[key] = text;
    if (FIELDS[key] && Number.isFinite(readNumber(text))) state[key] = readNumber(text);
  }
  return state;
}

function toLink(state) {
  const link = new URLSearchParams();
  for (const key of Object.keys(DEFAULTS)) {
    if (state[key] !== DEFAULTS[key]) link.set(key, String(state[key]));
  }
  return "#" + link.toString();
}

// In the units of the library: m, rad, N.
function si(state) {
  const cant = state.inclination === 0 ? 0 : Math.atan(1 / state.inclination);
  return {
    place: [state.y * 1e-3, state.yaw * 1e-3, state.load * 1e3, state.speed, state.curvature * 1e-3, state.mu],
    sizes: [state.radius, state.back, cant, state.gauge, state.below],
  };
}

// The case as a file of the command.
function caseFile(state) {
  const { place: [y, yaw, load, speed, curvature], sizes: [, , cant] } = si(state);
  const turn = curvature === 0 ? "" : `curvature = ${toml(curvature)}    # positive in a right-hand curve (1/m)\n`;
  return `# From the explorer: creepage wheelset case.toml

[wheel]
profile = ${JSON.stringify(state.wheel)}
radius = ${toml(state.radius)}

[rail]
profile = ${JSON.stringify(state.rail)}
cant = ${toml(cant)}

[track]
gauge = ${toml(state.gauge)}
gauge_height = ${toml(state.below)}
${turn}
[wheelset]
back_to_back = ${toml(state.back)}
y = ${toml(y)}
yaw = ${toml(yaw)}
roll = "free"
axle_load = ${toml(load)}

[motion]
speed = ${toml(speed)}
pitch_rate = "free"

[contact]
friction = ${toml(state.mu)}

[materials]
shear_modulus = 82e9
poisson = 0.28

[solve]
theory = "exact"
resolution = "${state.resolution}"
`;
}
