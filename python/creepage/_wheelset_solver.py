"""A wheelset asked again and again, as a simulation does: position, load and motion in, forces out."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _creepage
from ._contact import floats, number
from ._results import Comparable, Floats, same

_ASKED = (
    "y",
    "z",
    "roll",
    "yaw",
    "axle_load",
    "roll_moment",
    "speed",
    "pitch_rate",
    "lateral_velocity",
    "vertical_velocity",
    "roll_rate",
    "yaw_rate",
)


class Patch(NamedTuple):
    """A place of contact; track axes are x forward, y right, z down."""

    reference: tuple[float, float, float]
    """Its reference point in track axes (m)."""
    angle: float
    """From the track's z to the normal into the rail, about x (rad)."""
    normal_force: float
    """N."""
    peak_pressure: float
    """Pa."""
    area: float
    """m^2."""
    creepage: tuple[float, float, float]
    """Longitudinal, lateral, spin (rad/m)."""
    force: tuple[float, float, float]
    """On the rail, in the contact plane: longitudinal, lateral (N), moment about the normal (N m)."""


@dataclass(frozen=True, eq=False)
class WheelResult(Comparable):
    """One wheel of a solved position."""

    force: Floats
    """On the rail along x, y, z of the track (N)."""
    moment: Floats
    """About the origin of the rail's profile (N m)."""
    patches: tuple[Patch, ...]
    """Places of contact by falling load; none where the wheel hangs above its rail."""
    pitch_rate: float
    """Its angular velocity about the axle (rad/s), of independent wheels its own."""
    clearance: float | None
    """How far it would have to go down to touch (m), where it touches nothing."""

    def __repr__(self) -> str:
        x, y, z = self.force
        return f"<creepage.WheelResult {x:.1f}, {y:.1f}, {z:.1f} N, {len(self.patches)} contacts>"


class WheelsetResult:
    """A position of a wheelset, solved; the `start` of one nearby.

    A copy through pickle has all its numbers. As a `start` it is passed over: the solver begins from
    nothing.
    """

    def __init__(self, solved: _creepage.SolvedWheelset) -> None:
        """Made by `WheelsetSolver.solve`."""
        self._solved: _creepage.SolvedWheelset | None = solved
        self._numbers = solved.numbers()
        self.y, self.z, self.roll, self.yaw = solved.position()
        self.status, self.cautions = solved.outcome()

    def __getstate__(self) -> dict[str, Any]:
        names = ("y", "z", "roll", "yaw", "status", "cautions", "_numbers", "_report", "_derivatives")
        return {"_solved": None, **{name: getattr(self, name) for name in names}}

    def __eq__(self, other: object) -> bool:
        """The same numbers; NaN is the same as NaN."""
        if not isinstance(other, WheelsetResult):
            return NotImplemented
        return same(self.__getstate__(), other.__getstate__())

    __hash__ = None  # type: ignore[assignment]

    @property
    def pitch_rate(self) -> float:
        """Given or found (rad/s); of independent wheels, which have their own each, the mean."""
        return float(_mean(self._numbers[20:22]))

    @property
    def wrench(self) -> Floats:
        """Of the rails on the wheelset about its centre: force along x, y, z (N), moment about them (N m)."""
        return self._numbers[12:18]

    @cached_property
    def left(self) -> WheelResult:
        """The left wheel; its forces are NaN where the right one was solved alone."""
        return self._wheel("left", 0)

    @cached_property
    def right(self) -> WheelResult:
        """The right wheel."""
        return self._wheel("right", 6)

    def _wheel(self, side: str, first: int) -> WheelResult:
        report: dict[str, Any] | None = self._report[side]
        patches = () if report is None else tuple(_patch(one) for one in report["patches"])
        force, moment = self._numbers[first : first + 3], self._numbers[first + 3 : first + 6]
        rate = float(self._numbers[20 if side == "left" else 21])
        clearance = None if report is None else report["clearance_m"]
        return WheelResult(force, moment, patches, rate, clearance)

    @cached_property
    def _report(self) -> dict[str, Any]:
        assert self._solved is not None  # a copy has its report
        report: dict[str, Any] = json.loads(self._solved.json())
        return report

    @cached_property
    def _derivatives(self) -> tuple[Floats, Floats] | None:
        found = None if self._solved is None else self._solved.derivatives()
        return None if found is None else (found[0].reshape(2, 6, 8), found[1].reshape(2, 6, 8))

    @property
    def derivatives(self) -> Floats | None:
        """As `WheelsetSolution.derivatives`, of shape (2, 6, 8), where they were asked for."""
        return None if self._derivatives is None else self._derivatives[0]

    @property
    def derivative_errors(self) -> Floats | None:
        """What the differences may have made of each."""
        return None if self._derivatives is None else self._derivatives[1]

    def __repr__(self) -> str:
        x, y, z = self.wrench[:3]
        return f"<creepage.WheelsetResult {self.status}, wrench {x:.1f}, {y:.1f}, {z:.1f} N>"


class WheelsetMany(NamedTuple):
    """Many positions, solved: arrays of the shape of the question, forces with six numbers more."""

    left: Floats
    """On the left rail: force along x, y, z (N), moment about the origin of its profile (N m)."""
    right: Floats
    """On the right rail."""
    wrench: Floats
    """Of the rails on the wheelset about its centre."""
    z: Floats
    """Height, down (m)."""
    roll: Floats
    """rad."""
    pitch_rate: Floats
    """rad/s; of independent wheels the mean."""
    pitch_rates: Floats
    """Of the left and of the right wheel (rad/s)."""
    status: np.ndarray[Any, np.dtype[np.str_]]
    """ "solved", or why not."""
    cautions: np.ndarray[Any, np.dtype[np.str_]]
    """What may be off, as the cautions of `solve` with "; " between them; empty where nothing is."""


class WheelsetSolver:
    """A wheelset prepared once and asked many times; made by `Wheelset.solver`.

    It may be pickled, as for the processes of a pool, and compared.
    """

    def __init__(self, data: _creepage.WheelsetData, made: tuple[Any, ...]) -> None:
        """Made by `Wheelset.solver`."""
        self._data, self._made = data, made

    def __reduce__(self) -> tuple[Any, ...]:
        wheelset, theory, options = self._made
        return partial(wheelset.solver, theory, **options), ()

    def __eq__(self, other: object) -> bool:
        """The same wheelset, theory and options."""
        return self._made == other._made if isinstance(other, WheelsetSolver) else NotImplemented

    def __hash__(self) -> int:
        wheelset, theory, _ = self._made
        return hash((wheelset, theory))

    def solve(
        self,
        *,
        y: float | None = None,
        z: float | None = None,
        roll: float | None = None,
        yaw: float | None = None,
        axle_load: float | None = None,
        roll_moment: float | None = None,
        speed: float | None = None,
        pitch_rate: float | None = None,
        lateral_velocity: float | None = None,
        vertical_velocity: float | None = None,
        roll_rate: float | None = None,
        yaw_rate: float | None = None,
        start: WheelsetResult | None = None,
        derivatives: bool = False,
    ) -> WheelsetResult:
        """Solves one position and motion, in SI units, angles in radians.

        What is left out is the wheelset's own. `z` (m, down) or `axle_load` (N, both wheels) press
        it. `roll_moment` (N m), with `axle_load` and a roll that is free, is the moment about x
        through its centre with which it presses on the track. It is positive where it presses the
        right wheel down. Without `start` the answer is the same to the last bit whatever was asked
        before. With `start`, an earlier result nearby, it is found from there, several times
        quicker, and the same within the error bars. Raises CaseError where nothing rests on the
        rails.
        """
        given = {
            "y": y,
            "z": z,
            "roll": roll,
            "yaw": yaw,
            "axle_load": axle_load,
            "roll_moment": roll_moment,
            "speed": speed,
            "pitch_rate": pitch_rate,
            "lateral_velocity": lateral_velocity,
            "vertical_velocity": vertical_velocity,
            "roll_rate": roll_rate,
            "yaw_rate": yaw_rate,
        }
        if z is not None and axle_load is not None:
            raise ValueError("z and axle_load exclude each other: one of them presses the wheelset")
        before = None if start is None else start._solved
        asked = [_number(name, given[name]) for name in _ASKED]
        return WheelsetResult(self._data.solve_at(asked, before, derivatives))

    def solve_many(self, **quantities: ArrayLike) -> WheelsetMany:
        """Solves many positions and motions on all cores: arrays or numbers of the quantities of `solve`.

        They are broadcast against one another. Each row is solved from nothing, so that it has the bits
        of `solve`; one that cannot be solved has NaN, and the reason in `status`.
        """
        shape, rows = _rows(_ASKED, quantities)
        numbers, (status, cautions) = self._data.solve_rows(rows.ravel())
        numbers = numbers.reshape(*shape, 22)
        return WheelsetMany(
            numbers[..., 0:6],
            numbers[..., 6:12],
            numbers[..., 12:18],
            numbers[..., 18],
            numbers[..., 19],
            _mean(numbers[..., 20:22]),
            numbers[..., 20:22],
            np.array(status).reshape(shape),
            np.array(cautions).reshape(shape),
        )


def _rows(names: tuple[str, ...], quantities: dict[str, ArrayLike]) -> tuple[tuple[int, ...], Floats]:
    """The shape of what is asked, and a row of these quantities for each; NaN where one is left out."""
    unknown = set(quantities) - set(names)
    if unknown:
        raise TypeError(f"unknown quantity {min(unknown)!r}: known are {', '.join(names)}")
    if "z" in quantities and "axle_load" in quantities:
        raise ValueError("z and axle_load exclude each other: one of them presses the wheelset")
    given = {name: floats(name, values) for name, values in quantities.items()}
    for name, values in given.items():
        if not np.isfinite(values).all():
            raise ValueError(f"{name} must be finite")
    shape = np.broadcast_shapes(*(values.shape for values in given.values()))
    rows = np.full((*shape, len(names)), math.nan)
    for k, name in enumerate(names):
        if name in given:
            rows[..., k] = given[name]
    return shape, rows


def _mean(rates: Floats) -> Floats:
    """Of the left and the right wheel; that of the one alone where only one is solved."""
    left, right = rates[..., 0], rates[..., 1]
    one = np.where(np.isnan(left), right, left)
    return np.asarray(0.5 * (one + np.where(np.isnan(right), left, right)))


def _number(name: str, value: float | None) -> float:
    if value is None:
        return math.nan
    number(name, value)
    if not math.isfinite(value):
        raise ValueError(f"{name} must be finite, got {value}")
    return float(value)


def _patch(report: dict[str, Any]) -> Patch:
    return Patch(
        (report["x_m"], report["y_m"], report["z_m"]),
        report["contact_angle_rad"],
        report["normal_force_n"],
        report["peak_pressure_pa"],
        report["area_m2"],
        (report["longitudinal_creepage"], report["lateral_creepage"], report["spin_rad_per_m"]),
        (report["longitudinal_n"], report["lateral_n"], report["moment_n_m"]),
    )
