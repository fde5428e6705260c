// The page: what is set, what is solved, what is shown.
"use strict";

const REST = 120; // ms without a change after which the full theory solves
const WORKERS = 2; // that answer in turn while things move
const ROLES = ["wheel", "rail"];

class Page {
  constructor(quick, exact, profiles) {
    Object.assign(this, { quick, exact, profiles });
    this.front = new Front(element("front"));
    this.contacts = new Contacts(element("contacts"), element("legend"));
    this.radii = new Radii(element("radii"));
    this.files = {};
    this.state = fromLink(location.hash, profiles);
    this.fill();
    this.listen();
    this.refresh();
  }

  fill() {
    options("preset", ["", ...Object.keys(PRESETS)], (name) => name || "choose a case");
    ROLES.forEach((role) => this.fillProfiles(role));
    this.fields = {};
    for (const [id, keys] of [["place-fields", PLACE], ["size-fields", SIZES]]) {
      for (const key of keys) {
        this.fields[key] = new Field(key, (own, value) => this.set({ [own]: value }));
        this.fields[key].limit(FIELDS[key].range, FIELDS[key].step);
        element(id).append(this.fields[key].row);
      }
    }
  }

  fillProfiles(role) {
    const names = this.profiles.filter((one) => one.role === role).map(({ name }) => name);
    options(role, this.files[role] ? [...names, this.files[role].name] : names);
  }

  listen() {
    element("preset").addEventListener("change", ({ target }) => {
      if (target.value) this.set({ ...DEFAULTS, ...PRESETS[target.value] });
    });
    for (const key of [...ROLES, "resolution", "colour"]) {
      element(key).addEventListener("change", ({ target }) => this.set({ [key]: target.value }));
    }
    for (const role of ROLES) {
      element(`${role}-file`).addEventListener("change", ({ target }) => this.take(role, target.files[0]));
    }
    element("copy").addEventListener("click", () => copyLink(element("copy")));
    element("download").addEventListener("click", () => download("case.toml", caseFile(this.state)));
    element("save").addEventListener("click", () => this.savePicture());
    window.addEventListener("hashchange", () => {
      if (location.hash !== toLink(this.state)) this.set(fromLink(location.hash, this.profiles));
    });
    new ResizeObserver(() => this.draw()).observe(element("explorer"));
    new MutationObserver(() => this.draw()).observe(document.body, { attributeFilter: ["data-md-color-scheme"] });
    document.querySelector(".explorer-controls").addEventListener("submit", (event) => event.preventDefault());
    this.drag(element("front"));
  }

  // The wheelset follows the pointer across the track, to scale; up and down turn it.
  drag(canvas) {
    let from = null;
    canvas.addEventListener("pointerdown", (event) => {
      from = { x: event.clientX, y: event.clientY, at: this.state.y, yaw: this.state.yaw };
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener("pointermove", (event) => {
      if (!from || !this.front.scale) return;
      const within = (key, value, digits) => {
        const [low, high] = FIELDS[key].range;
        return Number(Math.min(high, Math.max(low, value)).toFixed(digits));
      };
      const y = within("y", from.at + ((event.clientX - from.x) / this.front.scale) * 1e3, 2);
      const turned = event.shiftKey ? (event.clientY - from.y) * 0.05 : 0;
      this.set({ y, yaw: within("yaw", from.yaw + turned, 2) });
    });
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => (from = null));
    canvas.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: ["y", -0.05], ArrowRight: ["y", 0.05], ArrowUp: ["yaw", -0.1], ArrowDown: ["yaw", 0.1] }[event.key];
      if (!step) return;
      event.preventDefault();
      this.set({ [step[0]]: Number((this.state[step[0]] + step[1]).toFixed(2)) });
    });
    for (const kind of ["dragover", "drop"]) {
      element("explorer").addEventListener(kind, (event) => {
        event.preventDefault();
        if (kind === "drop") this.dropped([...event.dataTransfer.files]);
      });
    }
  }

  // A file dropped: a rail where its name says so.
  dropped(files) {
    for (const file of files) this.take(/\.(ban|prr|rai|rail)$/i.test(file.name) ? "rail" : "wheel", file);
  }

  async take(role, file) {
    if (!file) return;
    this.count = (this.count ?? 0) + 1;
    this.files[role] = { name: file.name, number: this.count, bytes: new Uint8Array(await file.arrayBuffer()) };
    this.fillProfiles(role);
    this.set({ [role]: file.name });
  }

  set(change) {
    Object.assign(this.state, change);
    this.refresh();
  }

  asked(resolution, warmStart) {
    const profile = (role) => (this.files[role]?.name === this.state[role] ? this.files[role] : { name: this.state[role] });
    return { resolution, warmStart, wheel: profile("wheel"), rail: profile("rail"), ...si(this.state) };
  }

  // While things move FASTSIM answers, from a position before; at rest the full theory does, from nothing.
  refresh() {
    this.version = (this.version ?? 0) + 1;
    const own = this.version;
    this.controls();
    document.body.dataset.explorer = "moving";
    this.quick.ask(this.asked(RESOLUTIONS.fastsim, true), (answer) => {
      if (own < (this.shown ?? 0)) return;
      this.moving = { version: own, answer };
      if (this.restVersion !== this.version) this.show(own, answer, "fastsim");
      else this.report();
    }, (error) => this.fail(own, error));
    clearTimeout(this.resting);
    this.exact.forget();
    this.resting = setTimeout(() => this.rest(own), REST);
  }

  rest(own) {
    history.replaceState(null, "", toLink(this.state));
    element("link").href = toLink(this.state);
    element("case").querySelector("code").textContent = caseFile(this.state);
    this.exact.ask(this.asked(RESOLUTIONS[this.state.resolution], false), (answer) => {
      if (own !== this.version) return;
      this.restVersion = own;
      this.show(own, answer, "exact");
      document.body.dataset.explorer = "whole";
    }, (error) => this.fail(own, error));
  }

  fail(own, error) {
    if (own !== this.version) return;
    element("failure").textContent = error.message;
    document.body.dataset.explorer = "whole";
  }

  show(own, answer, theory) {
    element("failure").textContent = "";
    Object.assign(this, { shown: own, answer, theory });
    this.draw();
    this.report();
  }

  draw() {
    if (!this.answer) return;
    this.front.draw(this.answer);
    this.contacts.draw(this.answer, this.state);
    this.radii.draw(this.answer, this.state.y);
  }

  controls() {
    for (const [key, field] of Object.entries(this.fields)) field.show(this.state[key]);
    for (const key of [...ROLES, "resolution", "colour"]) element(key).value = this.state[key];
  }

  report() {
    const { answer } = this;
    for (const [k, side] of ["left", "right"].entries()) {
      const { force, error, clearance } = answer.wheels[k];
      const own = answer.contacts.filter((contact) => (contact.side < 0) === (k === 0));
      const bar = (value, by) => `${show(value / 1e3)}${by > 0 ? ` ± ${Number((by / 1e3).toPrecision(2))}` : ""}`;
      element(`${side}-x`).textContent = bar(force[0], error[0]);
      element(`${side}-y`).textContent = bar(force[1], error[1]);
      element(`${side}-z`).textContent = show(force[2] / 1e3);
      ["x", "y", "z"].forEach((axis, part) => (element(`${side}-${axis}`).dataset.value = force[part]));
      element(`${side}-peak`).textContent = own.map(({ peak }) => show(peak / 1e6)).join(", ") || "none";
      element(`${side}-creepage`).textContent =
        own.map(({ creepage }) => `${show(creepage.longitudinal * 1e3)}, ${show(creepage.lateral * 1e3)}`).join("; ") || "none";
      element(`${side}-adhesion`).textContent = own.map(({ adhesion }) => Math.round(100 * adhesion)).join(", ") || "none";
      if (Number.isFinite(clearance)) element(`${side}-peak`).textContent = `hangs ${show(clearance * 1e3)} mm above its rail`;
    }
    const heat = answer.contacts.reduce((sum, contact) => sum + contact.heat, 0);
    element("radius-difference").textContent = Number.isFinite(answer.byRadius) ? `${show(answer.byRadius * 1e3)} mm` : "none";
    element("conicity").textContent = Number.isFinite(answer.conicity) ? show(answer.conicity) : "none";
    element("roll").textContent = `${show(answer.roll * 1e3)} mrad`;
    element("heat").textContent = Number.isFinite(heat) ? `${show(heat)} J/m` : "unknown";
    element("status").textContent = this.remarks();
    element("cautions").replaceChildren(...answer.cautions.map((words) => {
      const item = document.createElement("li");
      item.textContent = words;
      return item;
    }));
    this.say();
  }

  remarks() {
    const { answer, state } = this;
    const remarks = [`${this.theory}: ${answer.status.replaceAll("_", " ")} in ${show(answer.time)} ms`];
    const off = this.off();
    if (Number.isFinite(off)) remarks.push(`fastsim, which answers while you drag, is ${show(100 * off)} % of μN off`);
    if (state.curvature !== 0) remarks.push(`radius of the curve ${show(1e3 / Math.abs(state.curvature))} m`);
    return [...remarks, ...answer.notes.filter(Boolean).map((note) => note.trim())].join("; ");
  }

  // How far the answer of the same state while things moved was off, in parts of mu N; NaN where there is none.
  off() {
    if (this.restVersion !== this.version || this.moving?.version !== this.version) return NaN;
    return Math.max(...[0, 1].map((k) => {
      const [rest, moving] = [this.answer, this.moving.answer].map(({ wheels }) => wheels[k].force);
      return Math.hypot(rest[0] - moving[0], rest[1] - moving[1]) / (this.state.mu * Math.max(rest[2], 1));
    }));
  }

  // For those who listen: when the wheelset has stood still for half a second.
  say() {
    const parts = this.answer.wheels.map(({ force }, k) =>
      `${["left", "right"][k]} wheel: along ${show(force[0] / 1e3)}, across ${show(force[1] / 1e3)}, down ${show(force[2] / 1e3)} kilonewtons`);
    clearTimeout(this.saying);
    this.saying = setTimeout(() => (element("summary").textContent = parts.join("; ")), 500);
  }

  // All pictures on one sheet.
  savePicture() {
    const sheets = ["front", "contacts", "radii"].map(element);
    const all = document.createElement("canvas"), pen = all.getContext("2d");
    all.width = Math.max(...sheets.map(({ width }) => width));
    all.height = sheets.reduce((sum, { height }) => sum + height, 0);
    pen.fillStyle = getComputedStyle(document.body).backgroundColor;
    pen.fillRect(0, 0, all.width, all.height);
    let from = 0;
    for (const sheet of sheets) {
      pen.drawImage(sheet, 0, from);
      from += sheet.height;
    }
    all.toBlob((blob) => download("wheelset.png", blob));
  }
}

(async () => {
  try {
    const [quick, exact] = [new Solver(WORKERS), new Solver(1)], wasm = await engineBytes();
    const [profiles] = await Promise.all([quick.start(wasm), exact.start(wasm)]);
    window.explorer = new Page(quick, exact, profiles);
  } catch (error) {
    element("failure").textContent = `The explorer cannot start: ${error.message}`;
  }
})();
