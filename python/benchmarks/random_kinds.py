"""Random inputs of five kinds, and laws that hold: `python random_kinds.py COMMAND [COUNT] [SEED] [KIND]...`.

COUNT (1,000) of each kind, solved by the command or told why not:

- `curved`: bodies in grooves, half of them solved on the curve (`surface = "curved"`),
- `slices`: a wheel with flat, waves or both, on a rail with corrugation or slices, anywhere around and along,
- `heat`: sliding and rolling bodies of any material, bulk temperatures, friction that falls with temperature,
- `viscoelastic`: cylinders that relax slowly or at once, by a creepage or a force,
- `load-paths`: a shift to and fro, half of them under loads that change.

Laws: the mirror image (lateral motion, or the side of the track, or the sense of a path) has the mirrored answer; no
force is beyond friction; heat is not negative; what goes into both bodies is what friction makes, and warms. Printed by kind: how many
were solved, refused and why, and how often each law failed, with the worst.
"""

from __future__ import annotations

import json
import math
import random
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

Report = dict[str, Any]
# Seconds for one input.
ALLOWED = 60
# Of `mu N`, or of the answer: mirror images are the same arithmetic in another order. Areas that are pressed by elements
# or found under a load are found to 1e-4; a path turns where its bits do.
MIRROR = {"curved": 1e-3, "slices": 2e-3, "heat": 1e-6, "viscoelastic": 1e-9, "load-paths": 1e-9}
BEYOND = 1 + 1e-6


def of_size(draw: random.Random, low: float, high: float) -> float:
    return math.exp(draw.uniform(math.log(low), math.log(high)))


def body(name: str, modulus: float, poisson: float, more: str = "") -> str:
    return f"[{name}]\nshear_modulus = {modulus!r}\npoisson = {poisson!r}\n{more}"


def steel(more: tuple[str, str] = ("", "")) -> str:
    return body("upper", 82e9, 0.28, more[0]) + body("lower", 82e9, 0.28, more[1])


def curved(draw: random.Random) -> Callable[[int], tuple[str, str]]:
    outer = of_size(draw, 5e-3, 50e-3)
    inner = outer / (1 + of_size(draw, 2e-3, 0.5))
    rolling = of_size(draw, 0.02, 1.0)
    load = of_size(draw, 100.0, 30e3)
    friction = draw.uniform(0.05, 0.6)
    motion = [draw.choice([-1, 1]) * of_size(draw, 1e-5, 1e-2) for _ in range(2)]
    spin = draw.choice([-1, 0, 1]) * of_size(draw, 1e-3, 1.0)
    surface = draw.choice(["plane", "curved"])

    def text(sense: int) -> tuple[str, str]:
        return "solve", (
            f"{steel()}[gap]\ngroove = {{ inner = {inner!r}, outer = {outer!r}, rolling = {rolling!r} }}\n"
            f'[contact]\nnormal_force = {load!r}\nfriction = {friction!r}\nsurface = "{surface}"\n'
            f"[creepage]\nlongitudinal = {motion[0]!r}\nlateral = {sense * motion[1]!r}\nspin = {sense * spin!r}\n"
            '[solve]\nresolution = "fast"\n'
        )

    return text


def slices(draw: random.Random) -> Callable[[int], tuple[str, str]]:
    wheel, rail = "", ""
    radius = draw.uniform(0.35, 0.5)
    if draw.random() < 0.5:
        shape, depth = draw.choice(["chord", "haversine"]), of_size(draw, 5e-5, 1.2e-3)
        # A worn flat is met at one place where it is longer than pi sqrt(2 d R).
        length = math.sqrt(8 * radius * depth) * draw.uniform(1.0, 2.0)
        # The depth of a chord follows from its length.
        deep = f"depth = {depth!r}, " if shape == "haversine" else ""
        wheel = f'flat = {{ length = {length!r}, {deep}angle = 0.0, shape = "{shape}" }}\n'
    else:
        order, amplitude = draw.randint(1, 30), of_size(draw, 1e-6, 3e-4)
        wheel = f"waviness = [{{ order = {order}, amplitude = {amplitude!r}, phase = {draw.uniform(0, 6)!r} }}]\n"
    if draw.random() < 0.5:
        length, amplitude = of_size(draw, 0.03, 1.0), of_size(draw, 1e-6, 1e-4)
        rail = f"corrugation = [{{ wavelength = {length!r}, amplitude = {amplitude!r}, phase = 0.0 }}]\n"
    y, yaw, roll = draw.uniform(-6e-3, 6e-3), draw.uniform(-5e-3, 5e-3), draw.uniform(-1e-3, 1e-3)
    s, pitch = draw.uniform(-1, 1), draw.uniform(-0.15, 0.15)
    load, friction = of_size(draw, 5e3, 150e3), draw.uniform(0.1, 0.6)

    def text(sense: int) -> tuple[str, str]:
        side = "right" if sense > 0 else "left"
        return "wheelset", (
            f'[wheel]\nprofile = "S1002"\nradius = {radius!r}\n{wheel}[rail]\nprofile = "UIC60"\ncant = 0.025\n{rail}'
            "[track]\ngauge = 1.435\ngauge_height = 0.014\n"
            f'[wheelset]\nback_to_back = 1.360\nside = "{side}"\ny = {sense * y!r}\nyaw = {sense * yaw!r}\n'
            f"roll = {sense * roll!r}\nwheel_load = {load!r}\ns = {s!r}\npitch = {pitch!r}\n"
            f'[motion]\nspeed = 20.0\npitch_rate = "free"\n[contact]\nfriction = {friction!r}\n'
            '[materials]\nshear_modulus = 82e9\npoisson = 0.28\n[solve]\nresolution = "fast"\n'
        )

    return text


def heat(draw: random.Random) -> Callable[[int], tuple[str, str]]:
    sizes = [of_size(draw, 1e-3, 15e-3) for _ in range(2)]
    load, speed = of_size(draw, 500.0, 150e3), of_size(draw, 0.5, 100.0)
    creep = [draw.choice([-1, 1]) * of_size(draw, 1e-4, 0.1), draw.choice([-1, 0, 1]) * of_size(draw, 1e-4, 1e-2)]
    bulk = [draw.uniform(-40, 400) for _ in range(2)]
    thermal = [[of_size(draw, 0.2, 400), of_size(draw, 1e3, 9e3), of_size(draw, 300, 2e3)] for _ in range(2)]
    cold = draw.uniform(0.1, 0.6)
    falls = draw.random() < 0.5
    hot, begin = cold * draw.uniform(0.2, 1.0), draw.uniform(0, 600)
    law = f"{{ cold = {cold!r}, hot = {hot!r}, temperatures = [{begin!r}, {begin + of_size(draw, 1, 600)!r}] }}"

    def text(sense: int) -> tuple[str, str]:
        bodies = [
            f"{{ conductivity = {k!r}, density = {rho!r}, specific_heat = {c!r}, bulk_temperature = {t!r} }}"
            for (k, rho, c), t in zip(thermal, bulk, strict=True)
        ]
        return "solve", (
            f"{steel()}[contact]\nnormal_force = {load!r}\nsemi_axis_rolling = {sizes[0]!r}\n"
            f"semi_axis_lateral = {sizes[1]!r}\nfriction = {law if falls else repr(cold)}\n"
            f"[creepage]\nlongitudinal = {creep[0]!r}\nlateral = {sense * creep[1]!r}\nspeed = {speed!r}\n"
            f"[heat]\nupper = {bodies[0]}\nlower = {bodies[1]}\n[solve]\nresolution = \"fast\"\n"
        )

    return text


def viscoelastic(draw: random.Random) -> Callable[[int], tuple[str, str]]:
    modulus, poisson = of_size(draw, 1e6, 5e9), draw.uniform(0.1, 0.49)
    radii = [of_size(draw, 0.01, 1.0) for _ in range(2)]
    load = modulus * radii[0] * of_size(draw, 1e-6, 1e-2)
    ratio, time, speed = of_size(draw, 1e-2, 20.0), of_size(draw, 1e-7, 1.0), of_size(draw, 0.1, 50.0)
    friction = draw.uniform(0.05, 0.9)
    size = of_size(draw, 1e-5, 0.1)
    wanted = draw.choice([draw.uniform(-0.99, 0.99), None])

    def text(sense: int) -> tuple[str, str]:
        given = f"[wanted]\nfx = {sense * wanted!r}\n" if wanted is not None else ""
        own = f"longitudinal = {sense * size!r}\n" if wanted is None else ""
        radius = [f"radius_rolling = {radius!r}\n" for radius in radii]
        return "solve", (
            f"{body('upper', modulus, poisson, radius[0])}{body('lower', modulus, poisson, radius[1])}"
            f"[contact]\nline_load = {load!r}\nfriction = {friction!r}\n[relaxation]\nratio = {ratio!r}\n"
            f"time = {time!r}\n[creepage]\nspeed = {speed!r}\n{own}{given}"
        )

    return text


def load_paths(draw: random.Random) -> Callable[[int], tuple[str, str]]:
    load, friction = of_size(draw, 1.0, 1e5), draw.uniform(0.05, 1.0)
    radius = of_size(draw, 1e-3, 1.0)
    parts = [draw.uniform(-0.99, 0.99) for _ in range(draw.randint(1, 12))]
    # Half of them under loads that change.
    changes = draw.random() < 0.5
    loads = [load * of_size(draw, 0.1, 10.0) if changes else load for _ in parts]
    along = draw.choice("xy")

    def text(sense: int) -> tuple[str, str]:
        steps = ", ".join(
            f"{{ {f'normal_force = {own!r}, ' if changes else ''}force = {sense * part * friction * own!r} }}"
            for part, own in zip(parts, loads, strict=True)
        )
        return "statics", (
            steel((f"radius_rolling = {radius!r}\nradius_lateral = {radius!r}\n", 'radius_rolling = "flat"\nradius_lateral = "flat"\n'))
            + f"[contact]\nnormal_force = {load!r}\nfriction = {friction!r}\n"
            f'[statics]\nproblem = "shift-path"\nalong = "{along}"\nsteps = [{steps}]\n'
        )

    return text


KINDS = {"curved": curved, "slices": slices, "heat": heat, "viscoelastic": viscoelastic, "load-paths": load_paths}


def solved(command: str, verb: str, text: str, folder: Path, name: str) -> tuple[Report | None, str]:
    file = folder / f"{name}.toml"
    file.write_text(text)
    try:
        done = subprocess.run(
            [command, verb, str(file), "--json"], capture_output=True, text=True, timeout=ALLOWED, check=False
        )
    except subprocess.TimeoutExpired:
        return None, f"NO ANSWER in {ALLOWED} s"
    if done.returncode not in (0, 2, 3) or "panicked" in done.stderr:
        return None, f"PANIC or exit code {done.returncode}: {done.stderr[:200]}"
    if done.returncode == 2:
        words = done.stderr.strip().splitlines()
        # Numbers differ from input to input.
        cause = words[-1].split(": ", 2)[-1] if words else "no word"
        return None, "refused: " + " ".join("#" if any(c.isdigit() for c in word) else word for word in cause.split())[:110]
    if done.returncode == 3:
        return None, "told that it did not converge"
    return json.loads(done.stdout), ""


def close(one: float, other: float, unit: float) -> float:
    return abs(one - other) / unit if unit else 0.0


def laws(kind: str, own: Report, mirrored: Report) -> dict[str, float]:
    """By how much each law is missed; friction over one."""
    if kind == "load-paths":
        pairs = list(zip(own["steps"], mirrored["steps"], strict=True))
        most = max(abs(step["shift_m"]) for step in own["steps"]) or 1.0
        heats = [0.0, *(step["dissipated_j"] for step in own["steps"])]
        fall = max(before - after for before, after in zip(heats, heats[1:], strict=False))
        return {
            "mirror": max(close(a["shift_m"], -b["shift_m"], most) for a, b in pairs),
            "friction": max(abs(a["force_n"]) / (own["given"]["friction"] * a["normal_force_n"]) for a, _ in pairs),
            # Heat never falls from step to step.
            "heat": max(0.0, fall),
        }
    if kind == "viscoelastic":
        return {
            "friction": abs(own["fx"]),
            # Rolling resistance does not change with the sense of the traction.
            "mirror": max(close(own["fx"], -mirrored["fx"], 1.0), close(own["peak_pressure_pa"], mirrored["peak_pressure_pa"], own["peak_pressure_pa"])),
            "heat": max(0.0, -own["friction_heat_j_per_m2"], -(own["rolling_resistance_n_per_m"] or 0.0)),
        }
    if kind == "slices":
        right, left = own["right"], mirrored["left"]
        unit = own["friction"] * sum(patch["normal_force_n"] for patch in right["patches"])
        used = [
            math.hypot(patch["longitudinal_n"], patch["lateral_n"]) / (own["friction"] * patch["normal_force_n"])
            for patch in right["patches"]
        ]
        signs = {"longitudinal_n": 1, "lateral_n": -1, "vertical_n": 1}
        return {
            "friction": max(used, default=0.0),
            "mirror": max(close(right["force"][k], sign * left["force"][k], unit) for k, sign in signs.items()),
        }
    force, other = own["lower_body"], mirrored["lower_body"]
    unit = own["friction"] * own["contact"]["normal_force_n"]
    missed = {
        "friction": math.hypot(force["longitudinal_n"], force["lateral_n"]) / unit,
        "mirror": max(
            close(force["longitudinal_n"], other["longitudinal_n"], unit),
            close(force["lateral_n"], -other["lateral_n"], unit),
        ),
        "heat": max(0.0, -(own.get("frictional_power_per_metre_j_per_m") or 0.0)),
    }
    if kind == "heat" and own.get("heat"):
        found = own["heat"]
        into = found["into_upper_w"] + found["into_lower_w"]
        size = abs(found["into_upper_w"]) + abs(found["into_lower_w"]) + abs(found["friction_w"])
        missed["balance"] = close(into, found["friction_w"], size)
        # Friction only warms: kelvin below the temperature of a contact that is not rubbed.
        missed["temperature"] = max(0.0, found["contact_temperature_unrubbed_c"] - found["contact_temperature_max_c"])
    return missed


def one(command: str, kind: str, seed: int) -> tuple[str, dict[str, float]]:
    draw = KINDS[kind](random.Random(seed))
    with tempfile.TemporaryDirectory() as folder:
        reports = []
        for sense in (1, -1):
            verb, text = draw(sense)
            report, why = solved(command, verb, text, Path(folder), f"own{sense}")
            if report is None:
                return why, {}
            reports.append(report)
    return "solved", laws(kind, *reports)


def main() -> None:
    command = str(Path(sys.argv[1]).resolve())
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 1000
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    for kind in sys.argv[4:] or KINDS:
        with ThreadPoolExecutor(2) as pool:
            answers = list(pool.map(lambda k, kind=kind: one(command, kind, seed * 1_000_003 + k), range(count)))
        print(f"\n{kind}: {count} inputs and their mirror images, seed {seed}")
        for why, times in Counter(why for why, _ in answers).most_common(12):
            print(f"  {times} {why}")
        for law in dict.fromkeys(law for _, missed in answers for law in missed):
            missed = [(values[law], k) for k, (_, values) in enumerate(answers) if law in values]
            limit = {"friction": BEYOND, "mirror": MIRROR[kind], "balance": 1e-9, "temperature": 1e-9}.get(law, 0.0)
            worst, number = max(missed)
            failed = sum(value > limit for value, _ in missed)
            print(f"  {law}: {len(missed)} checked, {failed} failed, worst {worst:.3g} (number {number}), allowed {limit:.6g}", flush=True)


if __name__ == "__main__":
    main()
