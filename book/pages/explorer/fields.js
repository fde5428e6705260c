// What can be set of bodies that touch in an ellipse.
"use strict";

// Numbers of the state: name, unit, range of the slider, and whether the slider is logarithmic. What
// has no range is typed only.
const FIELDS = {
  ab: { name: "a/b, along over across", range: [0.1, 10], logarithmic: true },
  poisson: { name: "Poisson's ratio", range: [0, 0.5], step: 0.01 },
  xi: { name: "longitudinal, ξ", range: [-3, 3], step: 0.01 },
  eta: { name: "lateral, η", range: [-3, 3], step: 0.01 },
  chi: { name: "spin, χ", range: [-5, 5], step: 0.01 },
  N: { name: "load", unit: "N", range: [10, 1e6], logarithmic: true },
  mu: { name: "friction", range: [0.01, 1], step: 0.01 },
  G1: { name: "upper body: shear modulus", unit: "GPa" },
  s1: { name: "Poisson's ratio" },
  rx1: { name: "radius along", unit: "m, or flat" },
  ry1: { name: "radius across", unit: "m, or flat" },
  G2: { name: "lower body: shear modulus", unit: "GPa" },
  s2: { name: "Poisson's ratio" },
  rx2: { name: "radius along", unit: "m, or flat" },
  ry2: { name: "radius across", unit: "m, or flat" },
  ux: { name: "longitudinal" },
  uy: { name: "lateral" },
  phi: { name: "spin", unit: "rad/m" },
};
const CONTACT_FIELDS = {
  plain: ["ab", "poisson"],
  si: ["N", "mu", "G1", "s1", "rx1", "ry1", "G2", "s2", "rx2", "ry2"],
};
