"""Pictures by matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.patches import Ellipse, Patch

from ._results import Field, Region

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._curve import Curve
    from ._solution import Solution

ADHESION, SLIP = "#cfe3f5", "#f7d9b9"
LABELS = {
    "longitudinal": "longitudinal creepage",
    "lateral": "lateral creepage",
    "spin": "spin (rad/m)",
}
ARROWS = 16


def plot_field(field: Field, ax: Axes | None, length: float = 1.0, unit: str = "c") -> Axes:
    """Areas and arrows; `length` is c in `unit`."""
    if field.region.ndim != 2:
        raise ValueError("a field is drawn over a grid: ask it of the theory without x and y")
    if ax is None:
        ax = plt.subplots()[1]
    x, y = length * field.position[..., 0], length * field.position[..., 1]
    areas = np.ma.masked_where(~field.inside, field.region)
    colours = ListedColormap([ADHESION, SLIP])
    ax.pcolormesh(x, y, areas, cmap=colours, vmin=0, vmax=1, shading="nearest", rasterized=True)
    _arrows(field, ax, x, y)
    a, b = field.semi_axes
    edge = Ellipse((0.0, 0.0), 2 * length * a, 2 * length * b, fill=False, color="#333333")
    ax.add_patch(edge)
    ax.set_aspect("equal")
    ax.set_xlabel(f"x, rolling direction ({unit})")
    ax.set_ylabel(f"y ({unit})")
    ax.invert_yaxis()
    areas_of = {Region.ADHESION: ADHESION, Region.SLIP: SLIP}
    shown = [Patch(color=areas_of[r], label=r.name.lower()) for r in areas_of]
    above = (0.5, 1.0)
    ax.legend(
        handles=shown,
        ncols=2,
        frameon=False,
        fontsize="small",
        loc="lower center",
        bbox_to_anchor=above,
    )
    return ax


def _arrows(field: Field, ax: Axes, x: np.ndarray, y: np.ndarray) -> None:
    """The traction at every few points."""
    step = tuple(slice(max(n // ARROWS // 2, 0), None, max(n // ARROWS, 1)) for n in x.shape)
    inside = field.inside[step]
    traction = field.traction[step][inside]
    width = np.ptp(x) / ARROWS
    ax.quiver(
        x[step][inside],
        y[step][inside],
        traction[:, 0],
        traction[:, 1],
        angles="xy",
        scale_units="xy",
        scale=1.0 / (1.5 * width) if width > 0.0 else None,
        width=0.003,
        color="#222222",
    )


def plot_solution(solution: Solution, ax: Axes | None) -> Axes:
    """The field in millimetres, with force and heat in the title."""
    ax = plot_field(solution.field(), ax, 1e3 * solution.length, "mm")
    force = solution.force
    ax.set_title(
        f"{solution.theory.name}: {1e-3 * force.longitudinal:.3f} kN along, "
        f"{1e-3 * force.lateral:.3f} kN across,\n"
        f"{100 * solution.adhesion_share:.0f} % adhesion, {solution.heat_per_metre:.3g} J/m",
        fontsize="medium",
        pad=22,
    )
    return ax


def plot_curve(curve: Curve, ax: Axes | None) -> Axes:
    """The force that the component makes, a line a theory; the case itself is marked."""
    if ax is None:
        ax = plt.subplots()[1]
    row = 0 if curve.vary == "longitudinal" else 1
    for name, forces in curve.forces.items():
        ax.plot(curve.values, 1e-3 * forces[row], label=name)
    ax.axvline(getattr(curve.case.creepage, curve.vary), color="#999999", lw=0.8, ls=":")
    ax.set_xlabel(LABELS[curve.vary])
    ax.set_ylabel(f"{'longitudinal' if row == 0 else 'lateral'} force on the lower body (kN)")
    limit = 1.25e-3 * curve.case.friction * curve.case.contact.normal_force
    low, high = ax.get_ylim()  # linear theory knows no limit of friction
    ax.set_ylim(max(low, -limit), min(high, limit))
    ax.grid(alpha=0.3)
    ax.legend()
    return ax
