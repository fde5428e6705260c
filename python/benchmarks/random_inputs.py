"""Valid inputs at random, and laws that hold for each: `python random_inputs.py COMMAND [COUNT] [SEED]`.

Ellipses, unlike bodies and gaps of two waves, with every theory that takes them, creepage and spin of any size. Each is
solved by the command together with its images:

- mirrored (lateral creepage and spin change sign): lateral force and moment change sign,
- scaled (lengths times 2, loads times 4, spin over 2): forces times 4, moments times 8,
- moved a little (creepage by a millionth of what slides): forces move by no more than their slope and error bar allow,
- heat: force times creepage is what traction times slip is, where a report has both.

Printed: how many were solved, refused and why, and how often each law failed, with the worst.
"""

from __future__ import annotations

import json
import math
import random
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path
from typing import Any

SIMPLIFIED = ["linear", "shen-hedrick-elkins", "polach", "vermeulen-johnson", "saturated", "strip", "fastsim", "fastrip"]
THEORIES = [*SIMPLIFIED, "exact", "exact", "exact", "variational"]
ON_GAPS = ["exact", "exact", "linear", "saturated", "fastsim", "fastrip"]

# What each law may miss, of mu N (of mu N c for moments); where an answer has an error bar, that as well.
# Mirror images are the same arithmetic but for the order of sums; scaled ones meet other roundings, and
# iterations stop elsewhere (1e-6 of mu N); of gaps, the pressing's tolerance of 1e-4 comes on top.
MIRROR, SCALING, ON_GAP = 1e-6, 1e-5, 1e-3
# The heat's two sums: by slip of elements, and by forces.
HEAT = 0.005


def of_size(draw: random.Random, low: float, high: float) -> float:
    return math.exp(draw.uniform(math.log(low), math.log(high)))


def case_of(draw: random.Random) -> dict[str, Any]:
    """One input, in SI units."""
    kind = draw.choice(["ellipse", "ellipse", "unlike", "gap"])
    steel = (82e9, 0.28)
    radii = [of_size(draw, 0.05, 2.0), of_size(draw, 0.05, 2.0)]
    load = of_size(draw, 1e3, 150e3)
    friction = draw.uniform(0.05, 0.6)
    size = of_size(draw, 1e-5, 1e-2)
    angle = draw.uniform(0, 2 * math.pi)
    return {
        "kind": kind,
        "upper": steel if kind != "unlike" else (of_size(draw, 1e9, 200e9), draw.uniform(0.1, 0.45)),
        "lower": steel,
        "radii": radii,
        # The gap's wave: amplitude and number over x and y, as polynomials of degree 4.
        "quartic": of_size(draw, 1e2, 1e5),
        "load": load,
        "friction": friction,
        "creepage": [size * math.cos(angle), size * math.sin(angle), draw.choice([-1, 1]) * of_size(draw, 1e-4, 1.0)],
        "theory": draw.choice(ON_GAPS if kind == "gap" else THEORIES),
    }


def text_of(case: dict[str, Any], scale: float = 1.0) -> str:
    """The case file, with lengths so many times as long."""
    upper, lower = (f"shear_modulus = {g!r}\npoisson = {nu!r}\n" for g, nu in (case["upper"], case["lower"]))
    one, other = case["radii"]
    if case["kind"] == "gap":
        terms = [[2, 0, 0.5 / one / scale], [0, 2, 0.5 / other / scale], [0, 4, case["quartic"] / scale**3]]
        bodies = f"[upper]\n{upper}[lower]\n{lower}[gap]\npolynomial = {terms}\n"
    else:
        bodies = (
            f'[upper]\n{upper}radius_rolling = {one * scale!r}\nradius_lateral = "flat"\n'
            f'[lower]\n{lower}radius_rolling = "flat"\nradius_lateral = {other * scale!r}\n'
        )
    along, across, spin = case["creepage"]
    return (
        f"{bodies}[contact]\nnormal_force = {case['load'] * scale**2!r}\nfriction = {case['friction']!r}\n"
        f"[creepage]\nlongitudinal = {along!r}\nlateral = {across!r}\nspin = {spin / scale!r}\nspeed = 10.0\n"
        f'[solve]\ntheory = "{case["theory"]}"\n'
    )


def images(case: dict[str, Any]) -> dict[str, str]:
    along, across, spin = case["creepage"]
    moved = [along * (1 + 1e-6), across * (1 + 1e-6), spin * (1 + 1e-6)]
    return {
        "case": text_of(case),
        "mirrored": text_of({**case, "creepage": [along, -across, -spin]}),
        "scaled": text_of(case, 2.0),
        "moved": text_of({**case, "creepage": moved}),
    }


def solved(command: str, texts: dict[str, str], folder: Path) -> tuple[dict[str, Any], str]:
    """Reports of all images, or the cause why not."""
    reports = {}
    for name, text in texts.items():
        file = folder / f"{name}.toml"
        file.write_text(text)
        done = subprocess.run([command, "solve", str(file), "--json"], capture_output=True, text=True, timeout=300)
        if done.returncode not in (0, 2, 3) or "panicked" in done.stderr:
            return {}, f"PANIC or exit code {done.returncode}: {done.stderr[:300]}"
        if done.returncode == 2:
            return {}, f"refused: {done.stderr.strip().splitlines()[-1][:100] if done.stderr.strip() else 'no word'}"
        reports[name] = json.loads(done.stdout)
    return reports, ""


def unit(report: dict[str, Any]) -> tuple[float, float]:
    """`mu N`, and `c`: of any area the radius of the circle as large."""
    contact = report["contact"]
    area = contact.get("area_m2") or math.pi * contact["semi_axis_rolling_m"] * contact["semi_axis_lateral_m"]
    return report["friction"] * contact["normal_force_n"], math.sqrt(area / math.pi)


def dimensionless(report: dict[str, Any], error: str = "") -> list[float]:
    """Forces on the lower body over `mu N`, moment over `mu N c`; or their error bars, 0 for a report without them."""
    force, length = unit(report)
    found = report["lower_body"]
    names = [f"longitudinal{error}_n", f"lateral{error}_n", f"moment{error}_n_m"]
    x, y, z = (found.get(name) or 0.0 for name in names)
    return [x / force, y / force, z / force / length]


def misses(case: dict[str, Any], reports: dict[str, Any]) -> dict[str, float]:
    """By how many times what is allowed each law is missed."""
    force = {name: dimensionless(report) for name, report in reports.items()}
    bars = dimensionless(reports["case"], "_error")
    pressed = ON_GAP if case["kind"] == "gap" else 0.0
    own, mirrored, scaled, moved = (force[name] for name in ("case", "mirrored", "scaled", "moved"))
    signs = [1, -1, -1]
    size = max(abs(x) for x in own)
    worst = {
        "mirror": max(abs(a - s * b) / (MIRROR + pressed) for a, s, b in zip(own, signs, mirrored, strict=True)),
        "scaling": max(abs(a - b) / (SCALING + pressed) for a, b in zip(own, scaled, strict=True)),
        "continuity": max(abs(a - b) / (SCALING * (1 + size) + e) for a, b, e in zip(own, moved, bars, strict=True)),
        "friction": 0.0 if case["theory"] == "linear" else math.hypot(own[0], own[1]) / (1 + 1e-9),
    }
    # Theories without a field, and bodies whose coupling dissipates elsewhere, have one of the two only.
    report = reports["case"]
    by_force, by_slip = (report.get(f"frictional_power_per_metre{k}_j_per_m") for k in ("", "_by_slip"))
    if case["theory"] == "exact" and by_force and by_slip:
        worst["heat"] = abs(by_slip / by_force - 1) / HEAT
    return worst


def main() -> None:
    command = str(Path(sys.argv[1]).resolve())
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 3000
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    statuses: Counter[str] = Counter()
    failed: Counter[str] = Counter()
    checked: Counter[str] = Counter()
    worst: dict[str, tuple[float, str]] = {}
    for number in range(count):
        case = case_of(random.Random(seed * 1_000_003 + number))
        with tempfile.TemporaryDirectory() as folder:
            reports, why = solved(command, images(case), Path(folder))
        if why:
            statuses[why] += 1
            continue
        statuses[" / ".join(sorted({report["status"] for report in reports.values()}))] += 1
        if any(report["status"] != "solved" for report in reports.values()):
            continue
        for law, miss in misses(case, reports).items():
            kind = f"{law}, {case['kind']}"
            checked[kind] += 1
            failed[kind] += miss > 1
            if miss > worst.get(kind, (0.0, ""))[0]:
                worst[kind] = (miss, f"{case['theory']} number {number}")
        if (number + 1) % 200 == 0:
            print(f"{number + 1} of {count}", file=sys.stderr, flush=True)
    print(f"{count} random inputs, each with three images, seed {seed}:")
    for status, times in statuses.most_common():
        print(f"  {status}: {times}")
    print("| law, kind | checked | failed | worst, of what is allowed | by |\n|---|--:|--:|--:|---|")
    for kind in sorted(checked):
        miss, by = worst.get(kind, (0.0, ""))
        print(f"| {kind} | {checked[kind]} | {failed[kind]} | {miss:.3g} | {by} |")


if __name__ == "__main__":
    main()
