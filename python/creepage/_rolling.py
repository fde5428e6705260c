"""Unsteady rolling: a contact that remembers, step by step or by a whole history."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from . import _creepage
from ._case import Case
from ._contact import floats, number
from ._results import Status, names
from ._solution import SiCreepage, SiForce
from ._toml import Source, text_of

if TYPE_CHECKING:
    import pandas as pd

RollingCase: TypeAlias = Case | Source | Mapping[str, Mapping[str, Any]]
Start: TypeAlias = Literal["none", "steady"] | tuple[float, float]


@dataclass(frozen=True, slots=True)
class RollingStep:
    """What a step leads to, in SI units; for line contacts forces are per metre of the line."""

    distance: float
    """Distance rolled since the beginning (m)."""
    force: SiForce
    """Force and moment of the upper body on the lower at the end of the step."""
    creepage: SiCreepage
    """Creepage at the end of the step, prescribed or found."""
    adhesion_share: float
    """Share of the contact area that adheres."""
    status: Status
    """Whether the numbers may be trusted."""


class Rolling:
    """A contact that rolls on, whose past decides with the motion what comes.

    case: a Case, whose own creepage is not used, or the case file of `creepage roll`. The file is a
    path, its text (a string with line breaks), or its sections as a mapping. start: "none" is
    without traction. "steady" is as if the bodies had always rolled with the motion of the first
    step. Two forces (N), longitudinal and lateral on the lower body, shift the bodies before they
    roll. By default it is as the file says, or none. Raises CaseError for what cannot roll, and
    warns of what the contact is in doubt for.

    It may be pickled and copied with all that it remembers, and used from several threads, one step
    after the other.
    """

    def __init__(self, case: RollingCase, *, start: Start | None = None) -> None:
        self._source = (*_text(case), _start(start))
        self._data = _creepage.RollingData(*self._source)
        if (caution := self._data.caution) is not None:
            warnings.warn(caution, stacklevel=2)

    def step(
        self,
        distance: float,
        *,
        longitudinal: float | None = None,
        lateral: float | None = None,
        spin: float | None = None,
        longitudinal_force: float | None = None,
        lateral_force: float | None = None,
        moment: float | None = None,
        normal_force: float | None = None,
    ) -> RollingStep:
        """Rolls on by a distance (m), in steps as short as the accuracy needs.

        Each component of the motion is given as a creepage (spin in rad/m) or as the force on the
        lower body (N, N m) that causes it. If neither is given, its creepage is zero. normal_force
        (N): the case's own if not given. Raises InvalidValue and ValueError, the contact being as
        it was; warns where a step did not converge, and of a creepage above .3.
        """
        given = {
            "distance": distance,
            "longitudinal": longitudinal,
            "lateral": lateral,
            "spin": spin,
            "longitudinal_force": longitudinal_force,
            "lateral_force": lateral_force,
            "moment": moment,
            "normal_force": normal_force,
        }
        values = [(name, value) for name, value in given.items() if value is not None]
        for name, value in values:
            number(name, value)
        rolled, creepage, force, share, code, caution = self._data.step(values)
        if caution is not None:
            warnings.warn(caution, stacklevel=2)
        status = Status(code)
        if status is Status.NOT_CONVERGED:
            warnings.warn(
                "the step did not converge: its force is that of the last iterate", stacklevel=2
            )
        return RollingStep(rolled, SiForce(*force), SiCreepage(*creepage), share, status)

    def save(self) -> bytes:
        """What the contact remembers, for restore: a larger program's rejected step."""
        return self._data.save()

    def restore(self, state: bytes) -> None:
        """Goes back, or on, to what save gave: the steps after it are the same to the last bit.

        Raises ValueError for bytes that are no state of this contact.
        """
        self._data.restore(state)

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (self._source, self.save())


def _restored(source: tuple[str, bool, Any], state: bytes) -> Rolling:
    """What was pickled."""
    rolling = Rolling.__new__(Rolling)
    rolling._source, rolling._data = source, _creepage.RollingData(*source)
    rolling.restore(state)
    return rolling


def roll(
    case: RollingCase,
    history: Mapping[str, ArrayLike] | pd.DataFrame,
    *,
    start: Start | None = None,
) -> dict[str, Any]:
    """Rolls a contact by a whole history: the numbers of `creepage roll` to the last bit.

    case, start: as of Rolling. history: arrays of one length, or a frame of pandas, with the
    columns of the command's table. These are `distance` (m), `normal_force` (N) and the components
    of the motion. A component is a creepage, `longitudinal`, `lateral`, `spin` (rad/m) or `xi`,
    `eta`, `chi`, or a force, `longitudinal_force`, `lateral_force` (N), `moment` (N m). A row's
    motion acts from the distance of the row before, or zero, to its own. Gives arrays named as the
    columns of `history.csv`. Raises CaseError, InvalidValue and ValueError, which name column and
    row, and TypeError for other values than numbers and for masked elements; warns where rows did
    not converge, of the first row with a creepage above .3, and of what the contact is in doubt for.
    """
    columns = [(str(name), _column(str(name), values)) for name, values in history.items()]
    if len({values.size for _, values in columns}) > 1:
        sizes = ", ".join(f"{name}: {values.size}" for name, values in columns)
        raise ValueError(f"columns must have one length, not {sizes}")
    found, caution = _creepage.roll(*_text(case), _start(start), columns)
    table: dict[str, Any] = dict(found)
    if caution is not None:
        warnings.warn(caution, stacklevel=2)
    failed = int(np.count_nonzero(table["status"] == Status.NOT_CONVERGED))
    if failed:
        warnings.warn(
            f"{failed} rows did not converge: their forces are those of the last iterate",
            stacklevel=2,
        )
    table["status"] = names(table["status"])
    return table


def _column(name: str, values: ArrayLike) -> np.ndarray[Any, np.dtype[np.float64]]:
    array = np.ascontiguousarray(floats(f"column {name}", values))
    if array.ndim != 1:
        raise ValueError(f"column {name} must be a list of numbers, not of shape {array.shape}")
    return array


def _text(case: RollingCase) -> tuple[str, bool]:
    """The text of its file, and whether that is of steady rolling."""
    if isinstance(case, Case):
        return case.to_toml(), True
    return text_of(case), False


def _start(start: Start | None) -> bool | tuple[float, float] | None:
    """As the compiled part has it: forces of a shift, or whether rolling was steady."""
    if start is None:
        return None
    if isinstance(start, str):
        if start not in ("none", "steady"):
            raise ValueError(f'start = "{start}" is not valid: it must be "none", "steady" or forces')
        return start == "steady"
    longitudinal, lateral = start
    return float(longitudinal), float(lateral)
