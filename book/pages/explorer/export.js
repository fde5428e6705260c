// The case as a file of the command, and as Python.
"use strict";

// Semi-axes of a contact that is only known by its ratio: a power of two, so that a/b is kept to the
// last bit.
const SEMI_AXIS_LATERAL = 1 / 128;

function solveSection(state) {
  const lines = ["[solve]", `theory = "${state.theory}"`];
  if (state.theory === "exact") lines.push(`resolution = "${state.resolution}"`);
  return lines;
}

function caseFile(state) {
  const lines = ["# From the explorer: creepage solve case.toml --out out"];
  const section = (name, entries) => {
    lines.push("", `[${name}]`, ...Object.entries(entries).map(([key, value]) => `${key} = ${toml(value)}`));
  };
  if (state.units === "plain") {
    const steel = { shear_modulus: 82e9, poisson: state.poisson };
    lines.push("# a/b, Poisson's ratio and xi, eta, chi are those of the page; sizes and load are any.");
    section("upper", steel);
    section("lower", steel);
    section("contact", {
      normal_force: 80e3, friction: 0.3,
      semi_axis_rolling: state.ab * SEMI_AXIS_LATERAL, semi_axis_lateral: SEMI_AXIS_LATERAL,
    });
    section("creepage", { xi: state.xi, eta: state.eta, chi: state.chi });
  } else {
    for (const [name, k] of [["upper", 1], ["lower", 2]]) {
      section(name, {
        shear_modulus: state["G" + k] * GIGA, poisson: state["s" + k],
        radius_rolling: state["rx" + k], radius_lateral: state["ry" + k],
      });
    }
    section("contact", { normal_force: state.N, friction: state.mu });
    section("creepage", { longitudinal: state.ux, lateral: state.uy, spin: state.phi });
  }
  return [...lines, "", ...solveSection(state), ""].join("\n");
}

function python(state) {
  const options = state.theory === "exact" ? `, resolution="${state.resolution}"` : "";
  if (state.units === "plain") {
    const maker = state.theory.replaceAll("-", "_");
    return [
      "import creepage", "",
      `theory = creepage.${maker}(a_over_b=${state.ab}, poisson=${state.poisson}${options})`,
      `force = theory.force(xi=${state.xi}, eta=${state.eta}, chi=${state.chi})`,
      "print(force.fx, force.fy, force.mz)  # in units of mu N and mu N c",
      "",
    ].join("\n");
  }
  const radius = (name, value) => (value === Infinity ? "" : `, ${name}=${value}`);
  const body = (k) =>
    `creepage.Body(shear_modulus=${state["G" + k] * GIGA}, poisson=${state["s" + k]}` +
    `${radius("radius_rolling", state["rx" + k])}${radius("radius_lateral", state["ry" + k])})`;
  return [
    "import creepage", "",
    `upper = ${body(1)}`, `lower = ${body(2)}`,
    "case = creepage.Case(",
    `    upper=upper, lower=lower, normal_force=${state.N}, friction=${state.mu},`,
    `    longitudinal=${state.ux}, lateral=${state.uy}, spin=${state.phi},`,
    `    theory="${state.theory}"${options},`, ")",
    "print(case.solve().force)  # on the lower body, in N and N m",
    "",
  ].join("\n");
}
