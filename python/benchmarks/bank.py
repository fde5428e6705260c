"""Input files of CONTACT beside the outputs that it stored: `python bank.py FOLDER COMMAND [--seconds S] [--only TEXT]`.

Every `.inp` below FOLDER goes through `creepage import`; every case that is written is solved by the command that the
import names, two at a time, each within S seconds (60). Where a `.ref_out` of the same name lies beside the input, its
forces and largest pressures stand beside ours: forces differ in % of `mu N`, normal forces and peak pressures in % of
their own, creepages and shifts that were found in % of the larger one. Printed digits of a stored output are four.

A history that begins another one of the same bodies is not solved twice: its last row is read in the longer one.

Printed: a row a case that was solved with what differs, the causes of those that were not written or not solved, and
counts by file and by folder.
"""

from __future__ import annotations

import argparse
import csv
import io
import json
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

# A difference above this, in %, is counted: forces over `mu N`, peaks over themselves.
APART = 1.0
NAN = float("nan")


@dataclass
class Numbers:
    """What a case comes to: forces of body 2 on body 1 as that program prints them, in newtons or per metre."""

    normal: float = NAN
    along: float = NAN
    across: float = NAN
    peak: float = NAN
    # Creepages or shifts that were found to given forces, by axis.
    found: dict[str, float] = field(default_factory=dict)
    friction: float = NAN
    # Of a wheel: the vertical force; the normal force is then the sum of those of its areas.
    vertical: float = NAN
    # Elements in contact of a stored output, the fewest of its areas.
    elements: int = 0
    # Its pressure is not that of a half-space (`B` 2 and above).
    is_simplified: bool = False


@dataclass
class Case:
    """A case of an input file."""

    name: str
    folder: str
    command: list[str] = field(default_factory=list)
    files: Path = Path()
    why: str = ""
    # `line` for cylinders.
    kind: str = ""
    seconds: float = 0.0
    numbers: Numbers | None = None
    stored: Numbers | None = None


# --- the stored output -----------------------------------------------------------------------------------------------


def number(word: str) -> float:
    """Their numbers: `1.098E+04`, `.3`, and stars where one had no room."""
    try:
        return float(word.replace("D", "E").replace("d", "e"))
    except ValueError:
        return NAN


def titles(lines: list[str], first: str) -> list[tuple[list[str], list[float]]]:
    """Headings that begin with a word, and the numbers under them."""
    found = []
    for line, under in zip(lines, lines[1:], strict=False):
        if re.match(rf"\s*{re.escape(first)}(\s|$)", line):
            names = re.split(r"\s{2,}", line.strip())
            if len(names) == 1 or "FS/FSTAT/FN" in line:
                names = re.split(r"\s{2,}|(?<=FN) (?=F)", line.strip())
            found.append((names, [number(word) for word in under.split()]))
    return found


def stored_cases(path: Path) -> dict[int, Numbers]:
    """The last state that a stored output tells of every case."""
    if not path.is_file():
        return {}
    text = path.read_text(errors="replace")
    parts = re.split(r"^ Case +(\d+)\s*$", text, flags=re.MULTILINE)
    return {
        int(case): numbers
        for case, body in zip(parts[1::2], parts[2::2], strict=True)
        if (numbers := stored_case(body.splitlines()))
    }


def stored_case(lines: list[str]) -> Numbers | None:
    """The last state of a case; of a wheel the sum over its areas."""
    begins = ("FN", "BAR_FN")
    forces = [row for first in begins for row in titles(lines, first) if {"FX", "BAR_FX"} & set(row[0])]
    states = titles(lines, "FN/G") + titles(lines, "TILDE_FN")
    if not forces or not states:
        return None
    told = [dict(zip(names, values, strict=False)) for names, values in states]
    # Backwards rolling is forwards here, with x and y turned.
    turned = [values[0] for names, values in titles(lines, "CHI") if names[:2] == ["CHI", "DQ"]]
    sign = -1.0 if turned and abs(turned[-1]) > 3.0 else 1.0
    counts = [int(values[1]) for names, values in titles(lines, "NPOT") if len(values) > 1]
    bound = re.search(r"BOUND +(\d)", "\n".join(lines))
    numbers = Numbers(friction=coefficient(lines, forces, told), elements=min(counts, default=0))
    numbers.is_simplified = bound is not None and int(bound[1]) >= 2
    if track := titles(lines, "FX(TR)"):
        along, across, vertical = track[-1][1][:3]
        normal = sum(values[0] for _, values in forces)
        peak = 1e6 * max(state.get("PMAX", NAN) for state in told)
        return replace(numbers, normal=normal, along=along, across=across, peak=peak, vertical=vertical)
    found = {}
    for axis in "xy":
        for kind, unit in (("CREEP", 1.0), ("SHIFT", 1.0)):
            if (value := told[-1].get(f"{kind} {axis.upper()}")) is not None:
                found[axis] = (sign if kind == "CREEP" else unit) * value
    normal, along, across = forces[-1][1][:3]
    along, across, peak = sign * along, sign * across, 1e6 * told[-1].get("PMAX", NAN)
    return replace(numbers, normal=normal, along=along, across=across, peak=peak, found=found)


def coefficient(lines: list[str], forces: list[tuple[list[str], list[float]]], told: list[dict[str, float]]) -> float:
    """Friction by a force and the same over `mu N`, where both are told, else as it is printed."""
    for (_, values), state in zip(forces, told, strict=False):
        for value, name in ((values[1], "FX/FSTAT/FN"), (values[2], "FY/FSTAT/FN"), (values[2], "FS/FSTAT/FN")):
            if abs(state.get(name) or 0.0) > 0.01:
                return abs(value / state[name] / values[0])
    printed = [values[0] for _, values in titles(lines, "FSTAT") if values]
    return printed[-1] if printed else NAN


# --- ours ------------------------------------------------------------------------------------------------------------


def options(command: list[str]) -> list[str]:
    return command if command[0] == "roll" else [*command, "--json"]


def solve(program: str, case: Case, seconds: float) -> None:
    """Solves a case and reads what it comes to."""
    begin = time.monotonic()
    try:
        done = subprocess.run(
            [program, *options(case.command)], cwd=case.files, capture_output=True, text=True, timeout=seconds
        )
    except subprocess.TimeoutExpired:
        case.why = f"no answer in {seconds:g} s"
        return
    finally:
        case.seconds = time.monotonic() - begin
    words = done.stderr.strip().splitlines()
    if done.returncode not in (0, 3) or "panicked" in done.stderr:
        case.why = words[-1] if words else f"exit code {done.returncode}"
        return
    if done.returncode == 3:
        case.why = "did not converge"
        return
    case.numbers = numbers_of(case.command[0], done.stdout, case)


def numbers_of(kind: str, out: str, case: Case, row: int = -1) -> Numbers:
    if kind == "roll":
        return of_history(out, case, row)
    report = json.loads(out)
    if kind == "wheelset":
        return of_wheel(report)
    if kind == "statics":
        return of_statics(report)
    return of_contact(report, case)


def of_history(out: str, case: Case, row: int) -> Numbers:
    rows = list(csv.DictReader(io.StringIO(out)))
    last = {key: number(value) for key, value in rows[row].items() if value}
    for side in ("right", "left"):
        if f"{side}_vertical_n" in last:
            along, across, down = (last[f"{side}_{name}_n"] for name in ("longitudinal", "lateral", "vertical"))
            peak = last[f"{side}_peak_pressure_pa"]
            return Numbers(last[f"{side}_normal_n"], along, across, peak, vertical=down)
    text = (case.files / case.command[1]).read_text()
    load = re.search(r"^(?:normal_force|line_load) = (\S+)", text, re.MULTILINE)
    # Over `mu N` the forces are dimensionless.
    normal = number(load[1]) if load else NAN
    history = list(csv.DictReader((case.files / case.command[3]).open()))
    if value := history[row].get("normal_force"):
        normal = number(value)
    return Numbers(normal, -last["longitudinal_n"], -last["lateral_n"], NAN)


def of_wheel(report: dict[str, Any]) -> Numbers:
    wheel = report["right"] or report["left"]
    force, patches = wheel["force"], wheel["patches"]
    normal = sum(patch["normal_force_n"] for patch in patches)
    peak = max((patch["peak_pressure_pa"] for patch in patches), default=NAN)
    along, across, down = force["longitudinal_n"], force["lateral_n"], force["vertical_n"]
    return Numbers(normal, along, across, peak, {}, report["friction"], down)


def of_statics(report: dict[str, Any]) -> Numbers:
    all_of_it = {**report["given"], **report["found"]}
    normal = all_of_it.get("normal_force_n", NAN)
    numbers = Numbers(normal, NAN, NAN, all_of_it.get("peak_pressure_pa", NAN), {}, all_of_it.get("friction", NAN))
    numbers.along = -all_of_it.get("force_x_n", 0.0)
    numbers.across = -all_of_it.get("force_y_n", 0.0)
    numbers.found = {"x": all_of_it.get("shift_x_m", NAN) * 1e3, "y": all_of_it.get("shift_y_m", NAN) * 1e3}
    if steps := report.get("steps"):
        along = all_of_it.get("along", "x")
        numbers.along = -float(steps[-1].get("force_n", NAN))
        # Of a path theirs is the shift of its last case alone.
        numbers.found = {str(along): float(steps[-1].get("shift_m", NAN)) * 1e3} if len(steps) == 1 else {}
    return numbers


def of_contact(report: dict[str, Any], case: Case) -> Numbers:
    if "line_load_n_per_m" in report:
        force, load = report["longitudinal_force_n_per_m"], report["line_load_n_per_m"]
        case.kind = "line"
        found = {"x": report["longitudinal_creepage"]}
        return Numbers(load, -force, 0.0, report["peak_pressure_pa"], found, report["friction"])
    contact = report.get("contact", report)
    normal, peak = contact["normal_force_n"], contact["peak_pressure_pa"]
    if "upper_body" not in report:
        return Numbers(normal, 0.0, 0.0, peak, {}, report.get("friction") or NAN)
    upper, creepage = report["upper_body"], report["creepage"]
    found = {"x": creepage["longitudinal"], "y": creepage["lateral"]}
    return Numbers(normal, upper["longitudinal_n"], upper["lateral_n"], peak, found, report["friction"])


# --- side by side ----------------------------------------------------------------------------------------------------


@dataclass
class Pair:
    """A number of ours beside the stored one."""

    name: str
    ours: float
    theirs: float
    # In %.
    apart: float


def pairs(case: Case) -> list[Pair]:
    """What both tell."""
    ours, theirs = case.numbers, case.stored
    if ours is None or theirs is None:
        return []
    is_wheel = theirs.vertical == theirs.vertical
    # Where nothing moves friction is nothing, and forces are compared with the load.
    mu = theirs.friction if theirs.friction == theirs.friction else 1.0
    kept = []
    for name, one, other in (("Fx", ours.along, theirs.along), ("Fy", ours.across, theirs.across)):
        if is_wheel:
            kept.append(Pair(name, one, other, 100 * abs(one - other) / (mu * theirs.normal)))
        else:
            one, other = one / ours.normal / mu, other / theirs.normal / mu
            kept.append(Pair(name, one, other, 100 * abs(one - other)))
    if is_wheel:
        apart = 100 * abs(ours.vertical - theirs.vertical) / theirs.normal
        kept.append(Pair("Fz", ours.vertical, theirs.vertical, apart))
    elif case.command[0] in ("solve", "hertz") and theirs.elements and "line" not in case.kind:
        kept.append(Pair("N", ours.normal, theirs.normal, 100 * abs(ours.normal / theirs.normal - 1)))
    if not theirs.is_simplified:
        kept.append(Pair("peak", ours.peak, theirs.peak, 100 * abs(ours.peak / theirs.peak - 1)))
    for axis, value in theirs.found.items():
        one = ours.found.get(axis, NAN)
        size = max(abs(value), abs(one))
        # Of a shift that is turned round both signs are right.
        apart = 100 * min(abs(one - value), abs(one + value) if case.command[0] == "statics" else NAN) / (size or 1.0)
        kept.append(Pair(f"found {axis}", one, value, apart))
    return [pair for pair in kept if pair.apart == pair.apart]


def bare(path: Path) -> str:
    """A case file without its comments."""
    return "\n".join(line for line in path.read_text().splitlines() if not line.startswith("#"))


def chains(cases: list[Case]) -> list[list[Case]]:
    """Cases together whose histories are the beginning of the last one's."""
    together: dict[tuple[str, str], list[Case]] = {}
    single = []
    for case in cases:
        if case.command[0] != "roll":
            single.append([case])
            continue
        text = bare(case.files / case.command[1])
        lines = (case.files / case.command[3]).read_text()
        for (other, history), chain in list(together.items()):
            if other == text and lines.startswith(history):
                del together[other, history]
                together[text, lines] = [*chain, case]
                break
        else:
            together[text, lines] = [case]
    return [*single, *together.values()]


def imported(program: str, path: Path, root: Path, out: Path) -> list[Case]:
    folder = path.parent.relative_to(root).as_posix()
    done = subprocess.run([program, "import", str(path), "--out", str(out)], capture_output=True, text=True)
    stored = stored_cases(path.with_suffix(".ref_out"))
    if done.returncode not in (0, 3):
        why = done.stderr.strip().splitlines()
        return [Case(path.stem, folder, why=f"not read: {why[-1] if why else done.returncode}")]
    cases = []
    for line in filter(None, done.stdout.splitlines()):
        words = shlex.split(line)[1:]
        name = Path(next(word for word in words if word.endswith(".toml"))).stem
        cases.append(Case(name, folder, words, out))
    for line in done.stderr.splitlines():
        if match := re.match(r"(\S+) \(line \d+\) is not written: (.*)", line):
            cases.append(Case(match[1], folder, why=f"not written: {match[2]}"))
    for case in cases:
        case.stored = stored.get(int(case.name.rsplit("-", 1)[1]))
    return sorted(cases, key=lambda case: int(case.name.rsplit("-", 1)[1]))


def run(program: str, chain: list[Case], seconds: float) -> None:
    last = chain[-1]
    solve(program, last, seconds * len(chain))
    if len(chain) == 1:
        return
    if last.numbers is None:
        for case in chain[:-1]:
            solve(program, case, seconds)
        return
    done = subprocess.run([program, *last.command], cwd=last.files, capture_output=True, text=True)
    for case in chain[:-1]:
        rows = sum(1 for _ in csv.DictReader((case.files / case.command[3]).open()))
        case.numbers = numbers_of("roll", done.stdout, case, rows - 1)


def told(case: Case) -> str:
    """What differs; numbers of both where it is more than a hundredth: ours, then the stored one."""
    words = [
        f"{pair.name} {pair.apart:.2f}" + (f" ({pair.ours:.4g}, {pair.theirs:.4g})" if pair.apart > APART else "")
        for pair in pairs(case)
    ]
    if case.stored is not None and words:
        words.append(f"{case.stored.elements} elements there" if case.stored.elements else "")
        words.append("a simplified pressure there (B)" if case.stored.is_simplified else "")
    return ", ".join(filter(None, words)) or "no output beside it"


def main() -> None:
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("folder", type=Path)
    asked.add_argument("command")
    asked.add_argument("--seconds", type=float, default=60.0, help="for one case")
    asked.add_argument("--only", default="", help="input files whose path has this text")
    given = asked.parse_args()
    root, program = given.folder.resolve(), str(Path(shutil.which(given.command) or given.command).resolve())
    with tempfile.TemporaryDirectory() as folder:
        cases: list[Case] = []
        for count, path in enumerate(sorted(root.rglob("*.inp"))):
            if given.only in path.as_posix():
                cases += imported(program, path, root, Path(folder) / str(count))
        written = [case for case in cases if case.command]
        groups = chains(written)
        with ThreadPoolExecutor(2) as pool:
            for place, _ in enumerate(pool.map(lambda chain: run(program, chain, given.seconds), groups)):
                if (place + 1) % 20 == 0:
                    print(f"{place + 1} of {len(groups)}", file=sys.stderr, flush=True)
    write(cases)


def write(cases: list[Case]) -> None:
    print("| case | folder | imported | solved | s | differs from the stored output by % |\n|---|---|---|---|--:|---|")
    for case in cases:
        solved = "yes" if case.numbers else "no"
        words = told(case) if case.numbers else case.why
        is_written = "yes" if case.command else "no"
        print(f"| {case.name} | {case.folder} | {is_written} | {solved} | {case.seconds:.1f} | {words} |")
    print("\n| file | cases | imported | solved | compared | within 1 % | forces within 1 % |\n|---|--:|--:|--:|--:|--:|--:|")
    counts: Counter[tuple[str, str]] = Counter()
    for case in cases:
        apart = [pair.apart for pair in pairs(case)]
        forces = [pair.apart for pair in pairs(case) if pair.name in ("Fx", "Fy", "Fz", "N")]
        marks = {
            "cases": True,
            "imported": bool(case.command),
            "solved": case.numbers is not None,
            "compared": bool(apart),
            "within": bool(apart) and max(apart) <= APART,
            "forces": bool(forces) and max(forces) <= APART,
        }
        for file in (f"{case.folder}/{case.name.rsplit('-', 1)[0]}", "all of these"):
            counts.update({(file, mark): int(holds) for mark, holds in marks.items()})
    for file in sorted(dict.fromkeys(file for file, _ in counts), key=lambda file: file == "all of these"):
        row = " | ".join(str(counts[file, mark]) for mark in ("cases", "imported", "solved", "compared", "within", "forces"))
        print(f"| {file} | {row} |")


if __name__ == "__main__":
    main()
