"""A reference wheelset on springs: critical speed and limit cycles by a contact map, the full theory, Polach, linear theory.

One wheelset (1500 kg, 900 kg m^2) between axle boxes that run true with it; springs of .7 MN/m sideways and
.7 MN m/rad in yaw, no dampers. S1002 on UIC60 1:40, 100 kN, friction .4, equal loads on both rails.

    python reference_wheelset.py                      # the critical speed by `fastsim` alone
    python reference_wheelset.py wheelset.nc          # all of it, some minutes
    python reference_wheelset.py wheelset.nc --quick  # the map alone

`exact` is looked up in a table of lateral force and yaw moment over y, ydot/V - yaw and yaw_rate/V, and its limit cycle
is gone through once more step by step, by the solver itself. Polach's and linear theory have one ellipse of equal area at
each wheel.
"""

from __future__ import annotations

import argparse
import math
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import creepage
import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from scipy.interpolate import RegularGridInterpolator

Array = NDArray[np.float64]
Push = Callable[[Array, float], tuple[float, float]]
"""Lateral force (N) and yaw moment (N m) of the rails at (y, yaw, ydot, yaw rate) and a speed."""

MASS, INERTIA, STIFFNESS = 1500.0, 900.0, (0.70e6, 0.70e6)
AXLE_LOAD, FRICTION, RADIUS = 100e3, 0.4, 0.46
STEEL: dict[str, Any] = {"shear_modulus": 82e9, "poisson": 0.28}
WIDEST = 8e-3  # m: where tables end
REFERENCE_SPEED = 38.0
"""Of the table's motions (m/s): forces depend on the ratios of velocities alone."""


def wheelset(theory: str = "exact", **options: Any) -> creepage.Wheelset:
    """The wheelset on its track."""
    return creepage.Wheelset(
        wheel="S1002",
        rail="UIC60",
        cant=math.atan(1 / 40),
        axle_load=AXLE_LOAD,
        friction=FRICTION,
        theory=theory,
        **STEEL,
        **options,
    )


# Forces from the table, the map and the solver.


@dataclass(frozen=True)
class MotionTable:
    """Lateral force and yaw moment over y, slip = ydot/V - yaw, turn = yaw_rate/V; all are odd together."""

    y: Array
    slip: Array
    turn: Array
    force: Array
    moment: Array

    def push(self) -> Push:
        """Cubic splines through the table."""
        axes = (self.y, np.arcsinh(self.slip / 1e-3), np.arcsinh(self.turn / 1e-3))
        both = np.stack((self.force, self.moment), axis=-1)
        look = RegularGridInterpolator(axes, both, method="cubic")
        # The spline itself, where there is one: its wrapper checks each call.
        at: Any = getattr(look, "_spline", look)

        def push(state: Array, speed: float) -> tuple[float, float]:
            y, yaw, lateral_velocity, yaw_rate = state
            slip, turn = lateral_velocity / speed - yaw, yaw_rate / speed
            if abs(y) > self.y[-1]:
                raise ValueError("the table ends: the flange climbs")
            # Beyond the last slip all of the friction is used up.
            slip = min(max(slip, self.slip[0]), self.slip[-1])
            turn = min(max(turn, self.turn[0]), self.turn[-1])
            force, moment = at([[y, math.asinh(slip / 1e-3), math.asinh(turn / 1e-3)]])[0]
            return float(force), float(moment)

        return push


def axes(nodes: tuple[int, int, int], widest: float) -> tuple[Array, Array, Array]:
    """y from the middle to one side; slip and turn to both, closer about zero."""
    spread = [np.sinh(np.linspace(-math.asinh(most), math.asinh(most), n)) * 1e-3
              for most, n in zip((20.0, 10.0), nodes[1:], strict=True)]
    return np.linspace(0.0, widest, nodes[0]), spread[0], spread[1]


def unfolded(y: Array, slip: Array, turn: Array, half: Array) -> MotionTable:
    """From one side to both."""
    other = -half[:0:-1, ::-1, ::-1]
    both = np.concatenate((other, half))
    both[len(y) - 1] = 0.5 * (half[0] - half[0, ::-1, ::-1])
    return MotionTable(np.r_[-y[:0:-1], y], slip, turn, both[..., 0], both[..., 1])


def exact_table(solver: creepage.WheelsetSolver, nodes: tuple[int, int, int], widest: float = WIDEST) -> MotionTable:
    """By the solver, each motion from the one before."""
    y, slip, turn = axes(nodes, widest)

    def row(at: float) -> Array:
        found = np.empty((len(slip), len(turn), 2))
        start = None
        for k in range(len(turn)):
            # To and fro, so that the start is a neighbour.
            for s in range(len(slip))[:: 1 if k % 2 else -1]:
                start = solver.solve(
                    y=at,
                    yaw=0.0,
                    speed=REFERENCE_SPEED,
                    lateral_velocity=slip[s] * REFERENCE_SPEED,
                    yaw_rate=turn[k] * REFERENCE_SPEED,
                    start=start,
                )
                found[s, k] = start.wrench[[1, 5]]
        return found

    with ThreadPoolExecutor() as pool:
        return unfolded(y, slip, turn, np.stack(list(pool.map(row, y))))


def asked(contacts: creepage.ContactMap | creepage.WheelsetSolver, **more: Any) -> Push:
    """The map itself, or the solver from nothing, with yaw as a position too."""

    def push(state: Array, speed: float) -> tuple[float, float]:
        y, yaw, lateral_velocity, yaw_rate = (float(value) for value in state)
        wrench = contacts.solve(
            y=y, yaw=yaw, speed=speed, lateral_velocity=lateral_velocity, yaw_rate=yaw_rate, **more
        ).wrench
        return float(wrench[1]), float(wrench[5])

    return push


def followed(solver: creepage.WheelsetSolver) -> Push:
    """The solver, each state from the one before."""
    before: list[creepage.WheelsetResult | None] = [None]

    def push(state: Array, speed: float) -> tuple[float, float]:
        y, yaw, lateral_velocity, yaw_rate = (float(value) for value in state)
        motion: dict[str, Any] = {"yaw": yaw, "speed": speed, "lateral_velocity": lateral_velocity, "yaw_rate": yaw_rate}
        try:
            found = solver.solve(y=y, start=before[0], **motion)
        except creepage.CaseError:
            # Where areas join the load can jump: a micrometre beside that.
            found = solver.solve(y=y + math.copysign(1e-6, y), **motion)
        before[0] = found
        return float(found.wrench[1]), float(found.wrench[5])

    return push


# One ellipse of equal area at each wheel, for theories of ellipses.


@dataclass(frozen=True)
class Ellipse:
    """A wheel's contact as one ellipse, by track axes from the centre of the wheelset."""

    load: float
    angle: float
    lever: tuple[float, float]
    theory: creepage.Theory
    unit: float
    length: float

    def acts(self, pitch: Array, slip: Array, turn: Array) -> tuple[Array, Array, Array]:
        """Lateral force and yaw moment on the wheelset, friction's moment about the axle; rates over speed."""
        sin, cos = math.sin(self.angle), math.cos(self.angle)
        y, z = self.lever
        along = 1.0 - pitch * z - turn * y
        across = slip * cos
        spin = turn * cos + pitch * sin
        bound = FRICTION * self.load
        force = self.theory.force(along / self.unit, across / self.unit, spin * self.length / self.unit)
        fx, fs, mz = (np.asarray(part) * bound for part in (force.fx, force.fy, force.mz))
        mz = mz * self.length
        lateral = fs * cos - self.load * sin
        return -lateral, y * fx - mz * cos, z * fx - mz * sin


def ellipse(patches: tuple[creepage.Patch, ...], centre: tuple[float, float], ratio: float, name: str) -> Ellipse:
    """Of the area, the load and the mean place of a wheel's contacts."""
    loads = np.array([patch.normal_force for patch in patches])
    share = loads / loads.sum()
    angle = float(share @ [patch.angle for patch in patches])
    y, z = (float(share @ [patch.reference[k] for patch in patches]) for k in (1, 2))
    length = math.sqrt(sum(patch.area for patch in patches) / math.pi)
    # Of one shape, c^3 goes with load and radius of curvature.
    rail = creepage.Body(**STEEL, radius_rolling="flat", radius_lateral=0.3)
    like = creepage.hertz(creepage.Body(**STEEL, radius_rolling=RADIUS), rail, loads.sum())
    size = math.sqrt(like.semi_axis_rolling * like.semi_axis_lateral)
    rho = like.rho * (length / size) ** 3
    theory = creepage.theory(name, ratio, STEEL["poisson"])
    return Ellipse(float(loads.sum()), angle, (y - centre[0], z - centre[1]), theory, FRICTION * length / rho, length)


def shapes(y: Array) -> Array:
    """a/b of ellipses of each wheel's area and of the length of its largest contact; left, then right."""
    table = wheelset("saturated").table(y)
    found = []
    for side in ("left", "right"):
        area, length = (table[f"{side}_contact_{name}"].reshape(len(y), 3)[:, 0] for name in ("area_m2", "length_m"))
        found.append(np.clip(math.pi * length**2 / (4.0 * area), 0.2, 20.0))
    return np.array(found)


def ellipse_table(
    solver: creepage.WheelsetSolver, name: str, nodes: tuple[int, int, int], widest: float = WIDEST
) -> MotionTable:
    """A table by a theory of ellipses, in the places of the solver; the axle turns freely."""
    y, slip, turn = axes(nodes, widest)
    slips, turns = np.meshgrid(slip, turn, indexing="ij")
    half, start = np.empty((len(y), *slips.shape, 2)), None
    ratios = shapes(y)
    for k, at in enumerate(y):
        start = solver.solve(y=at, speed=REFERENCE_SPEED, start=start)
        centre = (start.y, start.z - RADIUS)
        wheels = zip((start.left, start.right), ratios[:, k], strict=True)
        both = [ellipse(wheel.patches, centre, float(ratio), name) for wheel, ratio in wheels]
        low, high = (np.full(slips.shape, factor / RADIUS) for factor in (0.95, 1.05))
        for _ in range(40):
            pitch = 0.5 * (low + high)
            turning = sum(one.acts(pitch, slips, turns)[2] for one in both)
            fast = np.asarray(turning) < 0.0
            low, high = np.where(fast, low, pitch), np.where(fast, pitch, high)
        pitch = 0.5 * (low + high)
        acts = [one.acts(pitch, slips, turns) for one in both]
        half[k, ..., 0], half[k, ..., 1] = acts[0][0] + acts[1][0], acts[0][1] + acts[1][1]
    return unfolded(y, slip, turn, half)


# The wheelset's motion.


def rates(push: Push, state: Array, speed: float) -> Array:
    """The equations of motion."""
    force, moment = push(state, speed)
    y, yaw, lateral_velocity, yaw_rate = state
    return np.array([
        lateral_velocity,
        yaw_rate,
        (force - STIFFNESS[0] * y) / MASS,
        (moment - STIFFNESS[1] * yaw) / INERTIA,
    ])


def damping(push: Push, speed: float, step: float = 2e-5) -> float:
    """Largest real part (1/s) of the eigenvalues about the middle of the track."""
    steps = step * np.array([1.0, 1.0, 0.5 * speed, 0.5 * speed])
    columns = [
        (rates(push, move, speed) - rates(push, -move, speed)) / (2.0 * move.sum())
        for move in np.diag(steps)
    ]
    return float(np.linalg.eigvals(np.stack(columns, axis=1)).real.max())


def critical_speed(push: Push, low: float = 20.0, high: float = 80.0, step: float = 2e-5) -> float:
    """The speed (m/s) from which on a small disturbance grows."""
    while high - low > 1e-4 * low:
        middle = 0.5 * (low + high)
        low, high = (low, middle) if damping(push, middle, step) > 0.0 else (middle, high)
    return 0.5 * (low + high)


def amplitude(push: Push, speed: float, start: float, seconds: float = 6.0) -> float:
    """Of the limit cycle (m) that a start out of the middle ends in; NaN where the flange climbs."""
    try:
        found = solve_ivp(
            lambda _, state: rates(push, state, speed),
            (0.0, seconds),
            [start, 0.0, 0.0, 0.0],
            rtol=1e-6,
            atol=1e-9,
            max_step=2e-3,
            t_eval=np.linspace(seconds - 1.0, seconds, 4000),
        )
    except ValueError:
        return math.nan
    return float(np.abs(found.y[0]).max())


def stepped(push: Push, speed: float, start: Array, seconds: float, step: float = 1e-3) -> Array:
    """The motion by Runge and Kutta's steps of one length, a row each."""
    rows = [start]
    for _ in range(round(seconds / step)):
        at = rows[-1]
        one = rates(push, at, speed)
        two = rates(push, at + 0.5 * step * one, speed)
        three = rates(push, at + 0.5 * step * two, speed)
        four = rates(push, at + step * three, speed)
        rows.append(at + step / 6.0 * (one + 2.0 * two + 2.0 * three + four))
    return np.array(rows)


def compared(push: Push, solver: creepage.WheelsetSolver, path: Array, speed: float) -> tuple[float, float]:
    """Root mean square and largest difference of the lateral force from the solver's on states of a path, in
    parts of friction times axle load."""
    exact = followed(solver)
    missed = np.array([push(state, speed)[0] - exact(state, speed)[0] for state in path])
    missed /= FRICTION * AXLE_LOAD
    return float(np.sqrt(np.mean(missed**2))), float(np.abs(missed).max())


def main() -> None:
    """Prints a table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("map", nargs="?", help="by `creepage map`")
    parser.add_argument("--quick", action="store_true", help="the map alone")
    options = parser.parse_args()
    if options.map is None:
        print(f"fastsim: critical speed {critical_speed(asked(wheelset('fastsim').solver())):.2f} m/s")
        return
    contacts = creepage.ContactMap.load(options.map)
    methods: dict[str, Push] = {"map": asked(contacts, friction=FRICTION)}
    solver = wheelset().solver()
    if not options.quick:
        nodes = (65, 15, 9)
        started = time.perf_counter()
        methods["exact"] = exact_table(solver, nodes).push()
        print(f"table of exact: {time.perf_counter() - started:.0f} s")
        for name in ("polach", "linear"):
            methods[name] = ellipse_table(solver, name, nodes).push()
    print("method   V_c (m/s)   amplitude at 1.1 and 1.2 V_c (mm)")
    for name, push in methods.items():
        speed = critical_speed(push)
        grown = [1e3 * amplitude(push, factor * speed, 5e-3) for factor in (1.1, 1.2)]
        print(f"{name:8} {speed:8.2f} {grown[0]:12.3f} {grown[1]:8.3f}")
    speed = 1.1 * critical_speed(methods["map"])
    start = np.array([5e-3, 0.0, 0.0, 0.0])
    path = stepped(methods["map"], speed, start, 0.2 if options.quick else 2.0)
    rms, worst = compared(methods["map"], solver, path[:: 20 if options.quick else 5], speed)
    print(f"map against exact on its own path: lateral force {100 * rms:.2f} % of mu N rms, worst {100 * worst:.2f} %")
    if not options.quick:
        path = stepped(followed(solver), speed, start, 2.0)
        print(f"exact step by step at {speed:.2f} m/s: {1e3 * np.abs(path[-500:, 0]).max():.3f} mm")


if __name__ == "__main__":
    main()
