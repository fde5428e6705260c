// The library in this page: what crates/creepage-web exports, with its answers as JavaScript's numbers.
"use strict";

const RESOLUTIONS = ["fast", "standard", "fine"];
const HEAD = 7; // numbers before the cells
const CELL = 13; // numbers of a cell
const GIGA = 1e9;
const CELLS_ALONG = 96; // of a strip

class Engine {
  static async start() {
    const { instance } = await WebAssembly.instantiate(await engineBytes(), {});
    return new Engine(instance.exports);
  }

  constructor(library) {
    this.library = library;
    library.theories();
    this.theories = this.words().trim().split("\n").map((line) => {
      const [name, assumes, goodFor] = line.split("\t");
      return { name, assumes, goodFor };
    });
  }

  words() {
    const { memory, words, words_len } = this.library;
    return new TextDecoder().decode(new Uint8Array(memory.buffer, words(), words_len()));
  }

  // A copy: the module's memory may move.
  numbers() {
    const { memory, numbers, numbers_len } = this.library;
    return new Float64Array(memory.buffer, numbers(), numbers_len()).slice();
  }

  // From here on all is asked of this contact; its units. Throws what is wrong, in words.
  contact(state) {
    const met = state.units === "plain"
      ? this.library.ellipse(state.ab, state.poisson)
      : this.library.bodies(...bodies(state));
    if (!met) throw new Error(this.words());
    const [a, b, length, slip, force, traction, poisson, kappaOverMu] = this.numbers();
    return { a, b, length, slip, force, traction, poisson, kappaOverMu };
  }

  solve(theory, resolution, creepage) {
    return this.answer("solve", theory, resolution, creepage);
  }

  // The same with the cells of the contact.
  show(theory, resolution, creepage) {
    return this.answer("show", theory, resolution, creepage);
  }

  answer(question, theory, resolution, creepage) {
    const number = this.theories.findIndex(({ name }) => name === theory);
    const fineness = RESOLUTIONS.indexOf(resolution);
    if (!this.library[question](number, fineness, ...creepage)) throw new Error(this.words());
    const numbers = this.numbers();
    const [fx, fy, mz, fxError, fyError, mzError, power] = numbers;
    const error = Number.isNaN(fxError) ? null : { fx: fxError, fy: fyError, mz: mzError };
    return { force: { fx, fy, mz }, error, power, status: this.words(), cells: numbers.subarray(HEAD) };
  }
}

function bodies(state) {
  const body = (k) => [state["G" + k] * GIGA, state["s" + k], state["rx" + k], state["ry" + k]];
  return [...body(1), ...body(2), state.N, state.mu];
}
