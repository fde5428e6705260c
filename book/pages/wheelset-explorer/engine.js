// The library in workers: what crates/creepage-web-wheelset exports. Some answer while things move, another one when
// they rest, so that neither waits for the other.
"use strict";

const RESOLUTIONS = { fastsim: 0, fast: 1, standard: 2, fine: 3 };

// Runs in a worker, from its text: it sees nothing of the page.
function solveInWorker() {
  "use strict";
  const HEAD = 4, WHEEL = 6, CONTACT = 20, ELEMENT = 17;
  const OUTLINE = 4e-4; // m between points
  let library, names, built;

  const words = () => new TextDecoder().decode(
    new Uint8Array(library.memory.buffer, library.words(), library.words_len()));
  // A copy: the module's memory may move.
  const numbers = () =>
    new Float64Array(library.memory.buffer, library.numbers(), library.numbers_len()).slice();
  const must = (done) => {
    if (!done) throw new Error(words());
  };

  function take(role, profile) {
    if (!profile.bytes) {
      must(library.take_named(names.findIndex((known) => known.role === role && known.name === profile.name)));
      return "";
    }
    const name = new TextEncoder().encode(profile.name), size = name.length + profile.bytes.length;
    const at = library.input(size);
    const room = new Uint8Array(library.memory.buffer, at, size);
    room.set(name);
    room.set(profile.bytes, name.length);
    must(library.take_file(role === "rail" ? 1 : 0, name.length));
    return words();
  }

  // The wheelset on its track, unless it is there already.
  function build({ wheel, rail, sizes }) {
    const key = JSON.stringify([wheel.name, wheel.number, rail.name, rail.number, sizes]);
    if (built?.key === key) return built;
    built = null;
    const notes = [take("wheel", wheel), take("rail", rail)];
    must(library.set_on_track(...sizes));
    const [conicity, ...difference] = numbers();
    built = { key, conicity, difference, notes };
    return built;
  }

  function contacts(rest, count) {
    const all = [];
    for (let at = 0; all.length < count;) {
      const [side, x, y, z, angle, load, loadError, longitudinal, lateral, spin, fx, fy, moment, fxError, fyError,
        peak, area, adhesion, heat, elements] = rest.subarray(at, at + CONTACT);
      const end = at + CONTACT + ELEMENT * elements;
      all.push({
        side, reference: [x, y, z], angle, load, loadError, creepage: { longitudinal, lateral, spin },
        force: [fx, fy], moment, error: [fxError, fyError], peak, area, adhesion, heat,
        elements: rest.slice(at + CONTACT, end),
      });
      at = end;
    }
    return all;
  }

  function outlines() {
    must(library.outlines(OUTLINE));
    const all = numbers(), sides = [];
    for (let at = 0; sides.length < 2;) {
      const [wheel, rail] = all.subarray(at, at + 2), from = at + 2;
      sides.push({
        wheel: all.slice(from, from + 2 * wheel),
        rail: all.slice(from + 2 * wheel, from + 2 * (wheel + rail)),
      });
      at = from + 2 * (wheel + rail);
    }
    return sides;
  }

  function solve({ resolution, warmStart, place, ...asked }) {
    const { conicity, difference, notes } = build(asked);
    const start = performance.now();
    must(library.solve(resolution, warmStart ? 1 : 0, ...place));
    const time = performance.now() - start, [status, ...cautions] = words().split("\n"), all = numbers();
    const [z, roll, pitchRate, byRadius] = all;
    const wheels = [0, 1].map((k) => {
      const [x, y, down, xError, yError, clearance] = all.subarray(HEAD + WHEEL * k, HEAD + WHEEL * (k + 1));
      return { force: [x, y, down], error: [xError, yError], clearance };
    });
    const at = HEAD + 2 * WHEEL;
    return {
      conicity, difference, notes, status, cautions, time, z, roll, pitchRate, byRadius, wheels,
      contacts: contacts(all.subarray(at + 1), all[at]), outlines: outlines(),
    };
  }

  onmessage = async ({ data: { wasm, asked } }) => {
    try {
      if (wasm) {
        library = (await WebAssembly.instantiate(wasm, {})).instance.exports;
        library.profiles();
        names = words().trim().split("\n").map((line) => {
          const [role, name] = line.split("\t");
          return { role, name };
        });
        // A number in the list of all is what the library takes.
        postMessage({ answer: names });
      } else {
        postMessage({ answer: solve(asked) });
      }
    } catch (error) {
      postMessage({ failure: error.message });
    }
  };
}

// A window whose Worker is the browser's: where the guide is opened as a file, its search has put another in this one's
// place, which runs in the page.
// Until the frame has loaded, the browser may still replace its window, and end the workers of the first one.
let nativeWindow = () => {
  const frame = document.createElement("iframe");
  Object.assign(frame, { hidden: true, title: "no content" });
  const loaded = new Promise((done) => frame.addEventListener("load", () => done(frame.contentWindow), { once: true }));
  document.body.append(frame);
  nativeWindow = () => loaded;
  return loaded;
};

// A worker, which answers one question at a time.
class Colleague {
  constructor(address) {
    this.worker = nativeWindow().then(({ Worker }) => {
      const worker = new Worker(address);
      worker.onmessage = ({ data }) => this.answered(data);
      return worker;
    });
  }

  post(message, answered) {
    this.answered = (data) => {
      this.answered = null;
      answered(data);
    };
    this.worker.then((worker) => worker.postMessage(message));
  }
}

// One question a worker; of those that come while all are busy the last one alone is asked. Answers may overtake
// each other.
class Solver {
  constructor(count) {
    const text = `(${solveInWorker})()`;
    const address = URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
    this.colleagues = Array.from({ length: count }, () => new Colleague(address));
  }

  async start(wasm) {
    const ready = (colleague) => new Promise((done, failed) => this.post(colleague, { wasm }, done, failed));
    return (await Promise.all(this.colleagues.map(ready)))[0];
  }

  post(colleague, message, done, failed) {
    colleague.post(message, ({ answer, failure }) => {
      const next = this.next;
      this.next = null;
      if (next) this.ask(...next);
      if (failure === undefined) done(answer);
      else failed(new Error(failure));
    });
  }

  ask(asked, done, failed) {
    const free = this.colleagues.find(({ answered }) => !answered);
    if (free) this.post(free, { asked }, done, failed);
    else this.next = [asked, done, failed];
  }

  // What is still to come is wanted no longer.
  forget() {
    this.next = null;
  }
}
