// The page: what is set, what is solved, what is shown.
"use strict";

class Page {
  constructor(engine) {
    this.engine = engine;
    this.picture = new Picture(element("picture"), element("legend"));
    this.curves = new Curves(element("curve"), engine);
    this.names = engine.theories.map(({ name }) => name);
    this.state = fromLink(location.hash, this.names);
    this.fill();
    this.listen();
    this.build();
    this.refresh();
  }

  // The choices that do not depend on the state.
  fill() {
    options("preset", ["", ...Object.keys(PRESETS)], (name) => name || "choose a case");
    options("theory", this.names);
    for (const name of this.names) {
      const label = document.createElement("label");
      label.innerHTML =
        `<input type="checkbox" value="${name}"> ${sample(name)} ` +
        `${name} <small id="time-${name}"></small>`;
      element("curves").append(label);
    }
  }

  listen() {
    element("preset").addEventListener("change", ({ target }) => {
      if (target.value) this.set({ ...DEFAULTS, ...PRESETS[target.value] });
    });
    for (const key of ["theory", "resolution", "colour", "force", "along"]) {
      element(key).addEventListener("change", ({ target }) => this.set({ [key]: target.value }));
    }
    for (const radio of document.querySelectorAll("[name=units]")) {
      radio.addEventListener("change", () => this.set(this.converted(radio.value)));
    }
    element("curves").addEventListener("change", () => {
      const ticked = [...element("curves").querySelectorAll(":checked")].map(({ value }) => value);
      this.set({ curves: ticked.join(",") });
    });
    element("copy").addEventListener("click", () => copyLink(element("copy")));
    element("download").addEventListener("click", () => download("case.toml", caseFile(this.state)));
    window.addEventListener("hashchange", () => {
      if (location.hash !== toLink(this.state)) this.set(fromLink(location.hash, this.names));
    });
    new ResizeObserver(() => this.refresh()).observe(element("explorer"));
    new MutationObserver(() => this.refresh()).observe(document.body, {
      attributeFilter: ["data-md-color-scheme"],
    });
    document.querySelector(".explorer-controls").addEventListener("submit", (event) => event.preventDefault());
  }

  // The fields of the units in use.
  build() {
    const changed = (key, value) => this.set({ [key]: value });
    const { units } = this.state;
    this.fields = {};
    for (const [id, keys] of [["contact-fields", CONTACT_FIELDS[units]], ["creepage-fields", CREEPAGES[units]]]) {
      element(id).querySelectorAll("p").forEach((row) => row.remove());
      for (const key of keys) {
        this.fields[key] = new Field(key, changed);
        this.fields[key].limit(FIELDS[key].range, FIELDS[key].step);
        element(id).append(this.fields[key].row);
      }
    }
    this.built = units;
    options("along", ["0", "1", "2"], (k) => FIELDS[CREEPAGES[units][k]].name);
  }

  // The same creepage in the other units; the contact too where that is possible.
  converted(units) {
    if (units === this.state.units || !this.contact) return { units };
    if (units === "plain") {
      const [xi, eta, chi] = creepage(this.state, this.contact).map((part) => Number(part.toPrecision(6)));
      const ab = Number((this.contact.a / this.contact.b).toPrecision(6));
      return { units, ab, poisson: Number(this.contact.poisson.toPrecision(6)), xi, eta, chi };
    }
    const contact = this.engine.contact({ ...this.state, units });
    const [ux, uy, phi] = [this.state.xi, this.state.eta, this.state.chi].map((part, k) =>
      Number((part * creepageUnits({ units }, contact)[k]).toPrecision(4)));
    return { units, ux, uy, phi };
  }

  set(change) {
    Object.assign(this.state, change);
    if (this.state.units !== this.built) this.build();
    this.refresh();
  }

  refresh() {
    this.waiting ??= requestAnimationFrame(() => {
      this.waiting = null;
      this.frame();
    });
  }

  frame() {
    const start = performance.now();
    const { state } = this;
    try {
      this.solve();
      element("failure").textContent = "";
    } catch (error) {
      element("failure").textContent = error.message;
      this.answer = null;
    }
    this.controls();
    history.replaceState(null, "", toLink(state));
    element("link").href = toLink(state);
    element("case").querySelector("code").textContent = caseFile(state);
    element("python").querySelector("code").textContent = python(state);
    if (!this.answer) return;
    this.picture.draw(this.answer, { ...this.contact, friction: state.mu }, state);
    this.report();
    const along = Number(state.along), size = Math.abs(this.creepage[along]);
    this.curves.want(state, this.contact, this.creepage, Math.max([3, 3, 5][along], 1.25 * size));
    this.lastFrame = performance.now() - start;
    this.more();
  }

  solve() {
    const { state } = this;
    const key = JSON.stringify(["units", ...CONTACT_FIELDS[state.units]].map((key) => String(state[key])));
    if (key !== this.contactKey) {
      this.contactKey = null;
      this.contact = this.engine.contact(state);
      this.contactKey = key;
    }
    this.creepage = creepage(state, this.contact);
    const start = performance.now();
    this.answer = this.engine.show(state.theory, state.resolution, this.creepage);
    this.solveTime = performance.now() - start;
  }

  // Some more of the curves in every frame, until they are whole.
  more() {
    cancelAnimationFrame(this.drawing);
    const whole = this.curves.advance();
    this.curves.draw(this.answer.force);
    for (const name of this.names) element(`time-${name}`).textContent = this.curves.time(name);
    document.body.dataset.explorer = whole ? "whole" : "drawing";
    if (!whole) this.drawing = requestAnimationFrame(() => this.more());
  }

  controls() {
    const { state, fields, contact } = this;
    for (const [key, field] of Object.entries(fields)) {
      const k = CREEPAGES.si.indexOf(key);
      if (k >= 0 && contact) {
        const { range, step } = roundRange([3, 3, 5][k], creepageUnits(state, contact)[k]);
        field.limit(range, step);
      }
      field.show(state[key]);
    }
    for (const key of ["theory", "resolution", "colour", "force", "along"]) element(key).value = state[key];
    document.querySelector(`[name=units][value=${state.units}]`).checked = true;
    const ticked = state.curves.split(",");
    for (const box of element("curves").querySelectorAll("input")) box.checked = ticked.includes(box.value);
    element("resolution").disabled = state.theory !== "exact" && !ticked.includes("exact");
    const { assumes, goodFor } = this.engine.theories.find(({ name }) => name === state.theory);
    element("assumes").textContent = `${assumes}; good for ${goodFor}`;
  }

  report() {
    const { force, error, status } = this.answer;
    const units = this.contact, dimensionless = this.state.units === "plain";
    const si = { fx: units.force, fy: units.force, mz: units.force * units.length };
    for (const key of ["fx", "fy", "mz"]) {
      const output = element(key);
      output.textContent = fixed(force[key]) + (error ? ` ± ${fixed(error[key])}` : "");
      output.dataset.value = force[key];
      element(`${key}-si`).textContent =
        dimensionless ? "" : `${show(Number(force[key].toFixed(6)) * si[key])} ${key === "mz" ? "N m" : "N"}`;
    }
    const slipping = slippingShare(this.answer.cells);
    element("used").textContent = `${show(100 * Math.hypot(force.fx, force.fy))} %`;
    element("slipping").textContent = `${show(100 * slipping)} %`;
    element("status").textContent = this.remarks(status);
    this.say(`f_x ${fixed(force.fx)}, f_y ${fixed(force.fy)}, m_z ${fixed(force.mz)}, ` +
      `${Math.round(100 * slipping)} per cent of the contact slips`);
  }

  remarks(status) {
    const remarks = [`${status.replaceAll("_", " ")} in ${show(this.solveTime)} ms`];
    const { kappaOverMu } = this.contact;
    if (Math.abs(kappaOverMu) >= 0.01 && this.state.theory !== "exact") {
      remarks.push(`the bodies are unlike, κ/µ = ${show(kappaOverMu)}, which only exact counts`);
    }
    return remarks.join("; ");
  }

  // For those who listen: when the case has stood still for half a second.
  say(words) {
    clearTimeout(this.saying);
    element("picture").setAttribute("aria-label", `The contact seen from above: ${words}`);
    this.saying = setTimeout(() => (element("summary").textContent = words), 500);
  }
}

// The share of the contact's area in cells that slip.
function slippingShare(cells) {
  let [slipping, all] = [0, 0];
  for (let at = 0; at < cells.length; at += CELL) {
    const across = [cells[at + 4] - cells[at], cells[at + 5] - cells[at + 1]];
    const other = [cells[at + 6] - cells[at + 2], cells[at + 7] - cells[at + 3]];
    const area = across[0] * other[1] - across[1] * other[0];
    all += area;
    slipping += cells[at + 12] * area;
  }
  return slipping / all;
}

Engine.start().then(
  (engine) => (window.explorer = new Page(engine)),
  (error) => (element("failure").textContent = `The explorer cannot start: ${error.message}`),
);
