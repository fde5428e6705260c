// Wheels on their rails seen along the track, and every contact seen from above.
"use strict";

const ELEMENT = 17; // numbers of an element of a contact
const WIDE = 118e-3, INWARDS = 12e-3; // of the track shown about each rail, and how far to its middle (m)
const ABOVE = 14e-3, UNDER = 34e-3; // of the rails' top (m)
const SMALLEST = 1e-9; // of the largest traction
const SPACING = 19; // pixels between arrows, nearly
const SEAM = 0.4; // pixels by which cells overlap: a stroke around each would cost three times as much

// Both wheels on their rails, to scale; the wheelset hangs on the pointer.
class Front {
  constructor(canvas) {
    this.canvas = canvas;
  }

  draw(answer) {
    const sheet = paper(this.canvas, 0.3, 330);
    const half = sheet.width / 2, scale = Math.min((half - 8) / WIDE, (sheet.height - 24) / (ABOVE + UNDER));
    this.scale = scale;
    const longest = Math.max(...answer.wheels.map(({ force }) => Math.hypot(force[1], force[2])), 1);
    answer.outlines.forEach((side, k) => this.side(sheet, answer, side, k, half, scale, longest));
  }

  side(sheet, answer, { wheel, rail }, k, half, scale, longest) {
    const { pen } = sheet;
    const sense = k === 0 ? -1 : 1, middle = railMiddle(rail) - sense * INWARDS;
    const place = (y, z) => [(k + 0.5) * half + scale * (y - middle), 24 + scale * (z + ABOVE)];
    pen.save();
    pen.beginPath();
    pen.rect(k * half + 2, 22, half - 4, sheet.height - 22);
    pen.clip();
    this.line(sheet, rail, place, sheet.ink, 1.6, sheet.height);
    this.line(sheet, wheel, place, sheet.strong, 2.2, 0);
    for (const contact of answer.contacts.filter(({ side }) => side === sense)) this.area(sheet, contact, place);
    const { force } = answer.wheels[k];
    this.force(sheet, answer, force, sense, place, (0.26 * half) / longest);
    pen.restore();
    pen.fillStyle = sheet.ink;
    pen.textAlign = k === 0 ? "left" : "right";
    const words = `${k === 0 ? "left" : "right"} wheel, ${show(force[2] / 1e3)} kN`;
    pen.fillText(words, k === 0 ? 4 : sheet.width - 4, 15);
  }

  // A surface, with its body tinted to the height `far`.
  line({ pen, faint }, points, place, colour, width, far) {
    const line = [];
    for (let at = 0; at < points.length; at += 2) line.push(place(points[at], points[at + 1]));
    pen.fillStyle = faint;
    pen.beginPath();
    for (const at of [[line[0][0], far], ...line, [line.at(-1)[0], far]]) pen.lineTo(...at);
    pen.fill();
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    pen.beginPath();
    for (const at of line) pen.lineTo(...at);
    pen.stroke();
  }

  // The width of an area on the rail.
  area({ pen, slip }, { reference: [, y, z], angle, elements }, place) {
    const ends = extent(elements)[1];
    pen.strokeStyle = slip;
    pen.lineWidth = 6;
    pen.lineCap = "round";
    rule(pen, ...ends.map((s) => place(y + s * Math.cos(angle), z + s * Math.sin(angle))));
    pen.lineCap = "butt";
  }

  // Of the rail on the wheel, from where the most loaded contact is.
  force({ pen, arrow: colour }, answer, [, y, z], sense, place, unit) {
    const own = answer.contacts.filter(({ side }) => side === sense);
    if (!own.length) return;
    const { reference } = own.reduce((most, one) => (one.load > most.load ? one : most));
    const [p, q] = place(reference[1], reference[2]);
    pen.strokeStyle = pen.fillStyle = colour;
    pen.lineWidth = 2.4;
    arrow(pen, [p + unit * y, q + unit * z], [p, q]);
  }
}

function railMiddle(rail) {
  let [top, at] = [Infinity, 0];
  for (let k = 0; k < rail.length; k += 2) if (rail[k + 1] < top) [top, at] = [rail[k + 1], rail[k]];
  return at;
}

// Least and greatest x and s of the corners.
function extent(elements) {
  const ends = [[Infinity, -Infinity], [Infinity, -Infinity]];
  for (let at = 0; at < elements.length; at += ELEMENT) {
    for (let k = 0; k < 8; k++) {
      const end = ends[k % 2], value = elements[at + k];
      end[0] = Math.min(end[0], value);
      end[1] = Math.max(end[1], value);
    }
  }
  return ends;
}

// The contacts from above, all to one scale: x, the rolling direction, to the right, s downwards.
class Contacts {
  constructor(canvas, legend) {
    this.canvas = canvas;
    this.legend = legend;
  }

  draw({ contacts }, state) {
    const sheet = paper(this.canvas, window.innerWidth < 768 ? 0.62 : 0.36, 300);
    const { pen } = sheet, own = contacts.filter(({ elements }) => elements.length);
    if (!own.length) return;
    const extents = own.map(({ elements }) => extent(elements));
    const wide = Math.max(...extents.map(([x]) => x[1] - x[0])), high = Math.max(...extents.map(([, s]) => s[1] - s[0]));
    const room = sheet.width / own.length;
    const scale = Math.min((room - 34) / wide, (sheet.height - 56) / high);
    const shown = own.map(({ elements }) => sizes(elements, state.colour));
    const largest = Math.max(...shown.map((all) => all.reduce((most, one) => Math.max(most, one), 0)), 0);
    own.forEach((contact, k) => {
      const [x, s] = extents[k];
      const middle = [(k + 0.5) * room - 8, sheet.height / 2 + 8];
      const place = (at, across) => [
        middle[0] + scale * (at - (x[0] + x[1]) / 2), middle[1] + scale * (across - (s[0] + s[1]) / 2),
      ];
      this.cells(sheet, contact.elements, shown[k], largest, place, state.colour);
      this.arrows(sheet, contact.elements, place, scale, extents[k]);
      pen.fillStyle = sheet.ink;
      pen.textAlign = "center";
      const words = `${contact.side < 0 ? "left" : "right"}, ${show((180 / Math.PI) * contact.angle)}°, ${show(contact.load / 1e3)} kN`;
      pen.fillText(words, middle[0], 15);
    });
    this.measure(sheet, scale);
    this.explain(state.colour, largest);
  }

  cells({ pen, adhesion, slip }, elements, shown, largest, place, colour) {
    const fill = (corners, ink) => {
      const points = corners.map(([x, s]) => place(x, s));
      const middle = [0, 1].map((axis) => points.reduce((sum, point) => sum + point[axis], 0) / points.length);
      const outwards = (value, axis) => value + SEAM * Math.sign(value - middle[axis]);
      pen.fillStyle = ink;
      pen.beginPath();
      for (const point of points) pen.lineTo(...point.map(outwards));
      pen.closePath();
      pen.fill();
    };
    const slipping = [];
    for (let k = 0; k < shown.length; k++) {
      const corners = [0, 1, 2, 3].map((corner) => {
        const at = ELEMENT * k + 2 * corner;
        return [elements[at], elements[at + 1], elements[ELEMENT * k + 13 + corner]];
      });
      fill(corners, colour === "areas" ? adhesion : ramp(largest > 0 ? shown[k] / largest : 0));
      if (colour === "areas") slipping.push(beyondBorder(corners));
    }
    for (const corners of slipping) if (corners.length) fill(corners, slip);
  }

  // Traction on the rail, an arrow at each node of a raster: that of the element there. The largest one has its own
  // place where no node lies in its element.
  arrows({ pen, arrow: colour }, elements, place, scale, extents) {
    const counts = extents.map(([low, high]) => Math.max(1, Math.round(((high - low) * scale) / SPACING)));
    const step = (axis) => (extents[axis][1] - extents[axis][0]) / counts[axis];
    const node = (number, axis) => extents[axis][0] + (number + 0.5) * step(axis);
    const nodes = new Map();
    let [largest, where] = [0, 0];
    for (let at = 0; at < elements.length; at += ELEMENT) {
      const corners = [0, 2, 4, 6].map((k) => [elements[at + k], elements[at + k + 1]]);
      const size = Math.hypot(elements[at + 8], elements[at + 9]);
      if (size > largest) [largest, where] = [size, at];
      const [across, along] = [1, 0].map((axis) => {
        const [low, high] = [Math.min, Math.max].map((end) => end(...corners.map((corner) => corner[axis])));
        const number = (value) => (value - extents[axis][0]) / step(axis) - 0.5;
        return [Math.max(0, Math.ceil(number(low))), Math.min(counts[axis] - 1, Math.floor(number(high)))];
      });
      for (let k = along[0]; k <= along[1]; k++) {
        for (let j = across[0]; j <= across[1]; j++) {
          const middle = [node(k, 0), node(j, 1)];
          if (within(middle, corners)) nodes.set(`${k},${j}`, { middle, at });
        }
      }
    }
    if (largest > 0 && ![...nodes.values()].some(({ at }) => at === where)) {
      const middle = [0, 1].map((axis) => [0, 2, 4, 6].reduce((sum, k) => sum + elements[where + k + axis], 0) / 4);
      nodes.set(middle.map((at, axis) => Math.round((at - node(0, axis)) / step(axis))).join(), { middle, at: where });
    }
    pen.strokeStyle = pen.fillStyle = colour;
    pen.lineWidth = 1.4;
    for (const { middle, at } of nodes.values()) {
      const traction = [elements[at + 8] / largest, elements[at + 9] / largest];
      if (!(Math.hypot(...traction) > SMALLEST)) continue;
      const [p, q] = place(...middle), [u, v] = traction.map((part) => 9 * part);
      arrow(pen, [p - u, q - v], [p + u, q + v]);
    }
  }

  // A bar of a round length, and the axes.
  measure({ pen, ink, width, height }, scale) {
    const length = [20, 10, 5, 2, 1, 0.5, 0.2, 0.1].find((mm) => mm * 1e-3 * scale < 0.2 * width) ?? 0.1;
    const [right, low] = [width - 10, height - 8];
    pen.strokeStyle = pen.fillStyle = ink;
    pen.lineWidth = 2;
    rule(pen, [right - length * 1e-3 * scale, low], [right, low]);
    pen.lineWidth = 1;
    pen.textAlign = "right";
    pen.fillText(`${length} mm`, right, low - 6);
    pen.textAlign = "left";
    arrow(pen, [6, low - 14], [34, low - 14]);
    pen.fillText("x", 38, low - 9);
    arrow(pen, [6, low - 14], [6, low + 6]);
    pen.fillText("s", 11, low + 6);
  }

  explain(colour, largest) {
    const swatch = (name, words) => `<span class="explorer-swatch" style="background:var(${name})"></span>${words} `;
    if (colour === "areas") {
      this.legend.innerHTML = swatch("--guide-adhesion", "adhesion") + swatch("--guide-slip", "slip") +
        "&emsp;arrows: traction on the rail";
      return;
    }
    const bar = `<span class="explorer-ramp" style="background:linear-gradient(90deg,${[0, 0.25, 0.5, 0.75, 1].map(ramp)})"></span>`;
    const most = colour === "slip" ? `${show(largest * 1e3)} mm per metre rolled` : `${show(largest / 1e6)} MPa`;
    this.legend.innerHTML = `0 ${bar} ${most}`;
  }
}

// Whether a place lies in a convex quadrangle.
function within([x, y], corners) {
  const turns = corners.map(([a, b], k) => {
    const [c, d] = corners[(k + 1) % 4];
    return (c - a) * (y - b) - (d - b) * (x - a);
  });
  return turns.every((turn) => turn >= 0) || turns.every((turn) => turn <= 0);
}

// The part of an element that slips: where the distance from the border, linear along its sides, is positive.
function beyondBorder(corners) {
  const part = [];
  corners.forEach((from, k) => {
    const to = corners[(k + 1) % corners.length];
    if (from[2] > 0) part.push(from);
    if (from[2] > 0 === to[2] > 0) return;
    const share = from[2] / (from[2] - to[2]);
    part.push([from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])]);
  });
  return part;
}

// What is shown of each element: Pa, or slip.
function sizes(elements, colour) {
  const part = { traction: [8, 9], slip: [10, 11], pressure: [12, 12] }[colour];
  const all = new Float64Array(elements.length / ELEMENT);
  if (!part) return all;
  for (let k = 0; k < all.length; k++) {
    const [one, other] = part.map((at) => elements[ELEMENT * k + at]);
    all[k] = part[0] === part[1] ? one : Math.hypot(one, other);
  }
  return all;
}

// The difference of rolling radii over the lateral position, with the wheelset in it.
class Radii {
  constructor(canvas) {
    this.canvas = canvas;
  }

  draw({ difference, byRadius }, y) {
    const sheet = paper(this.canvas, 0.62, 230), { pen } = sheet;
    const rows = [];
    for (let at = 0; at < difference.length; at += 2) rows.push([difference[at] * 1e3, difference[at + 1] * 1e3]);
    // The flange's climb would flatten all else.
    const within = rows.filter(([at]) => Math.abs(at) <= Math.max(7, Math.abs(y) + 0.5));
    const box = { left: 44, right: sheet.width - 10, top: 12, bottom: sheet.height - 36 };
    const reach = Math.max(...within.map(([at]) => Math.abs(at)), 1), tall = Math.max(...within.map(([, by]) => Math.abs(by)), 0.1);
    const across = (at) => box.left + ((at / reach + 1) / 2) * (box.right - box.left);
    const up = (by) => box.bottom - ((by / tall + 1) / 2) * (box.bottom - box.top);
    pen.strokeStyle = sheet.faint;
    pen.fillStyle = sheet.ink;
    pen.lineWidth = 1;
    pen.textAlign = "center";
    for (const tick of ticks(reach)) {
      rule(pen, [across(tick), box.top], [across(tick), box.bottom]);
      pen.fillText(String(tick), across(tick), box.bottom + 15);
    }
    pen.textAlign = "right";
    for (const tick of ticks(tall)) {
      rule(pen, [box.left, up(tick)], [box.right, up(tick)]);
      pen.fillText(String(tick), box.left - 5, up(tick) + 5);
    }
    pen.textAlign = "center";
    pen.fillText("y (mm)", (box.left + box.right) / 2, sheet.height - 5);
    pen.strokeStyle = sheet.ink;
    pen.lineWidth = 2;
    pen.beginPath();
    within.forEach(([at, by]) => pen.lineTo(across(at), up(by)));
    pen.stroke();
    if (!Number.isFinite(byRadius)) return;
    pen.fillStyle = sheet.strong;
    pen.beginPath();
    pen.arc(across(Math.max(-reach, Math.min(reach, y))), up(Math.max(-tall, Math.min(tall, byRadius * 1e3))), 5, 0, 2 * Math.PI);
    pen.fill();
  }
}
