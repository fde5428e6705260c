"""A survey of many wheels, most of them with a fault: `python survey_files.py COMMAND [COUNT] [SEED]`.

Wheels are S1002 after wear of their own, as MiniProf files or columns. Two of three have a fault: noise, spikes, a hole, points
twice, out of order or mirrored, metres or inches in a file of millimetres, `nan`, words, a cut end, no points, a few, bytes.
The survey is killed three times and started again. Counted: rows that were measured, measured with a note, and refused with
their cause, by fault; and what must not be: a file without a row or with two, a row without numbers and without a cause, flange
heights that are not those of a wheel without a note, a fault that changes the profile by more than 1 mm without a note.
"""

from __future__ import annotations

import csv
import math
import random
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

Points = list[tuple[float, float]]
FAULTS = (
    "noise", "spikes", "hole", "twice", "order", "mirrored", "metres", "inches", "nan", "words", "cut", "empty", "few", "bytes",
)  # fmt: skip
# With these the wheel is there no longer, or is another one: a number without a word would be wrong.
MUST_SAY = {"spikes", "words", "nan", "empty", "few", "bytes", "metres", "inches"}


def wheel(command: str, place: Path) -> Points:
    """The new profile (mm)."""
    subprocess.run([command, "profile", "S1002", "--convert", "columns", "--out", str(place)], check=True, capture_output=True)
    lines = next(place.glob("*.txt")).read_text().splitlines()
    rows = [line.split() for line in lines if line and (line[0].isdigit() or line[0] in " -")]
    return [(float(y), float(z)) for y, z, *_ in rows]


def worn(points: Points, chance: random.Random) -> Points:
    """Hollow tread and a thinner flange (mm)."""
    hollow, middle, width = chance.uniform(0.0, 3.0), chance.uniform(-5.0, 10.0), chance.uniform(12.0, 25.0)
    lift = 1.0 if points[len(points) // 2][1] >= 0 else -1.0
    return [(y, z - lift * hollow * math.exp(-(((y - middle) / width) ** 2))) for y, z in points]


def damaged(points: Points, fault: str, chance: random.Random) -> bytes:
    """The text of a file with this fault."""
    if fault == "noise":
        points = [(y, z + chance.gauss(0.0, 0.03)) for y, z in points]
    elif fault == "spikes":
        points = [(y, z + (chance.choice((-8.0, 8.0)) if chance.random() < 0.01 else 0.0)) for y, z in points]
        k = len(points) // 2
        points[k] = (points[k][0], points[k][1] + 8.0)
    elif fault == "hole":
        first = chance.randrange(len(points) // 4, len(points) // 2)
        del points[first : first + len(points) // 20]
    elif fault == "twice":
        points = [point for point in points for _ in range(2)]
    elif fault == "order":
        k = chance.randrange(len(points) - 4)
        points[k : k + 4] = points[k : k + 4][::-1]
    elif fault == "mirrored":
        points = [(-y, z) for y, z in points]
    elif fault in ("metres", "inches"):
        unit = 1e-3 if fault == "metres" else 1 / 25.4
        points = [(unit * y, unit * z) for y, z in points]
    elif fault == "few":
        points = points[:: max(len(points) // 3, 1)][:3]
    elif fault == "empty":
        points = []
    lines = [f"{y:.6f} {z:.6f}" for y, z in points]
    if fault == "nan":
        lines[len(lines) // 3] = "nan nan"
    elif fault == "words":
        lines[len(lines) // 3] = "end of measurement?"
    elif fault == "cut":
        return "\n".join(lines).encode()[: -chance.randrange(3, 40)]
    elif fault == "bytes":
        return chance.randbytes(2000)
    return ("\n".join(lines) + "\n").encode()


def main() -> None:
    """Writes the files, surveys them, and counts."""
    command, count = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 500
    chance = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1967)
    with tempfile.TemporaryDirectory() as name:
        place = Path(name)
        new = wheel(command, place / "new")
        faults: dict[str, str] = {}
        (place / "wheels").mkdir()
        for k in range(count):
            fault = chance.choice(FAULTS) if k % 3 else "none"
            file = place / "wheels" / f"{k:05}.txt"
            file.write_bytes(damaged(worn(list(new), chance), fault, chance))
            faults[file.name] = fault
        out = place / "fleet.csv"
        words = [command, "profile", "--survey", str(place / "wheels" / "*.txt"), "--role", "wheel", "--rail", "UIC60"]
        words += ["--reference", "S1002", "--out", str(out)]
        began = time.perf_counter()
        for _ in range(3):
            run = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            time.sleep(max(0.3, count / 250))
            run.send_signal(signal.SIGKILL)
            run.wait()
            if out.exists():
                print("it ended before it was killed: give more files")
        done = subprocess.run(words, capture_output=True, text=True, check=False)
        seconds = time.perf_counter() - began
        if done.returncode not in (0, 3):
            print(f"WRONG: exit code {done.returncode}: {done.stderr[-500:]}")
        with out.open(newline="") as file_of_rows:
            rows = list(csv.DictReader(file_of_rows))
        print(f"{len(rows)} rows of {count} files, {seconds:.0f} s, killed three times; columns {', '.join(rows[0])}")
        counted: Counter[tuple[str, str]] = Counter()
        wrong: list[str] = []
        seen = Counter(Path(row["file"]).name for row in rows)
        wrong += [f"{file}: {seen[file]} rows" for file in faults if seen[file] != 1]
        for row in rows:
            fault = faults[Path(row["file"]).name]
            height = row.get("flange_height_m") or ""
            note, cause = row.get("notes") or "", row.get("error") or ""
            if not height and not cause:
                wrong.append(f"{row['file']} ({fault}): neither numbers nor a cause")
            if height and not 0.02 < float(height) < 0.04 and not note:
                wrong.append(f"{row['file']} ({fault}): a flange of {height} m without a note")
            if height and fault in MUST_SAY and not note:
                wrong.append(f"{row['file']} ({fault}): no word")
            counted[fault, "refused" if cause else "noted" if note else "measured"] += 1
        for fault in ("none", *FAULTS):
            print(f"  {fault:9}", ", ".join(f"{n} {what}" for (of, what), n in sorted(counted.items()) if of == fault))
        for one in wrong[:20]:
            print("WRONG:", one)
        print(f"{len(wrong)} wrong")


if __name__ == "__main__":
    main()
