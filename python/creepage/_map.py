"""Contact maps: the forces of the full theory on a wheelset by look-up, in microseconds."""

from __future__ import annotations

import math
import os
import warnings
from pathlib import Path
from typing import Any, Literal, NamedTuple, Protocol

import numpy as np
from numpy.typing import ArrayLike

from . import _creepage
from ._contact import floats
from ._results import Floats, same
from ._wheelset_solver import _ASKED, Patch, WheelResult, _number, _rows

_NAMES = (*(name for name in _ASKED if name != "roll_moment"), "friction")
_PATCH = 13


class Mapped(Protocol):
    """What a map is built of: a `Wheelset`."""

    _data: _creepage.WheelsetData

    def _poisson(self) -> float: ...


class ErrorSpread(NamedTuple):
    """An error on states drawn afresh."""

    states: int
    """How many."""
    rms: float
    """Root of the mean square."""
    median: float
    """Half of the states err by less."""
    p95: float
    """95 of 100 states err by less."""
    worst: float
    """Largest."""


class MapErrors(NamedTuple):
    """The errors of a map against the full theory, as measured when it was built."""

    tangential: ErrorSpread
    """Tangential force, in parts of mu N."""
    tangential_transition: ErrorSpread
    """The same where areas of contact join."""
    normal: ErrorSpread
    """Normal force, in parts of N."""
    normal_transition: ErrorSpread
    """The same where areas of contact join."""
    total: ErrorSpread
    """The whole force from position and motion alone, in parts of mu N."""
    total_transition: ErrorSpread
    """The same where areas of contact join."""


class CellError(NamedTuple):
    """The largest errors on the fresh states between two nodes of a map; 0 states: not measured there."""

    states: int
    """How many."""
    tangential: float
    """In parts of mu N."""
    normal: float
    """In parts of N."""


class MapResult:
    """A position of a wheelset, looked up: the attributes of `WheelsetResult`, and the map's error there."""

    status = "solved"
    """Always: what the map does not have is an error."""

    def __init__(self, y: float, yaw: float, found: tuple[Any, ...]) -> None:
        """Made by `ContactMap.solve`."""
        self._numbers, wheels, derivatives = found
        self.y, self.yaw = y, yaw
        self.z, self.roll, self.pitch_rate = (float(number) for number in self._numbers[18:21])
        self._wheels = wheels.reshape(2, -1)
        self.derivatives: Floats | None = (
            None if derivatives is None else derivatives.reshape(2, 6, 8)
        )
        """As `WheelsetSolution.derivatives`, of shape (2, 6, 8), where they were asked for."""

    @property
    def wrench(self) -> Floats:
        """Of the rails on the wheelset about its centre: force along x, y, z (N), moment about them (N m)."""
        wrench: Floats = self._numbers[12:18]
        return wrench

    @property
    def left(self) -> WheelResult:
        """The left wheel."""
        return self._wheel(0)

    @property
    def right(self) -> WheelResult:
        """The right wheel."""
        return self._wheel(1)

    @property
    def error(self) -> tuple[CellError, CellError]:
        """The map's error at the left and the right wheel."""
        left, right = (
            CellError(int(states), float(tangential), float(normal))
            for states, tangential, normal in self._wheels[:, :3]
        )
        return left, right

    @property
    def cautions(self) -> list[str]:
        """What may be off: stretches of the map whose error was not measured."""
        named = zip(("left", "right"), self.error, (self.left, self.right), strict=True)
        return [
            f"{side} wheel: the map's error was not measured here"
            for side, error, wheel in named
            if error.states == 0 and wheel.patches
        ]

    def _wheel(self, k: int) -> WheelResult:
        force = self._numbers[6 * k : 6 * k + 3]
        moment = self._numbers[6 * k + 3 : 6 * k + 6]
        rows = self._wheels[k, 3:].reshape(-1, _PATCH)
        patches = [_patch(row) for row in rows if row[4] > 0.0]
        patches.sort(key=lambda patch: -patch.normal_force)
        return WheelResult(force, moment, tuple(patches), self.pitch_rate, None)

    def __eq__(self, other: object) -> bool:
        """The same numbers; NaN is the same as NaN."""
        return same(vars(self), vars(other)) if isinstance(other, MapResult) else NotImplemented

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        x, y, z = self.wrench[:3]
        return f"<creepage.MapResult wrench {x:.1f}, {y:.1f}, {z:.1f} N>"


class MapMany(NamedTuple):
    """Many positions, looked up: arrays of the shape of the question, forces with six numbers more."""

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
    """rad/s."""
    error: Floats
    """Of the left and the right wheel: tangential, in parts of mu N, and normal, in parts of N; shape
    (..., 2, 2)."""
    status: np.ndarray[Any, np.dtype[np.object_]]
    """ "solved", or why not."""


class ContactMap:
    """The contact map of a wheelset; made by `ContactMap.build`, `Wheelset.map` or `ContactMap.load`.

    It answers what `Wheelset.solver` does, in microseconds, with an error that was measured when it was
    built. Outside its range it raises ValueError with the bound: it does not extrapolate.
    """

    def __init__(self, data: _creepage.ContactMapData) -> None:
        """Made by `ContactMap.build` and `ContactMap.load`."""
        self._data = data

    @classmethod
    def build(
        cls,
        wheelset: Mapped,
        *,
        ellipses: _creepage.Table | str | os.PathLike[str] | None = None,
        y: float = math.nan,
        yaw: float = math.nan,
        loads: ArrayLike = (),
        tolerance: float = math.nan,
        narrowest: float = math.nan,
        states: int = 2,
        resolution: Literal["fast", "standard", "fine"] = "standard",
        journal: str | os.PathLike[str] | None = None,
    ) -> ContactMap:
        """Builds the map of a wheelset on all cores, which takes minutes; its axle load is the usual one.

        y (m) and yaw (rad): largest to either side, 6.2 mm and 10 mrad if not given. loads (N):
        vertical loads of a wheel at the map's nodes, .12 to 2.4 times half the axle load if not
        given. tolerance: part of mu N by which the middle of a cell may be missed before it is
        halved (.01). narrowest: width of a cell that is not halved (50 um). states: drawn afresh in
        each cell, by which the error is measured. ellipses: a table of the theory exact over a/b
        from .15 to 30, or its file; built first where it is left out. journal: a file that keeps
        what is finished, from which an interrupted build goes on.
        """
        plan = [float(number) for number in (y, yaw, tolerance, narrowest)]
        nodes = floats("loads", loads).ravel().tolist()
        _creepage.ContactMapData.check(wheelset._data, plan, nodes, states, resolution)
        table = ellipses
        if table is None:
            table = _creepage.Table.build(
                "exact",
                a_over_b=(0.15, 30.0),
                shapes=19,
                poisson=wheelset._poisson(),
                resolution="standard",
            )
        elif not isinstance(table, _creepage.Table):
            table = _creepage.Table.read(os.fspath(table))
        data = _creepage.ContactMapData.build(
            wheelset._data,
            table,
            plan,
            nodes,
            states,
            resolution,
            None if journal is None else Path(journal),
        )
        return cls(data)

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> ContactMap:
        """Reads a map's file. Raises OSError, or TableError where the file is none or is damaged."""
        return cls(_creepage.ContactMapData.load(path))

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the map's file (NetCDF), which appears when it is whole. Raises OSError."""
        self._data.save(path)

    @property
    def error(self) -> MapErrors:
        """Its error against the full theory on states drawn afresh."""
        rows = (ErrorSpread(int(row[0]), *row[1:]) for row in self._data.error())
        return MapErrors(*rows)

    @property
    def source(self) -> str:
        """The text of the wheelset's file from which it was built."""
        return self._data.source()

    def solve(
        self,
        *,
        y: float | None = None,
        z: float | None = None,
        roll: float | None = None,
        yaw: float | None = None,
        axle_load: float | None = None,
        speed: float | None = None,
        pitch_rate: float | None = None,
        lateral_velocity: float | None = None,
        vertical_velocity: float | None = None,
        roll_rate: float | None = None,
        yaw_rate: float | None = None,
        friction: float | None = None,
        derivatives: bool = False,
    ) -> MapResult:
        """Looks one position and motion up, in SI units, angles in radians: as `WheelsetSolver.solve`.

        What is left out is the wheelset's own. The same bits whatever was asked before. Raises ValueError,
        with the bound, for what lies outside the map.
        """
        given = {"y": y, "z": z, "roll": roll, "yaw": yaw, "axle_load": axle_load}
        given |= {"speed": speed, "pitch_rate": pitch_rate, "lateral_velocity": lateral_velocity}
        given |= {"vertical_velocity": vertical_velocity, "roll_rate": roll_rate}
        given |= {"yaw_rate": yaw_rate, "friction": friction}
        if z is not None and axle_load is not None:
            raise ValueError("z and axle_load exclude each other: one of them presses the wheelset")
        row = [_number(name, given[name]) for name in _NAMES]
        found = self._data.solve(row, derivatives)
        own = self._data.own()
        at = [own[k] if math.isnan(row[k]) else row[k] for k in (0, 3)]
        result = MapResult(at[0], at[1], found)
        for caution in result.cautions:
            warnings.warn(caution, UserWarning, stacklevel=2)
        return result

    def solve_many(self, **quantities: ArrayLike) -> MapMany:
        """Looks many positions and motions up on all cores: arrays or numbers of the quantities of `solve`.

        They are broadcast against one another. A row outside the map has NaN, and the reason in `status`.
        """
        shape, rows = _rows(_NAMES, quantities)
        numbers, wrong = self._data.solve_rows(rows.ravel())
        status = np.full(math.prod(shape), "solved", dtype=object)
        for row, reason in wrong:
            status[row] = reason
        numbers = numbers.reshape(*shape, 25)
        return MapMany(
            numbers[..., 0:6],
            numbers[..., 6:12],
            numbers[..., 12:18],
            numbers[..., 18],
            numbers[..., 19],
            numbers[..., 20],
            numbers[..., 21:25].reshape(*shape, 2, 2),
            status.reshape(shape),
        )

    def __eq__(self, other: object) -> bool:
        """The same map's file."""
        return self._data == other._data if isinstance(other, ContactMap) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._data)

    def __repr__(self) -> str:
        error = self.error.tangential
        return f"<creepage.ContactMap, tangential force within {100 * error.rms:.2f} % of mu N rms>"


def _patch(row: Floats) -> Patch:
    x, y, z, angle, load, peak, area, *rest = (float(number) for number in row)
    creepage = (rest[0], rest[1], rest[2])
    force = (rest[3], rest[4], rest[5])
    return Patch((x, y, z), angle, load, peak, area, creepage, force)
