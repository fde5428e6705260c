"""Pictures by matplotlib, of plain arrays."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import cycle
from typing import TYPE_CHECKING, Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Ellipse, Patch

if TYPE_CHECKING:
    from matplotlib.axes import Axes

ADHESION, SLIP = "#cfe3f5", "#f7d9b9"
OUTSIDE = 2
"""Number of the region."""
ARROWS = 16
STYLES = ("-", "--", "-.", ":")
"""Lines can be told apart without colours."""


def plot_field(
    position: np.ndarray[Any, Any],
    region: np.ndarray[Any, Any],
    traction: np.ndarray[Any, Any],
    semi_axes: tuple[float, float],
    ax: Axes | None,
    unit: str = "c",
) -> Axes:
    """Areas and arrows over a grid; positions and semi-axes in `unit`."""
    if region.ndim != 2:
        raise ValueError("a field is drawn over a grid: ask it of the theory without x and y")
    if ax is None:
        ax = plt.subplots(layout="constrained")[1]
    x, y = position[..., 0], position[..., 1]
    a, b = semi_axes
    edge = Ellipse((0.0, 0.0), 2 * a, 2 * b, fill=False, color="#333333")
    ax.add_patch(edge)
    _areas(ax, x, y, region, edge)
    _arrows(ax, x, y, region != OUTSIDE, traction)
    ax.set(aspect="equal", xlim=(-1.05 * a, 1.05 * a), ylim=(-1.05 * b, 1.05 * b))
    if a < 0.4 * b:
        ax.set_xticks([0.0])  # there is no room for more, and the scale is that of y
    ax.set_xlabel(f"x, rolling direction ({unit})")
    ax.set_ylabel(f"y ({unit})")
    ax.invert_yaxis()
    shown = [Patch(color=ADHESION, label="adhesion"), Patch(color=SLIP, label="slip")]
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


def _areas(
    ax: Axes,
    x: np.ndarray[Any, Any],
    y: np.ndarray[Any, Any],
    region: np.ndarray[Any, Any],
    edge: Ellipse,
) -> None:
    """Adhesion and slip up to the edge: beyond it each point is as the nearest one inside."""
    if (region != OUTSIDE).any() and min(region.shape) > 1:
        filled = _filled(_filled(region).T).T
        x, y = (np.pad(at, 1, mode="reflect", reflect_type="odd") for at in (x, y))
        areas = ax.contourf(
            x, y, np.pad(filled, 1, mode="edge"), levels=[-1.0, 0.5, 2.0], colors=[ADHESION, SLIP]
        )
        areas.set_clip_path(edge)


def _filled(region: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """Rows with points inside, each filled from these."""
    filled = region.copy()
    columns = np.arange(region.shape[1])
    for row in filled:
        inside = np.flatnonzero(row != OUTSIDE)
        if inside.size:
            row[:] = row[inside[np.abs(columns[:, None] - inside).argmin(axis=1)]]
    return filled


def _arrows(
    ax: Axes,
    x: np.ndarray[Any, Any],
    y: np.ndarray[Any, Any],
    inside: np.ndarray[Any, Any],
    traction: np.ndarray[Any, Any],
) -> None:
    """The traction at points as far from each other along x as across."""
    width = max(np.ptp(x), np.ptp(y)) / ARROWS
    spans = [np.hypot(np.ptp(x, axis=k).max(), np.ptp(y, axis=k).max()) for k in (0, 1)]
    steps = [max(round(width * n / span), 1) if span > 0.0 else 1 for span, n in zip(spans, x.shape)]
    chosen = tuple(slice((n - 1) % step // 2, None, step) for n, step in zip(x.shape, steps))
    shown = inside[chosen]
    arrows = traction[chosen][shown]
    ax.quiver(
        x[chosen][shown],
        y[chosen][shown],
        arrows[:, 0],
        arrows[:, 1],
        angles="xy",
        scale_units="xy",
        scale=1.0 / (1.5 * width) if width > 0.0 else None,
        units="inches",
        width=0.016,
        color="#222222",
    )


def plot_lines(
    values: np.ndarray[Any, Any],
    forces: Mapping[str, np.ndarray[Any, Any]],
    at: float,
    limit: float,
    labels: tuple[str, str],
    ax: Axes | None,
) -> Axes:
    """Forces (N) over values, a line a theory; `at` is marked, and `limit` not far exceeded."""
    if ax is None:
        ax = plt.subplots(layout="constrained")[1]
    for (name, force), style in zip(forces.items(), cycle(STYLES)):
        ax.plot(values, 1e-3 * force, style, label=name)
    ax.axvline(at, color="#999999", lw=0.8, ls=":")
    ax.set_xlabel(labels[0])
    ax.set_ylabel(labels[1])
    low, high = ax.get_ylim()  # linear theory knows no limit of friction
    ax.set_ylim(max(low, -1.25e-3 * limit), min(high, 1.25e-3 * limit))
    ax.grid(alpha=0.3)
    ax.legend()
    return ax
