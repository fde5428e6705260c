"""One case solved, in SI units."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import numpy as np

from . import _creepage
from ._contact import Hertz
from ._report import Quantity, quantities
from ._results import Field, Floats, ScalarForce, SiField, Status
from ._theories import prepared

if TYPE_CHECKING:
    import os

    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike


class SiCreepage(NamedTuple):
    """Creepage of the upper body relative to the lower, over the rolling velocity."""

    longitudinal: float
    lateral: float
    spin: float
    """rad/m."""


class DimensionlessCreepage(NamedTuple):
    """Creepage in the thesis' units."""

    xi: float
    """Longitudinal creepage times rho / (mu c)."""
    eta: float
    """Lateral creepage times rho / (mu c)."""
    chi: float
    """Spin times rho / mu."""


class SiForce(NamedTuple):
    """Tangential force and moment of the upper body on the lower."""

    longitudinal: float
    """N."""
    lateral: float
    """N."""
    moment: float
    """N m."""


class Below(NamedTuple):
    """Stress and displacement inside a body."""

    stress: Floats
    """xx, yy, zz, xy, yz, xz (Pa), positive in tension, in a last dimension of six."""
    displacement: Floats
    """u, v, w (m), w into the body, in a last dimension of three; it vanishes far away."""
    settled_depth: float
    """Stresses less deep than this (m) depend on the elements of the theory; zero in closed form."""


class Solution:
    """One case solved by one theory, in SI units.

    Force, creepage and heat are at hand; the areas of adhesion and slip, the field, the report and
    the pictures are computed when they are asked for.
    """

    __slots__ = ("_data", "_name", "_options", "_solved")

    def __init__(self, data: _creepage.CaseData, name: str, options: dict[str, Any]) -> None:
        """Solves: made by `Case.solve`."""
        self._data, self._name, self._options = data, name, options
        self._solved = data.solve(name, options)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self._data, self._name, self._options)

    def __repr__(self) -> str:
        return f"<creepage.Solution {self._name}: {self.status.name.lower()}, {self.force}>"

    def __str__(self) -> str:
        return self.text()

    def __eq__(self, other: object) -> bool:
        """The same case solved by the same theory with the same options."""
        if not isinstance(other, Solution):
            return NotImplemented
        return (self._data, self._question()) == (other._data, other._question())

    def __hash__(self) -> int:
        return hash((self._data, self._name))

    def _question(self) -> tuple[str, list[tuple[str, str]]]:
        return self._name, sorted((name, repr(value)) for name, value in self._options.items())

    @property
    def theory(self) -> _creepage.Theory:
        """The theory, prepared for this contact; ask it for more."""
        return prepared(self._data, self._name, self._options)

    @property
    def status(self) -> Status:
        """Whether the force may be trusted."""
        return self.dimensionless.status

    @property
    def caution(self) -> str | None:
        """Cautions about the solution, in words: a status other than solved, what the
        theory neglects though it matters, a wanted accuracy that was not reached."""
        return self._solved.caution

    @property
    def force(self) -> SiForce:
        """On the lower body; the upper body feels the reverse."""
        return SiForce(*self._solved.force)

    @property
    def dimensionless(self) -> ScalarForce:
        """The same in units of mu N and mu N c; an ExactForce where there are error bars."""
        return self._solved.dimensionless

    @property
    def creepage(self) -> SiCreepage:
        """Given or found."""
        return SiCreepage(*self._solved.creepage)

    @property
    def dimensionless_creepage(self) -> DimensionlessCreepage:
        """The same in the thesis' units."""
        creepage, (length, slip, _, _) = self.creepage, self._data.units
        return DimensionlessCreepage(
            creepage.longitudinal / slip, creepage.lateral / slip, creepage.spin * length / slip
        )

    @property
    def force_error(self) -> SiForce | None:
        """Error bars of the force; None by a theory without."""
        errors = [
            self.quantities[f"lower_body.{key}"].error
            for key in ("longitudinal_n", "lateral_n", "moment_n_m")
        ]
        longitudinal, lateral, moment = errors
        if longitudinal is None or lateral is None or moment is None:
            return None
        return SiForce(longitudinal, lateral, moment)

    @property
    def contact(self) -> Hertz:
        """The contact ellipse and its pressure."""
        return Hertz.from_report(json.loads(self._data.hertz()))

    @property
    def friction(self) -> float:
        """Coefficient of friction mu."""
        return self._data.friction

    @property
    def adhesion_share(self) -> float:
        """Adhesion area over contact area, 0 to 1; traced when it is first asked for."""
        return self._solved.adhesion_share

    @property
    def adhesion_area(self) -> float:
        """m^2."""
        return self.adhesion_share * math.pi * self.length**2

    @property
    def slip_area(self) -> float:
        """m^2."""
        return (1.0 - self.adhesion_share) * math.pi * self.length**2

    @property
    def heat_per_metre(self) -> float:
        """Energy turned to heat per metre rolled, from force and creepage (J/m)."""
        return self._solved.heat_per_metre

    @property
    def heat_per_metre_by_slip(self) -> float | None:
        """The same from traction and slip over the contact (J/m), where the theory gives it; the
        two differ by the error of its discretization."""
        return self._solved.heat_per_metre_by_slip

    @property
    def speed(self) -> float | None:
        """Rolling velocity (m/s), where the case has it."""
        return self._data.speed

    @property
    def power(self) -> float | None:
        """Frictional power (W), where the rolling velocity is known."""
        return self._solved.power

    @property
    def known(self) -> tuple[str, ...] | None:
        """Which of xi, eta, chi, fx, fy, mz were given, where forces were wanted."""
        known = self._solved.known
        return None if known is None else tuple(known)

    @property
    def details(self) -> dict[str, float]:
        """What only this theory says, such as error bars, by name."""
        return self._solved.details

    @property
    def damage(self) -> dict[str, Any] | None:
        """Wear and fatigue numbers as `damage` of `report.json` has them, the names with their units;
        None where the case asks for none."""
        damage: dict[str, Any] | None = self.to_dict()["damage"]
        return damage

    @property
    def heat(self) -> dict[str, Any] | None:
        """Temperatures as `heat` of `report.json` has them, the names with their units. None where
        the case does not ask for them, or where they cannot be computed; then a caution says why."""
        heat: dict[str, Any] | None = self.to_dict()["heat"]
        return heat

    @property
    def length(self) -> float:
        """The unit of length, c = sqrt(a b) (m)."""
        return self._data.units[0]

    @property
    def quantities(self) -> dict[str, Quantity]:
        """Every number of the report by its path, with label, unit and error bar.

        `solution.quantities["contact.peak_pressure_pa"]` is
        `Quantity(label='peak pressure', unit='Pa', value=1138897937.96, error=0.0)` for a wheel on a rail.
        """
        return quantities(self._solved.quantities())

    def to_dict(self) -> dict[str, Any]:
        """What `report.json` holds; the names carry their units."""
        report: dict[str, Any] = json.loads(self._solved.json())
        return report

    def field(self, points: int = 50) -> Field:
        """Traction and slip at points x points cells, dimensionless."""
        return self._solved.field(points)

    def si_field(self, points: int = 50) -> SiField:
        """Pressure, traction and slip at points x points cells, in SI units."""
        field, data = self.field(points), self._data
        length, slip, _, traction = data.units
        a, b = (semi_axis * length for semi_axis in field.semi_axes)
        position = length * field.position
        height = 1.0 - (position[..., 0] / a) ** 2 - (position[..., 1] / b) ** 2
        pressure = self.contact.peak_pressure * np.sqrt(np.maximum(height, 0.0))
        return SiField(
            position, pressure, traction * field.traction, slip * field.slip, field.region, (a, b)
        )

    def below(
        self, x: ArrayLike, y: ArrayLike, z: ArrayLike, body: Literal["lower", "upper"] = "lower"
    ) -> Below:
        """Stress and displacement inside one body at points (m), z from the surface into that body.

        Arguments broadcast. Raises InvalidValue for points that are not finite or above the surface,
        and ValueError for another body.
        """
        stress, displacement, settled = self._solved.below(body, (x, y, z))
        return Below(stress, displacement, settled)

    def points(self) -> Field:
        """Traction and slip at the theory's own points, dimensionless."""
        return self._solved.points()

    def text(self) -> str:
        """A short report for a terminal."""
        return self._solved.text()

    def svg(self) -> str:
        """The contact seen from above: adhesion, slip and traction."""
        return self._solved.svg()

    _repr_svg_ = svg

    def save(self, directory: str | os.PathLike[str]) -> list[Path]:
        """Writes report.json, points.csv, contact.svg, .png and .vtk into the directory.

        It is made when missing; files of those names are replaced, all of them or none. Gives
        their paths. Raises OSError, FileExistsError for a file that the case was read from.
        """
        return [Path(path) for path in self._solved.write(Path(directory))]

    def plot(self, ax: Axes | None = None) -> Axes:
        """Areas of adhesion and slip and the traction, in millimetres. Needs matplotlib."""
        from ._plot import plot_field

        field, force, scale = self.field(), self.force, 1e3 * self.length
        a, b = field.semi_axes
        axes = (scale * a, scale * b)
        ax = plot_field(scale * field.position, field.region, field.traction, axes, ax, "mm")
        ax.set_title(
            f"{self._name}: {1e-3 * force.longitudinal:.3f} kN along, "
            f"{1e-3 * force.lateral:.3f} kN across,\n"
            f"{100 * self.adhesion_share:.0f} % adhesion, {self.heat_per_metre:.3g} J/m",
            fontsize="medium",
            pad=22,
        )
        return ax
