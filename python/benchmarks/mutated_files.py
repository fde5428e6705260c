"""What the command does with files that are damaged: `python mutated_files.py COMMAND [COUNT] [SEED]`.

Every example is damaged in one to four places (a number scaled, negated, made 0, `nan` or `inf`; a line dropped,
repeated or exchanged; bytes changed, dropped or repeated; the end cut off), and given to the command that solves it.
Counted: solved, refused with a message and exit code 2, stopped after the time allowed; and what must not be: a panic,
another exit code, `NaN` in an answer that counts as solved, a force beyond friction, a file left half-written, a case
file changed.
"""

from __future__ import annotations

import json
import math
import random
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

EXAMPLES = Path(__file__).parents[2] / "examples"
# Seconds that a damaged file may take: a number scaled by a thousand may ask for a long work.
ALLOWED = 60
# Forces beyond `mu N` by rounding.
BEYOND = 1 + 1e-9


def command_line(command: str, case: Path, out: Path) -> list[str]:
    """How an example of this folder is solved."""
    folder = case.parent.name
    if folder == "catalogue":
        return [command, "sweep", str(case), "--out", str(out / "series.csv")]
    if folder in ("wheelset", "statics", "bearing"):
        words = [folder, str(case)]
    elif folder == "roll":
        history = {"crowned-roller": "crowned-roller.csv", "cylinders": "cylinders.csv"}.get(case.stem, "pulls.csv")
        words = ["roll", str(case), "--history", str(case.parent / history)]
    else:
        words = ["solve", str(case)]
    return [command, *words, "--out", str(out)]


def damaged_once(text: bytes, draw: random.Random) -> bytes:
    lines = text.split(b"\n")
    kind = draw.randrange(8)
    at = draw.randrange(len(lines))
    if kind <= 2:  # a number
        numbers = [i for i, line in enumerate(lines) if any(c in b"0123456789" for c in line)]
        if not numbers:
            return text
        at = draw.choice(numbers)
        words = lines[at].replace(b",", b" , ").replace(b"[", b"[ ").replace(b"]", b" ]").split(b" ")
        places = [i for i, word in enumerate(words) if is_number(word)]
        if not places:
            return text
        place = draw.choice(places)
        value = float(words[place])
        factor = draw.choice([1e-6, 1e-3, 0.1, 0.5, 2.0, 10.0, 1e3, 1e6, -1.0, 0.0, math.nan, math.inf])
        words[place] = repr(value * factor).encode()
        lines[at] = b" ".join(words)
        return b"\n".join(lines)
    if kind == 3:
        del lines[at]
        return b"\n".join(lines)
    if kind == 4:
        lines.insert(draw.randrange(len(lines)), lines[at])
        return b"\n".join(lines)
    if kind == 5:
        other = draw.randrange(len(lines))
        lines[at], lines[other] = lines[other], lines[at]
        return b"\n".join(lines)
    if not text:
        return text
    place, length = draw.randrange(len(text)), draw.randrange(1, 20)
    if kind == 6:
        return text[:place] + bytes([draw.randrange(256)]) + text[place + draw.randrange(2) :]
    return text[:place] + (text[place + length :] if draw.random() < 0.7 else b"")


def is_number(word: bytes) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True


def numbers(value: object, path: str = "") -> list[tuple[str, float]]:
    """All numbers of a report with their keys."""
    if isinstance(value, dict):
        return [found for key, inner in value.items() for found in numbers(inner, f"{path}.{key}")]
    if isinstance(value, list):
        return [found for inner in value for found in numbers(inner, path)]
    return [(path, float(value))] if isinstance(value, int | float) and not isinstance(value, bool) else []


def faults_of(report: dict[str, object]) -> list[str]:
    """What must not be in an answer."""
    found = [f"not finite: {path}" for path, value in numbers(report) if not math.isfinite(value)]
    dimensionless, theory = report.get("dimensionless"), report.get("theory")
    used = dimensionless.get("friction_used") if isinstance(dimensionless, dict) else None
    # The linear theory has no bound.
    if isinstance(used, float) and used > BEYOND and theory != "linear":
        found.append("force beyond friction")
    return found


def tried(command: str, case: Path, seed: int) -> tuple[str, str]:
    """What came of one damaged file: a verdict, and what shows it."""
    draw = random.Random(seed)
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder) / case.parent.name
        shutil.copytree(case.parent, place) if case.parent != EXAMPLES else place.mkdir()
        # A file that the case names may be the damaged one.
        beside = [f for f in place.rglob("*") if f.suffix in (".csv", ".toml") and f.stem == case.stem]
        shutil.copy(case, place / case.name)
        target = draw.choice([place / case.name] * 3 + beside)
        text = target.read_bytes()
        for _ in range(draw.randrange(1, 5)):
            text = damaged_once(text, draw)
        target.write_bytes(text)
        out = Path(folder) / "out"
        out.mkdir()
        words = command_line(command, place / case.name, out)
        try:
            done = subprocess.run(words, capture_output=True, timeout=ALLOWED, env={"RAYON_NUM_THREADS": "1"})
        except subprocess.TimeoutExpired:
            return "stopped after the time allowed", f"{case.name} {seed}"
        said = done.stderr.decode(errors="replace")
        shown = f"{case.name} {seed}: {said.strip()[:300]}"
        if "panicked" in said or done.returncode < 0 or done.returncode == 101:
            return "PANIC", shown
        if any(f.suffix == ".partial" or f.name.startswith(".") for f in out.rglob("*")):
            return "LEFT HALF-WRITTEN", shown
        if target.read_bytes() != text:
            return "CASE FILE CHANGED", shown
        if done.returncode == 2:
            if not said.strip():
                return "REFUSED WITHOUT A WORD", shown
            left = [f for f in out.rglob("*") if f.is_file()]
            return ("WROTE THOUGH REFUSED", f"{shown} {left}") if left else ("refused", "")
        if done.returncode != 0:
            return f"exit code {done.returncode}", shown
        for file in out.rglob("report.json"):
            faults = faults_of(json.loads(file.read_text()))
            if faults:
                return faults[0].upper(), f"{shown} {faults[:3]}"
        return "solved with a caution" if said.strip() else "solved", ""


def main() -> None:
    command = str(Path(sys.argv[1]).resolve())
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 16_000
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    # What takes minutes undamaged, and what is no case of its own.
    left_out = {"slices", "wear"}
    cases = [f for f in sorted(EXAMPLES.rglob("*.toml")) if not left_out & set(f.relative_to(EXAMPLES).parts)]
    tally: Counter[str] = Counter()
    with ThreadPoolExecutor(2) as pool:
        jobs = [pool.submit(tried, command, cases[i % len(cases)], seed * 1_000_003 + i) for i in range(count)]
        for number, job in enumerate(jobs, 1):
            verdict, shown = job.result()
            tally[verdict] += 1
            if shown:
                print(f"{verdict}: {shown}", flush=True)
            if number % 500 == 0:
                print(f"{number} of {count}: {dict(tally)}", file=sys.stderr, flush=True)
    print(f"{count} damaged files of {len(cases)} examples, seed {seed}:")
    for verdict, times in tally.most_common():
        print(f"  {verdict}: {times}")


if __name__ == "__main__":
    main()
