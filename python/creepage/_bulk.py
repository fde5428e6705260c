"""Many rows of a case, or of dimensionless contacts: answers row by row, and why a row has none."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Generic

import numpy as np
from numpy.typing import NDArray

from . import _creepage
from ._results import Comparable, Number, Outcome, Status, by_name, names

ERRORS = ("fx_error", "fy_error", "mz_error")
COLUMNS = {
    "longitudinal": "longitudinal_n",
    "lateral": "lateral_n",
    "moment": "moment_n_m",
    "heat_per_metre": "frictional_power_per_metre_j_per_m",
    "power": "frictional_power_w",
}
"""The names of the command's columns."""


@dataclass(frozen=True, slots=True, eq=False)
class CaseForce(Comparable, Generic[Number, Outcome]):
    """Forces of a case in SI units: floats and a Status, or arrays of one shape.

    Unpacks into longitudinal force, lateral force and moment.
    """

    longitudinal: Number
    """Longitudinal force of the upper body on the lower (N)."""
    lateral: Number
    """Lateral force of the upper body on the lower (N)."""
    moment: Number
    """Moment about the normal (N m)."""
    heat_per_metre: Number
    """Energy turned to heat per metre rolled (J/m), from force and creepage."""
    power: Number | None
    """Frictional power (W), where there is a speed."""
    fx: Number
    """Longitudinal, F_x / (mu N)."""
    fy: Number
    """Lateral, F_y / (mu N)."""
    mz: Number
    """Moment, M_z / (mu N c)."""
    fx_error: Number | None
    """Error bar of fx, in units of mu N; None by a theory without error bars."""
    fy_error: Number | None
    """Error bar of fy."""
    mz_error: Number | None
    """Error bar of mz, in units of mu N c."""
    damage: dict[str, Number]
    """Of a case with `damage`: wear and fatigue numbers by their names in report.json, T gamma first."""
    status: Outcome
    """A Status, or an array of their numbers; INVALID where the values are no case, such as NaN."""
    messages: dict[int, str]
    """Cautions about elements, in words, by their index in the flattened arrays."""

    def __iter__(self) -> Any:
        return iter((self.longitudinal, self.lateral, self.moment))

    def to_dict(self) -> dict[str, Any]:
        """A flat column each, named as those of `creepage batch --case`, with the status in words
        and the messages; pandas.DataFrame takes it as it is."""
        own = {COLUMNS.get(name, name): value for name, value in by_name(self).items()}
        del own["messages"], own["status"]
        own |= own.pop("damage")
        columns = {name: np.ravel(value) for name, value in own.items() if value is not None}
        return {**columns, **words(np.ravel(self.status).astype(np.uint8), self.messages)}


def case_force(
    data: _creepage.CaseData,
    theory: str,
    options: dict[str, Any],
    table: _creepage.Table | None,
    quantities: dict[str, Any],
) -> CaseForce[Any, Any]:
    """Forces of a case some of whose quantities are arrays."""
    found = _creepage.case_forces(data, theory, options, table, quantities)
    messages = dict(found.pop("messages"))
    status = found.pop("status")
    fields = ("power", *ERRORS)
    columns = {**dict.fromkeys(fields), **found}
    if status.ndim == 0:
        columns = {name: v if v is None else float(v) for name, v in columns.items()}
        status = Status(int(status))
    by_law = {name: columns.pop(name) for name in data.damage_columns}
    return CaseForce(**columns, damage=by_law, status=status, messages=messages)


def words(codes: NDArray[np.uint8], messages: Mapping[int, str]) -> dict[str, Any]:
    """The last two columns of a table."""
    column = np.full(len(codes), "", dtype=object)
    for row, message in messages.items():
        column[row] = message
    return {"status": names(codes), "message": column}
