"""Wear of wheels and rails over a distance."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from . import _creepage
from ._contact import floats
from ._results import Comparable, Floats
from ._toml import dumps
from ._wheelset import Wheelset


@dataclass(frozen=True, slots=True, eq=False)
class WornBody(Comparable):
    """A wheel or a rail over all stops, the new one first; SI units, NaN where a wheel has no such measure."""

    name: str
    """"wheel_left", "wheel_right", "rail_left" or "rail_right"."""
    points: list[Floats]
    """Its profile at each stop, of shape (n, 2): y to the field side, z down (m)."""
    depth: list[Floats]
    """Depth taken off at each of the points along the normal (m)."""
    greatest_depth: Floats
    """The greatest depth at each stop (m)."""
    area: Floats
    """Area of the section that is lost (m2)."""
    volume: Floats
    """Volume that is lost (m3); of a rail per metre (m3/m)."""
    flange_height: Floats
    """Sh by EN 15313 (m)."""
    flange_thickness: Floats
    """Sd (m)."""
    flange_slope: Floats
    """qR (m)."""
    hollow: Floats
    """How far the field side stands above the tread (m)."""


class Wear:
    """Profiles of wheels and rails over a distance; made by `wear`."""

    distance: Floats
    """Distance of each stop (m), the new profiles at 0."""
    passages: Floats
    """Passages over the rails at each stop."""
    steps: Floats
    """Steps so far."""
    conicity: Floats
    """Equivalent conicity at 3 mm by EN 15302; NaN where it cannot be computed, as where contact ends before."""
    bodies: dict[str, WornBody]
    """What wears, by its name."""
    cautions: list[str]
    """Cautions about it, in words."""
    is_solved: bool
    """Whether all situations of all steps converged."""
    ended: str | None
    """Where and why it ended before its distance, in words: the first of `limits` that was reached."""

    def __init__(self, wheelset: Wheelset, text: str | None, data: _creepage.WearData) -> None:
        """Made by `wear`."""
        self._wheelset, self._text, self._data = wheelset, text, data
        self.distance, self.passages, self.steps, self.conicity = data.stops()
        self.is_solved, self.cautions = data.outcome()
        self.ended = data.ended()
        self.bodies = {}
        for name in data.bodies():
            profiles = data.profiles(name)
            points = [points.reshape(-1, 2) for points, _ in profiles]
            depth = [depth for _, depth in profiles]
            self.bodies[name] = WornBody(name, points, depth, **data.numbers(name))

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (self._wheelset, self._text, self._data.saved())

    def __eq__(self, other: object) -> bool:
        """The same profiles at the same stops, to the last bit."""
        return self._data.saved() == other._data.saved() if isinstance(other, Wear) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._data.saved())

    def __repr__(self) -> str:
        way = f"{self.distance[-1]:.4g} m, {len(self.distance)} stops"
        return f"<creepage.Wear of {', '.join(self.bodies)}: {way}>"

    def to_dict(self) -> dict[str, Any]:
        """What `report.json` holds; the names carry their units."""
        report: dict[str, Any] = json.loads(self._data.json())
        return report

    def text(self) -> str:
        """A table for a terminal."""
        return self._data.text()

    def __str__(self) -> str:
        return self.text()

    def svg(self, role: Literal["wheel", "rail"] = "wheel") -> str | None:
        """The picture of wheels or rails; None where none wear."""
        return self._data.svg(role)

    def _repr_svg_(self) -> str | None:
        return self.svg("wheel") or self.svg("rail")

    def save(self, directory: str | os.PathLike[str]) -> list[Path]:
        """Writes the files of `creepage wear` into a directory. Raises OSError, FileExistsError for a file that
        the wheelset was read from."""
        return [Path(path) for path in self._data.write(Path(directory))]


def wear(
    wheelset: Wheelset,
    *,
    situations: Mapping[str, ArrayLike] | None = None,
    state: str | os.PathLike[str] | None = None,
    progress: Callable[[float], object] | None = None,
    **options: Any,
) -> Wear:
    """Runs a wheelset over a distance and takes off what its contacts wear, step by step.

    situations are arrays of one length by their names, in SI units. `share` is the part of the
    distance, the same for all if it is left out. Others are y, z, roll, yaw, axle_load,
    roll_moment, speed, pitch_rate, lateral_velocity, vertical_velocity, roll_rate, yaw_rate, friction, curvature; NaN is the
    wheelset's own. options are the keys of `[wear]`. Words are law ("archard", "usfd"), body
    ("wheel", "rail", "both"), sides ("each", "mean") and table. Numbers are distance, step_depth,
    smoothing_length, spacing (m), passages and stops; spread is a mapping. limits are measures at
    which the run ends, such as `{"hollow": 2e-3}`. With neither the wheelset's own `[wear]` is
    taken.

    With a file state a run that was stopped goes on where it was, to the same bits; it is not removed. progress
    hears the part of the distance that is done, before every step. Raises CaseError for what is asked, OSError for
    files, RuntimeError for a situation that cannot be solved on the way. Cautions are warned of.

        >>> import creepage
        >>> wheelset = creepage.Wheelset(wheel="S1002", rail="UIC60", cant=0.025, axle_load=160e3, theory="fastsim")
        >>> worn = creepage.wear(wheelset, law="usfd", distance=2e6, stops=1,
        ...                      situations={"share": [0.5, 0.5], "y": [1e-3, -1e-3]})
        >>> bool(worn.bodies["wheel_left"].greatest_depth[-1] > 0.0)
        True
    """
    text = None
    if situations is not None or options:
        section = dict(options)
        if situations is not None:
            section["situation"] = _rows(situations)
        text = dumps({"wear": section})
    place = None if state is None else Path(state)
    data = _creepage.WearData.run(wheelset._data, text, wheelset._directory, place, progress)
    worn = Wear(wheelset, text, data)
    for words in worn.cautions:
        warnings.warn(words, UserWarning, stacklevel=2)
    return worn


def _restored(wheelset: Wheelset, text: str | None, saved: str) -> Wear:
    """What ran before, from pickle."""
    data = _creepage.WearData.restored(wheelset._data, text, wheelset._directory, saved)
    return Wear(wheelset, text, data)


def _rows(situations: Mapping[str, ArrayLike]) -> list[dict[str, float]]:
    """Columns as rows, without what is NaN."""
    columns = {name: np.atleast_1d(floats(name, values)) for name, values in situations.items()}
    shapes = {column.shape for column in columns.values()}
    shape = np.broadcast_shapes(*shapes)
    if len(shape) != 1:
        raise ValueError(f"situations must be arrays of one length, got shapes {sorted(shapes)}")
    wide = {name: np.broadcast_to(column, shape) for name, column in columns.items()}
    return [
        {name: float(column[k]) for name, column in wide.items() if not np.isnan(column[k])}
        for k in range(shape[0])
    ]
