// Sliders and typed fields, made from a table of what can be set.
"use strict";

class Field {
  constructor(key, changed) {
    this.key = key;
    const { name, unit } = FIELDS[key];
    this.row = document.createElement("p");
    this.row.className = "explorer-field";
    this.row.innerHTML =
      `<label for="${key}">${name}${unit ? ` <small>(${unit})</small>` : ""}</label>` +
      `<input type="range" id="${key}-slider" aria-label="${name}, slider">` +
      `<input type="text" inputmode="text" id="${key}" autocomplete="off" spellcheck="false">`;
    [, this.slider, this.text] = this.row.children;
    this.slider.addEventListener("input", () => changed(key, this.slid()));
    this.text.addEventListener("input", () => {
      const value = readNumber(this.text.value);
      this.text.setAttribute("aria-invalid", Number.isNaN(value));
      if (!Number.isNaN(value)) changed(key, value);
    });
    this.text.addEventListener("blur", () => this.write());
  }

  // The slider's range: the field's own, or that of a creepage in SI units.
  limit(range, step) {
    const { logarithmic } = FIELDS[this.key];
    this.row.classList.toggle("typed", !range);
    if (!range) return;
    const [low, high] = logarithmic ? range.map(Math.log10) : range;
    Object.assign(this.slider, { min: low, max: high, step: logarithmic ? 0.005 : step });
  }

  slid() {
    const value = Number(this.slider.value);
    return FIELDS[this.key].logarithmic ? Number((10 ** value).toPrecision(3)) : value;
  }

  show(value) {
    this.value = value;
    const { logarithmic } = FIELDS[this.key];
    this.slider.value = logarithmic ? Math.log10(value) : value;
    this.slider.setAttribute("aria-valuetext", writeNumber(value));
    if (document.activeElement !== this.text) this.write();
  }

  write() {
    this.text.value = writeNumber(this.value);
    this.text.setAttribute("aria-invalid", false);
  }
}

// A range of SI creepage that is about as wide as that of xi, eta or chi, in round numbers, and a
// thousandth of it.
function roundRange(dimensionless, unit) {
  const wide = dimensionless * unit, power = 10 ** Math.floor(Math.log10(wide));
  const top = Number((Math.ceil(wide / power) * power).toPrecision(3));
  return { range: [-top, top], step: Number((top / 1000).toPrecision(3)) };
}
