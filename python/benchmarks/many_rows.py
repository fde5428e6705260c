"""Many rows of a wheelset by `creepage batch`, and some of them alone: `python many_rows.py COMMAND [COUNT] [SEED] [ALONE]`.

Rows draw the lateral shift within 6.5 mm, the yaw within 10 mrad, the axle load from 60 to 225 kN, for the S1002 on UIC 60
rails of the examples. They are solved on all cores by `fastsim` and by `exact` at its fast resolution. ALONE of them (default
1,000) are then solved again, one in a run of its own: each number must have the same bits. Printed: the time by the clock and of
the processor, the statuses in words, rows that are not solved, and rows that differ.
"""

from __future__ import annotations

import csv
import random
import resource
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

CASE = Path(__file__).parents[2] / "examples" / "wheelset" / "s1002-on-uic60.toml"
THEORIES = {"fastsim": '\n[solve]\ntheory = "fastsim"\n', "exact fast": '\n[solve]\ntheory = "exact"\nresolution = "fast"\n'}

Row = dict[str, str]


def drawn(count: int, chance: random.Random) -> list[Row]:
    """Positions and loads (SI)."""
    return [
        {
            "y": f"{chance.uniform(-6.5e-3, 6.5e-3):.9g}",
            "yaw": f"{chance.uniform(-0.01, 0.01):.9g}",
            "axle_load": f"{chance.uniform(60e3, 225e3):.9g}",
        }
        for _ in range(count)
    ]


def solved(command: str, case: Path, rows: list[Row]) -> list[Row]:
    """The rows as the command writes them."""
    given, out = case.with_name("rows.csv"), case.with_name("out.csv")
    with given.open("w", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)
    out.unlink(missing_ok=True)
    words = [command, "batch", "--case", str(case), "--in", str(given), "--out", str(out)]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 3):
        raise SystemExit(f"exit code {done.returncode}: {done.stderr[-500:]}")
    with out.open(newline="") as file:
        return list(csv.DictReader(file))


def processor() -> float:
    """Seconds of the processor that all runs so far have taken."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def main() -> None:
    """Solves the rows by both theories, and counts."""
    command, count = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 1000
    chance = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1967)
    alone = min(int(sys.argv[4]) if len(sys.argv) > 4 else 1000, count)
    rows = drawn(count, chance)
    with tempfile.TemporaryDirectory() as name:
        case = Path(name) / "case.toml"
        for theory, lines in THEORIES.items():
            case.write_text(CASE.read_text() + lines)
            began, used = time.perf_counter(), processor()
            together = solved(command, case, rows)
            seconds, used = time.perf_counter() - began, processor() - used
            statuses = Counter(row["status"] for row in together)
            print(f"{theory}: {len(together)} rows in {seconds:.0f} s, {used:.0f} s of the processor: {dict(statuses)}", flush=True)
            for k in [k for k, row in enumerate(together) if row["status"] != "solved"][:20]:
                print("NOT SOLVED:", rows[k], together[k]["status"], together[k]["message"])
            chosen = sorted(chance.sample(range(count), alone))
            differ = [k for k in chosen if solved(command, case, [rows[k]])[0] != together[k]]
            print(f"{theory}: of {alone} rows solved alone {len(differ)} differ", flush=True)
            for k in differ[:5]:
                print("DIFFERS:", rows[k])


if __name__ == "__main__":
    main()
