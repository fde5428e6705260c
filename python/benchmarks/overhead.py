"""What Python costs above Rust: one force, and 100,000 of them.

Runs the same cases by `crates/creepage-python/examples/batch.rs` (which cargo builds first) and by
the installed package, which must be the wheel of `maturin build --release` for the comparison to be
fair. The least of all rounds counts.
"""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import creepage
import numpy as np

ROOT = Path(__file__).parents[2]
COMMAND = "cargo run --quiet --release --package creepage-python --example batch"
CASES = 100_000
RAMP = np.arange(CASES) / CASES - 0.5


def best(runs: int, work: Callable[[], object]) -> float:
    """Seconds of the fastest run."""
    seconds = []
    for _ in range(runs):
        start = time.perf_counter()
        work()
        seconds.append(time.perf_counter() - start)
    return min(seconds)


def in_rust() -> dict[tuple[str, str], float]:
    """Seconds by theory and by `one` or `many`."""
    done = subprocess.run(COMMAND.split(), cwd=ROOT, capture_output=True, text=True, check=True)
    lines = (line.split() for line in done.stdout.splitlines())
    return {(theory, what): float(seconds) for theory, what, seconds in lines}


def in_python(theory: creepage.Theory, calls: int, batches: int) -> tuple[float, float]:
    """Seconds of one force of floats, and of an array."""
    force = theory.force

    def loop() -> None:
        for _ in range(calls):
            force(0.3, 0.1, 0.2)

    xi, eta, chi = RAMP, 0.5 * RAMP, 0.2 * RAMP
    return best(20, loop) / calls, best(batches, lambda: force(xi, eta, chi))


def main() -> None:
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 5
    theories = {
        "linear": (creepage.linear(1.5, 0.28), 20_000, 100),
        "fastsim": (creepage.fastsim(1.5, 0.28), 1000, 2),
    }
    least: dict[tuple[str, str, str], float] = {}
    for _ in range(rounds):  # in turns: what else the machine does hits both alike
        found = {("Rust", *key): seconds for key, seconds in in_rust().items()}
        for name, (theory, calls, batches) in theories.items():
            one, many = in_python(theory, calls, batches)
            found |= {("Python", name, "one"): one, ("Python", name, "many"): many}
        least = {key: min(value, least.get(key, np.inf)) for key, value in found.items()}
    for name in theories:
        one_rust, one = (1e6 * least[language, name, "one"] for language in ("Rust", "Python"))
        rust, many = (1e3 * least[language, name, "many"] for language in ("Rust", "Python"))
        print(f"{name:8} a force: Rust {one_rust:.3f} us, Python {one:.3f} us", end=" ")
        print(f"({one - one_rust:+.2f} us)")
        print(f"{name:8} {CASES} forces: Rust {rust:.2f} ms, Python {many:.2f} ms", end=" ")
        print(f"({100 * (many / rust - 1):+.1f} %)")


if __name__ == "__main__":
    main()
