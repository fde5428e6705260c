"""Creep-force curves."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from ._results import Floats

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._case import Case

Component = Literal["longitudinal", "lateral", "spin"]
COMPONENTS: tuple[Component, Component, Component] = ("longitudinal", "lateral", "spin")


@dataclass(frozen=True, slots=True, eq=False)
class Curve:
    """Creep-force curves of one or several theories, in SI units."""

    vary: Component
    values: Floats
    """Of the component that varies; spin in rad/m."""
    forces: dict[str, Floats]
    """By theory: rows longitudinal force (N), lateral force (N), moment (N m)."""
    case: Case

    def to_dict(self) -> dict[str, Any]:
        """A row a point and theory; pandas.DataFrame takes it as it is."""
        creepage = self.case.creepage._asdict()
        count = len(self.values)
        columns: dict[str, Any] = {
            "theory": np.repeat(np.array(list(self.forces)), count),
            **{name: np.full(count * len(self.forces), creepage[name]) for name in COMPONENTS},
        }
        columns[self.vary] = np.tile(self.values, len(self.forces))
        table = np.concatenate(list(self.forces.values()), axis=1)
        names = ("longitudinal_n", "lateral_n", "moment_n_m")
        return {**columns, **dict(zip(names, table, strict=True))}

    def plot(self, ax: Axes | None = None) -> Axes:
        """The forces over the component that varies. Needs matplotlib."""
        from ._plot import plot_curve

        return plot_curve(self, ax)
