"""A wheelset on springs hunts, with height and roll as states: critical speed by derivatives, and by simulation.

The wheelset of hunting.py; its axle boxes carry 100 kN by springs of 1 MN/m and dampers on either side, 1 m from the
middle. A small swing along the eigenvector that hunts is followed by Runge and Kutta's fourth order at two speeds; by how
much it grows tells the speed at which it would not.

    python hunting_with_height.py            # `exact`, fast elements: a minute
    python hunting_with_height.py fastsim
"""

from __future__ import annotations

import sys
import time

import creepage
import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

LOAD, RADIUS = 100e3, 0.46
MASS = np.array([1500.0, 1500.0, 900.0, 900.0])  # y, z (kg), roll, yaw (kg m^2)
STIFFNESS = np.array([0.7e6, 2e6, 2e6, 0.7e6])  # N/m, N m/rad
DAMPING = np.array([0.0, 2e4, 2e4, 0.0])  # N s/m, N m s/rad
STATES = ("y", "z", "roll", "yaw")
RATES = ("lateral_velocity", "vertical_velocity", "roll_rate", "yaw_rate")
WRENCH = [1, 2, 3, 5]  # along y and z, about x and z


class Hunting:
    """Equations of motion at a speed (m/s), about the wheelset at rest in the middle of the track."""

    def __init__(self, wheelset: creepage.Wheelset, solver: creepage.WheelsetSolver, speed: float) -> None:
        self.solver, self.speed = solver, speed
        self.rest = solver.solve(y=0.0, yaw=0.0, axle_load=LOAD, speed=speed)
        whole = wheelset.solve()
        assert whole.left is not None and whole.right is not None
        self.origins = [np.array(wheel["rail_origin_m"]) for wheel in (whole.left, whole.right)]
        self.solutions = 0

    def forces(self, motion: Array) -> Array:
        """Of the rails on the wheelset along the four states, at eight numbers off the middle."""
        at = dict(zip(STATES + RATES, motion.tolist(), strict=True))
        at["z"] += self.rest.z
        self.solutions += 1
        result = self.solver.solve(**at, speed=self.speed, start=self.rest)
        return np.array(result.wrench[WRENCH])

    def rates(self, motion: Array) -> Array:
        """The equations of motion."""
        push = self.forces(motion) + np.array([0.0, LOAD, 0.0, 0.0])
        held = -STIFFNESS * motion[:4] - DAMPING * motion[4:]
        return np.concatenate([motion[4:], (push + held) / MASS])

    def matrix(self) -> Array:
        """The equations of motion about the middle: by the solver's derivatives, by differences where it has none."""
        found = self.solver.solve(y=0.0, z=self.rest.z, roll=0.0, yaw=0.0, speed=self.speed, derivatives=True)
        assert found.derivatives is not None
        centre = np.array([0.0, 0.0, self.rest.z - RADIUS])
        slopes = np.zeros((4, 8))
        # Of the derivatives by y, z, roll, yaw, lateral velocity and yaw rate.
        for column, state in {0: 0, 1: 1, 2: 2, 3: 3, 6: 4, 7: 7}.items():
            for k, wheel in enumerate((found.left, found.right)):
                force, moment = np.split(found.derivatives[k, :, column], 2)
                moment = moment + np.cross(self.origins[k] - centre, force)
                if state < 2:  # the centre moves
                    moment = moment - np.cross(np.eye(3)[1 + state], wheel.force)
                slopes[:, state] -= np.concatenate([force, moment])[WRENCH]
        for state in (5, 6):
            move = 1e-3 * np.eye(8)[state]
            slopes[:, state] = (self.forces(move) - self.forces(-move)) / 2e-3
        held = np.hstack([np.diag(STIFFNESS), np.diag(DAMPING)])
        below = (slopes - held) / MASS[:, None]
        return np.vstack([np.hstack([np.zeros((4, 4)), np.eye(4)]), below])

    def growth(self, seconds: float, step: float) -> float:
        """By how much (1/s) a swing of 20 um along the eigenvector that hunts grows in a simulation."""
        values, vectors = np.linalg.eig(self.matrix())
        slow = np.abs(values) < 200.0
        hunts = int(np.argmax(np.where(slow & (np.imag(values) > 1.0), np.real(values), -np.inf)))
        own = np.linalg.inv(vectors)[hunts]
        motion = np.real(vectors[:, hunts] / vectors[0, hunts]) * 2e-5
        times = np.arange(1, round(seconds / step) + 1) * step
        sizes = []
        for _ in times:
            one = self.rates(motion)
            two = self.rates(motion + 0.5 * step * one)
            three = self.rates(motion + 0.5 * step * two)
            four = self.rates(motion + step * three)
            motion = motion + step / 6.0 * (one + 2.0 * two + 2.0 * three + four)
            sizes.append(abs(own @ motion))
        return float(np.polyfit(times, np.log(sizes), 1)[0])


def damping(matrix: Array) -> float:
    """The largest real part (1/s) of the eigenvalues: positive where it hunts."""
    return float(np.linalg.eigvals(matrix).real.max())


def between(low: tuple[float, float], high: tuple[float, float]) -> float:
    """Where the line through two points crosses zero."""
    return low[0] - low[1] * (high[0] - low[0]) / (high[1] - low[1])


def main() -> None:
    """Both critical speeds, and how many steps a second were taken."""
    theory = sys.argv[1] if len(sys.argv) > 1 else "exact"
    wheelset = creepage.Wheelset(
        wheel="S1002", rail="UIC60", cant=0.025, gauge=1.435, gauge_height=0.014, back_to_back=1.360,
        radius=RADIUS, axle_load=LOAD, friction=0.4, speed=30.0,
    )  # fmt: skip
    solver = wheelset.solver("exact", resolution="fast") if theory == "exact" else wheelset.solver(theory)
    low, high = 20.0, 80.0
    while high - low > 1e-3 * low:
        middle = 0.5 * (low + high)
        unstable = damping(Hunting(wheelset, solver, middle).matrix()) > 0.0
        low, high = (low, middle) if unstable else (middle, high)
    by_slopes = 0.5 * (low + high)
    print(f"critical speed by derivatives: {by_slopes:.2f} m/s")
    points, solutions, start = [], 0, time.perf_counter()
    for speed in (0.97 * by_slopes, 1.03 * by_slopes):
        hunting = Hunting(wheelset, solver, speed)
        points.append((speed, hunting.growth(0.4, 5e-4)))
        solutions += hunting.solutions
    print(f"critical speed by simulation: {between(*points):.2f} m/s")
    print(f"{solutions / 4.0 / (time.perf_counter() - start):.0f} steps a second")


if __name__ == "__main__":
    main()
