"""Whether two builds of the command give the same numbers: what one printed is recorded, then compared.

    python python/benchmarks/same_numbers.py record COMMAND OUT [DIRECTORY ...]
    python python/benchmarks/same_numbers.py compare BEFORE AFTER

Recorded are the report of every case file in the directories (by default `examples`), a table of random ellipses by every
theory, curves and the coefficients of linear theory. Compared are numbers and words; the largest difference of each
recording is that of a number over the larger of the two and over the largest number under the same key of the report's
part, so that what is zero but for rounding does not count.
"""

import json
import math
import random
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).parents[2]
ROWS = 132
SEED = 1967
TIMEOUT = 300.0


def printed(command: str, *arguments: str, text: str | None = None) -> str:
    """Standard output, or why there is none; the exit code is part of it."""
    try:
        run = subprocess.run(
            [command, *arguments], input=text, capture_output=True, text=True, timeout=TIMEOUT, check=False
        )
    except subprocess.TimeoutExpired:
        return f"no answer in {TIMEOUT} s"
    return run.stdout if run.returncode in (0, 3) else f"exit code {run.returncode}\n{run.stderr}"


def rows() -> str:
    """Ellipses of any ratio with creepage and spin: half of them small, half up to full sliding."""
    draw = random.Random(SEED)
    lines = ["a_over_b,poisson,xi,eta,chi"]
    for _ in range(ROWS):
        ratio, size = 10 ** draw.uniform(-1, 1), 10 ** draw.uniform(-2, 0.5)
        parts = [size * draw.uniform(-1, 1) for _ in range(3)]
        lines.append(",".join(repr(value) for value in (ratio, draw.uniform(0, 0.5), *parts)))
    return "\n".join(lines) + "\n"


def kind(text: str) -> str | None:
    """The subcommand that solves a file; None for what is solved over tables."""
    if "[statics]" in text:
        return "statics"
    if "[bearing]" in text:
        return "bearing"
    if "[wheelset]" in text:
        return "wheelset"
    is_series = any(section in text for section in ("[sweep]", "[roll]", "[wear]", "[loops]"))
    return None if is_series else "solve"


def record(command: str, out: Path, directories: list[str]) -> None:
    out.mkdir(parents=True, exist_ok=True)
    jobs: list[tuple[str, tuple[str, ...], str | None]] = []
    for directory in directories or [str(ROOT / "examples")]:
        for path in sorted(Path(directory).rglob("*.toml")):
            name = "_".join(path.relative_to(Path(directory).parent).with_suffix("").parts)
            if subcommand := kind(path.read_text(encoding="utf-8")):
                jobs.append((f"{name}.json", (subcommand, str(path), "--json"), None))
                if subcommand == "statics":
                    jobs.append((f"{name}.txt", (subcommand, str(path)), None))
    for theory in json.loads(printed(command, "theories", "--json")):
        name = theory["name"]
        jobs.append((f"batch_{name}.csv", ("batch", "--theory", name), rows()))
    wheel = str(ROOT / "examples" / "wheel-on-rail.toml")
    for vary in ("longitudinal", "lateral", "spin"):
        theories = "exact,fastsim,polach,linear"
        jobs.append((f"curve_{vary}.csv", ("curve", wheel, "--vary", vary, "--theory", theories), None))
    for ratio in ("0.1", "1", "4"):
        arguments = ("coefficients", "--a-over-b", ratio, "--poisson", "0.28", "--json")
        jobs.append((f"coefficients_{ratio}.json", arguments, None))
        jobs.append((f"coefficients_{ratio}_wave.json", (*arguments, "--wavelength", "3"), None))

    def run(job: tuple[str, tuple[str, ...], str | None]) -> None:
        name, arguments, text = job
        (out / name).write_text(printed(command, *arguments, text=text), encoding="utf-8")

    with ThreadPoolExecutor(2) as pool:
        list(pool.map(run, jobs))
    print(f"{len(jobs)} recorded in {out}")


def numbers(value: object, path: str = "") -> dict[str, object]:
    """Everything of a report by its path."""
    if isinstance(value, dict):
        return {k: v for key, one in value.items() for k, v in numbers(one, f"{path}.{key}").items()}
    if isinstance(value, list):
        return {k: v for i, one in enumerate(value) for k, v in numbers(one, f"{path}.{i}").items()}
    return {path: value}


def read(path: Path) -> dict[str, object]:
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".json" and text.startswith(("{", "[")):
        return numbers(json.loads(text))
    found: dict[str, object] = {}
    for i, line in enumerate(text.splitlines()):
        for k, cell in enumerate(line.split(",") if path.suffix == ".csv" else [line]):
            try:
                found[f"{i}.{k}"] = float(cell)
            except ValueError:
                found[f"{i}.{k}"] = cell
    return found


def compare(before: Path, after: Path) -> None:
    names = sorted({path.name for place in (before, after) for path in place.iterdir()})
    worst, differing = 0.0, 0
    for name in names:
        if not ((before / name).exists() and (after / name).exists()):
            print(f"{name}: in one recording only")
            differing += 1
            continue
        one, other = read(before / name), read(after / name)
        words = [key for key in sorted(one.keys() ^ other.keys())]
        scales: dict[str, float] = {}
        for key, value in one.items():
            if isinstance(value, float):
                column = key.rsplit(".", 1)[-1]
                scales[column] = max(scales.get(column, 0.0), abs(value) if math.isfinite(value) else 0.0)
        largest, place = 0.0, ""
        for key in one.keys() & other.keys():
            p, q = one[key], other[key]
            numbers = (p, q) if isinstance(p, float) and isinstance(q, float) else None
            if numbers and all(math.isfinite(number) for number in numbers):
                scale = scales[key.rsplit(".", 1)[-1]]
                part = abs(numbers[0] - numbers[1]) / scale if scale > 0.0 else 0.0
                if part > largest:
                    largest, place = part, key
            elif p != q and not (numbers and all(math.isnan(number) for number in numbers)):
                words.append(key)
        if largest > 0.0 or words:
            differing += 1
            said = f"; words: {', '.join(words[:6])}" if words else ""
            print(f"{name}: {largest:.1e} {place}{said}")
        worst = max(worst, largest)
    print(f"{len(names)} compared, {len(names) - differing} the same to the last bit, largest difference {worst:.1e}")


if __name__ == "__main__":
    if sys.argv[1] == "record":
        record(sys.argv[2], Path(sys.argv[3]), sys.argv[4:])
    else:
        compare(Path(sys.argv[2]), Path(sys.argv[3]))
