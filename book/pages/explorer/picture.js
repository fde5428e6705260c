// The contact seen from above: cells in colour, the traction as arrows.
"use strict";

const SMALLEST_TRACTION = 1e-9;

class Picture {
  constructor(canvas, legend) {
    this.canvas = canvas;
    this.legend = legend;
  }

  draw(answer, contact, state) {
    const sheet = paper(this.canvas, window.innerWidth < 768 ? 0.5 : 0.7, 380);
    const ratio = contact.a / contact.b, semiAxes = [Math.sqrt(ratio), 1 / Math.sqrt(ratio)];
    const scale = Math.min((sheet.width / 2 - 44) / semiAxes[0], (sheet.height / 2 - 26) / semiAxes[1]);
    const place = (x, y) => [sheet.width / 2 + scale * x, sheet.height / 2 + scale * y];
    this.cells(sheet, answer, place, state.colour, contact);
    this.frame(sheet, semiAxes, scale, place);
    this.arrows(sheet, answer, semiAxes, scale, place);
  }

  cells({ pen, adhesion, slip }, { cells }, place, colour, contact) {
    const shown = sizes(cells, colour);
    const largest = Math.max(...shown, 0);
    const fill = (k) => {
      if (colour === "areas") return cells[CELL * k + 12] ? slip : adhesion;
      return ramp(largest > 0 ? shown[k] / largest : 0);
    };
    pen.lineWidth = 1;
    for (let first = 0, last; first < shown.length; first = last + 1) {
      pen.fillStyle = pen.strokeStyle = fill(first); // the stroke closes seams
      last = first;
      while ((last + 1) % CELLS_ALONG > 0 && fill(last + 1) === fill(first)) last += 1;
      outline(pen, cells, first, last, place);
      pen.fill();
      pen.stroke();
    }
    this.explain(colour, largest, contact);
  }

  frame({ pen, ink, width, height }, [a, b], scale, place) {
    pen.strokeStyle = pen.fillStyle = ink;
    pen.lineWidth = 1.5;
    pen.beginPath();
    pen.ellipse(...place(0, 0), scale * a, scale * b, 0, 0, 2 * Math.PI);
    pen.stroke();
    pen.lineWidth = 1;
    const [x, y] = place(a, 0);
    arrow(pen, [x + 6, y], [Math.min(x + 34, width - 12), y]);
    pen.textAlign = "left";
    pen.fillText("x", Math.min(x + 36, width - 10), y + 5);
    const [p, q] = place(0, b);
    arrow(pen, [p, q + 2], [p, Math.min(q + 20, height - 3)]);
    pen.fillText("y", p + 8, Math.min(q + 18, height - 4));
  }

  arrows({ pen, arrow: colour, width }, { cells }, semiAxes, scale, place) {
    const spacing = Math.max(width / 22, 20);
    const [a, b] = semiAxes, [columns, rows] = semiAxes.map((axis) => Math.floor((scale * axis) / spacing));
    pen.strokeStyle = pen.fillStyle = colour;
    pen.lineWidth = 1.6;
    for (let row = -rows; row <= rows; row++) {
      for (let column = -columns; column <= columns; column++) {
        const x = (column * spacing) / scale, y = (row * spacing) / scale;
        const k = cellAt(cells, x / a, y / b);
        if (k < 0) continue;
        const traction = [cells[CELL * k + 8], cells[CELL * k + 9]];
        if (Math.hypot(...traction) < SMALLEST_TRACTION) continue;
        const [p, q] = place(x, y), [u, v] = traction.map((part) => 0.6 * spacing * part);
        arrow(pen, [p - u, q - v], [p + u, q + v]);
      }
    }
  }

  explain(colour, largest, contact) {
    const swatch = (name, words) => `<span class="explorer-swatch" style="background:var(${name})"></span>${words} `;
    if (colour === "areas") {
      this.legend.innerHTML = swatch("--guide-adhesion", "adhesion") + swatch("--guide-slip", "slip");
      return;
    }
    const bar = `<span class="explorer-ramp" style="background:linear-gradient(90deg,${[0, 0.25, 0.5, 0.75, 1].map(ramp)})"></span>`;
    this.legend.innerHTML = `0 ${bar} ${inWords(colour, largest, contact)}`;
  }
}

// Around neighbouring cells of one strip.
function outline(pen, cells, first, last, place) {
  pen.beginPath();
  for (const [cell, corner] of [[first, 0], [last, 1], [last, 2], [first, 3]]) {
    const at = CELL * cell + 2 * corner;
    pen.lineTo(...place(cells[at], cells[at + 1]));
  }
  pen.closePath();
}

// What is shown of each cell, in the units of the theories.
function sizes(cells, colour) {
  const all = new Float64Array(cells.length / CELL);
  for (let k = 0; k < all.length; k++) {
    const of = (part) => cells[CELL * k + part];
    if (colour === "traction") all[k] = Math.hypot(of(8), of(9));
    if (colour === "slip") all[k] = Math.hypot(of(10), of(11)) || 0;
    if (colour === "pressure") all[k] = pressure(k, all.length);
  }
  return all;
}

// Hertz's pressure over its peak in the middle of a cell.
function pressure(k, count) {
  const strips = count / CELLS_ALONG, strip = Math.floor(k / CELLS_ALONG), along = k % CELLS_ALONG;
  const side = (border) => Math.cos((Math.PI * border) / strips);
  const y = (side(strip) + side(strip + 1)) / 2, s = (2 * along + 1) / CELLS_ALONG - 1;
  return Math.sqrt((1 - y * y) * (1 - s * s));
}

// The cell at (x/a, y/b); -1 outside.
function cellAt(cells, x, y) {
  const length = Math.sqrt(Math.max(1 - y * y, 0)), strips = cells.length / CELL / CELLS_ALONG;
  if (Math.abs(x) >= 0.97 * length) return -1;
  const strip = Math.min(Math.floor((Math.acos(-y) / Math.PI) * strips), strips - 1);
  return strip * CELLS_ALONG + Math.min(Math.floor(((x / length + 1) / 2) * CELLS_ALONG), CELLS_ALONG - 1);
}

function inWords(colour, largest, contact) {
  const { traction, slip } = contact, dimensionless = traction === 1;
  if (colour === "slip") {
    return dimensionless ? `${show(largest)} µc/ρ` : `${show(largest * slip * 1e3)} mm per metre rolled`;
  }
  const unit = colour === "pressure" ? traction / contact.friction : traction;
  if (!dimensionless) return `${show((largest * unit) / 1e6)} MPa`;
  return colour === "pressure" ? "peak pressure" : `${show(largest)} of its largest bound`;
}
