// What both explorers use: words and numbers, and a canvas to draw on.
"use strict";

const element = (id) => document.getElementById(id);

// The engine of this page, which lies packed in a script.
async function engineBytes() {
  const packed = Uint8Array.from(atob(ENGINE_WASM), (letter) => letter.charCodeAt(0));
  return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}

function options(id, values, words = (value) => value) {
  element(id).replaceChildren(...values.map((value) => new Option(words(value), value)));
}

function fixed(value) {
  return value.toFixed(4).replace(/^-(0\.0+)$/, "$1");
}

function show(value) {
  return Number.isFinite(value) ? String(Number(value.toPrecision(3))) : "none";
}

// Numbers as people write them; flat is an infinite radius.
function readNumber(text) {
  const word = text.trim();
  if (word === "flat") return Infinity;
  return word === "" ? NaN : Number(word);
}

function writeNumber(value) {
  return value === Infinity ? "flat" : String(value);
}

function toml(value) {
  if (value === Infinity) return '"flat"';
  const text = String(value);
  return /[.e]/.test(text) ? text.replace(/^(-?\d+)e/, "$1.0e") : text + ".0";
}

// A text, or a blob, as a file.
function download(name, content) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([content]));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

// Copies the address, which holds the state; the button says so for a while.
async function copyLink(button) {
  const words = button.textContent;
  try {
    await navigator.clipboard.writeText(location.href);
    button.textContent = "Copied";
  } catch {
    button.textContent = "Copy it from the address bar";
  }
  setTimeout(() => (button.textContent = words), 2000);
}

// From little to much, on dark and light paper.
const RAMP = [[68, 84, 160], [44, 145, 160], [110, 190, 110], [235, 205, 80], [240, 120, 60]];

function ramp(share) {
  const at = Math.min(Math.max(share, 0), 1) * (RAMP.length - 1);
  const k = Math.min(Math.floor(at), RAMP.length - 2);
  const mixed = RAMP[k].map((part, i) => Math.round(part + (at - k) * (RAMP[k + 1][i] - part)));
  return `rgb(${mixed.join(",")})`;
}

// Paper as wide as the page allows, sharp on any screen; sizes are in the page's pixels.
function paper(canvas, heightOverWidth, highest) {
  const width = Math.max(canvas.clientWidth, 200), sharp = window.devicePixelRatio || 1;
  const height = Math.round(Math.min(heightOverWidth * width, highest));
  canvas.style.height = `${height}px`;
  canvas.width = Math.round(width * sharp);
  canvas.height = Math.round(height * sharp);
  const pen = canvas.getContext("2d");
  pen.setTransform(sharp, 0, 0, sharp, 0, 0);
  const style = getComputedStyle(canvas);
  const colour = (name) => style.getPropertyValue(name).trim();
  pen.font = `14px ${style.fontFamily}`;
  return {
    pen, width, height,
    ink: style.color, faint: colour("--explorer-faint"), adhesion: colour("--guide-adhesion"),
    slip: colour("--guide-slip"), strong: colour("--guide-strong"), arrow: colour("--explorer-arrow"),
  };
}

function arrow(pen, [x, y], [p, q]) {
  const length = Math.hypot(p - x, q - y), head = Math.min(6, 0.6 * length);
  const angle = Math.atan2(q - y, p - x);
  pen.beginPath();
  pen.moveTo(x, y);
  pen.lineTo(p - 0.7 * head * Math.cos(angle), q - 0.7 * head * Math.sin(angle));
  pen.stroke();
  pen.beginPath();
  pen.moveTo(p, q);
  for (const side of [-0.45, 0.45]) {
    pen.lineTo(p - head * Math.cos(angle + side), q - head * Math.sin(angle + side));
  }
  pen.fill();
}

// Round numbers between plus and minus the range, some six.
function ticks(range) {
  const rough = range / 3, power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find((factor) => factor * power >= 0.99 * rough);
  const count = Math.floor((1.001 * range) / step);
  const all = Array.from({ length: 2 * count + 1 }, (_, k) => (k - count) * step);
  return all.map((tick) => Number(tick.toPrecision(12)));
}

function rule(pen, from, to) {
  pen.beginPath();
  pen.moveTo(...from);
  pen.lineTo(...to);
  pen.stroke();
}
