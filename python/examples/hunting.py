"""A wheelset on springs hunts: its critical speed by derivatives, and its limit cycle in time.

One wheelset (1500 kg, 900 kg m^2) runs at constant speed between two axle boxes whose springs hold it with .7 MN/m
sideways and .7 MN m/rad in yaw; S1002 wheels on UIC60 rails canted 1:40, 100 kN, friction .4. The contact forces
come from anything that is asked as a wheelset is: the full theory, `fastsim`, or a contact map of the wheelset.

    python hunting.py                   # fastsim
    python hunting.py wheelset.nc       # by `creepage map wheelset.toml --out wheelset.nc`
"""

from __future__ import annotations

import math
import sys
from typing import Protocol

import creepage
import numpy as np
from scipy.integrate import solve_ivp

MASS, INERTIA = 1500.0, 900.0
STIFFNESS = (0.70e6, 0.70e6)  # N/m, N m/rad


class Answer(Protocol):
    """What is asked for."""

    @property
    def wrench(self) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
        """Of the rails on the wheelset about its centre."""
        ...


class Contacts(Protocol):
    """A wheelset's solver, or a contact map."""

    def solve(
        self, *, y: float, yaw: float, speed: float, lateral_velocity: float, yaw_rate: float
    ) -> Answer:
        """Forces in a position and motion."""
        ...


def wheelset(theory: str = "fastsim") -> creepage.Wheelset:
    """The wheelset on its track."""
    return creepage.Wheelset(
        wheel="S1002",
        rail="UIC60",
        cant=math.atan(1 / 40),
        axle_load=100e3,
        friction=0.4,
        theory=theory,
    )


def push(contacts: Contacts, state: np.ndarray, speed: float) -> tuple[float, float]:
    """Lateral force and yaw moment of the rails on the wheelset at y, yaw and their rates."""
    y, yaw, lateral_velocity, yaw_rate = (float(value) for value in state)
    wrench = contacts.solve(
        y=y, yaw=yaw, speed=speed, lateral_velocity=lateral_velocity, yaw_rate=yaw_rate
    ).wrench
    return float(wrench[1]), float(wrench[5])


def rates(contacts: Contacts, state: np.ndarray, speed: float) -> np.ndarray:
    """The equations of motion."""
    force, moment = push(contacts, state, speed)
    y, yaw, lateral_velocity, yaw_rate = state
    return np.array(
        [
            lateral_velocity,
            yaw_rate,
            (force - STIFFNESS[0] * y) / MASS,
            (moment - STIFFNESS[1] * yaw) / INERTIA,
        ]
    )


def damping(contacts: Contacts, speed: float) -> float:
    """Largest real part (1/s) of the eigenvalues about the middle of the track: positive where it hunts."""
    steps = np.array([2e-5, 2e-5, 1e-5 * speed, 1e-5 * speed])
    jacobian = np.empty((4, 4))
    for k, step in enumerate(steps):
        move = np.zeros(4)
        move[k] = step
        ahead, behind = (rates(contacts, sign * move, speed) for sign in (1.0, -1.0))
        jacobian[:, k] = (ahead - behind) / (2.0 * step)
    return float(np.linalg.eigvals(jacobian).real.max())


def critical_speed(contacts: Contacts, low: float = 10.0, high: float = 120.0) -> float:
    """The speed (m/s) from which on a small disturbance grows."""
    while high - low > 1e-3 * low:
        middle = 0.5 * (low + high)
        if damping(contacts, middle) > 0.0:
            high = middle
        else:
            low = middle
    return 0.5 * (low + high)


def swing(contacts: Contacts, speed: float, start: float, seconds: float) -> np.ndarray:
    """Lateral position (m) over time after a start out of the middle."""
    found = solve_ivp(
        lambda _, state: rates(contacts, state, speed),
        (0.0, seconds),
        [start, 0.0, 0.0, 0.0],
        method="RK45",
        rtol=1e-5,
        atol=1e-8,
        max_step=2e-3,
        t_eval=np.linspace(0.0, seconds, 2000),
    )
    return np.asarray(found.y[0])


def main() -> None:
    """Critical speed and a swing a tenth above it."""
    contacts: Contacts
    if len(sys.argv) > 1:
        contacts = creepage.ContactMap.load(sys.argv[1])
    else:
        contacts = wheelset().solver()
    speed = critical_speed(contacts)
    print(f"critical speed: {speed:.2f} m/s")
    if len(sys.argv) > 1:
        amplitude = np.abs(swing(contacts, 1.1 * speed, 0.005, 6.0)[-600:]).max()
        print(f"amplitude at 1.1 of that: {1e3 * amplitude:.2f} mm")


if __name__ == "__main__":
    main()
