"""Cases in SI units: two bodies, what presses them together, how they creep."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _creepage
from ._contact import Body, Hertz, sections
from ._results import Field, Floats, Force, ScalarForce, Status
from ._theories import find, options_of
from ._toml import Source, dumps, read

if TYPE_CHECKING:
    import os

    from matplotlib.axes import Axes

Component = Literal["longitudinal", "lateral", "spin"]
COMPONENTS: tuple[Component, Component, Component] = ("longitudinal", "lateral", "spin")


class SiCreepage(NamedTuple):
    """Creepage of the upper body relative to the lower, over the rolling velocity."""

    longitudinal: float
    lateral: float
    spin: float
    """rad/m."""


class SiForce(NamedTuple):
    """Tangential force and moment of the upper body on the lower."""

    longitudinal: float
    """N."""
    lateral: float
    """N."""
    moment: float
    """N m."""


class Case:
    """One rolling contact in SI units.

    x is the rolling direction, y points to its right, z into the lower body. Raises CaseError,
    which names the section and the key of the case file, for numbers out of range, for
    contradictions, and for bodies without a contact ellipse along the rolling direction.
    """

    def __init__(
        self,
        *,
        upper: Body,
        lower: Body,
        normal_force: float,
        friction: float,
        longitudinal: float | None = None,
        lateral: float | None = None,
        spin: float | None = None,
        xi: float | None = None,
        eta: float | None = None,
        chi: float | None = None,
        angle: float | None = None,
        semi_axis_rolling: float | None = None,
        semi_axis_lateral: float | None = None,
        theory: str = "exact",
        **options: Any,
    ) -> None:
        """normal_force: N (N). friction: mu. Creepage either in SI units, longitudinal and
        lateral (relative velocity over rolling velocity) and spin (rad/m), or dimensionless, xi,
        eta, chi; what is left out is zero. angle: from the upper body's rolling section to the
        lower's (degrees). Both semi-axes (m) replace the bodies' radii. theory and its options
        are those of `solve`.
        """
        contact = {
            "normal_force": normal_force,
            "friction": friction,
            "angle": angle,
            "semi_axis_rolling": semi_axis_rolling,
            "semi_axis_lateral": semi_axis_lateral,
        }
        names = ("longitudinal", "lateral", "spin", "xi", "eta", "chi")
        values = (longitudinal, lateral, spin, xi, eta, chi)
        file = sections(upper, lower, contact)
        file["creepage"] = dict(zip(names, values, strict=True))
        file["solve"] = {"theory": theory, **options}
        self._read(dumps(file))

    def _read(self, text: str) -> None:
        self._text = text
        self._data = _creepage.CaseData(text)

    @classmethod
    def from_toml(cls, source: Source) -> Case:
        """From a case file: a path, or a string with line breaks as the text itself.

        Raises CaseError for what is no case, OSError for what cannot be read.
        """
        case = cls.__new__(cls)
        case._read(read(source))
        return case

    @classmethod
    def from_dict(cls, file: Mapping[str, Mapping[str, Any]]) -> Case:
        """From the sections of a case file as a mapping. Raises as from_toml."""
        case = cls.__new__(cls)
        case._read(dumps(file))
        return case

    def to_toml(self) -> str:
        """The text of its case file."""
        return self._text

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self).from_toml, (self._text,)

    def __repr__(self) -> str:
        contact, creepage = self.contact, self.creepage
        return (
            f"<creepage.Case N = {contact.normal_force:.4g} N, a = "
            f"{contact.semi_axis_rolling:.4g} m, b = {contact.semi_axis_lateral:.4g} m, {creepage}>"
        )

    @property
    def contact(self) -> Hertz:
        """The contact ellipse and its pressure."""
        return Hertz.from_report(json.loads(self._data.hertz()))

    @property
    def friction(self) -> float:
        """Coefficient of friction mu."""
        return self._data.friction

    @property
    def creepage(self) -> SiCreepage:
        """Creepage and spin in SI units."""
        return SiCreepage(*self._data.creepage)

    @property
    def dimensionless(self) -> tuple[float, float, float]:
        """(xi, eta, chi)."""
        return self._data.dimensionless

    @property
    def theory_name(self) -> str:
        """The theory that the case asks for; "exact" by default."""
        return str(self._data.options().get("theory", "exact"))

    def theory(self, name: str | None = None, **options: Any) -> _creepage.Theory:
        """A theory prepared for this contact: by default the case's own with its options.

        Options of the case that another theory does not have are left out. Raises UnknownTheory,
        TypeError for an option in the call that the theory does not have, and what its class
        raises.
        """
        given = self._data.options()
        own = str(given.pop("theory", "exact"))
        if name is not None and find(name) is not find(own):
            given = options_of(name, given)
        make = find(name or own)
        theory: _creepage.Theory = make(
            a_over_b=self._data.a_over_b, poisson=self._data.poisson, **{**given, **options}
        )
        return theory

    def solve(self, theory: str | None = None, **options: Any) -> Solution:
        """Solves the case by its own theory, or by the one of that name. Raises as theory."""
        prepared = self.theory(theory, **options)
        solved = self._data.solve(prepared)
        return Solution.from_report(json.loads(solved.json()), prepared, solved)

    def curve(
        self,
        vary: Component = "longitudinal",
        values: ArrayLike | None = None,
        theories: Sequence[str] = (),
    ) -> Curve:
        """Creep-force curves: one component of the creepage varies, the others are the case's.

        values: of that component in SI units; by default 101 from zero to four times that at
        which the linear theory reaches mu N. theories: by name; by default the case's own.
        """
        k = COMPONENTS.index(vary)
        names = tuple(theories) or (self.theory_name,)
        length, unit, newtons, _ = self._data.units
        units = np.array([unit, unit, unit / length])
        chosen = self._range(k) * units[k] if values is None else np.asarray(values, np.float64)
        creepage: list[Any] = list(self.dimensionless)
        creepage[k] = chosen / units[k]
        forces = {}
        for name in names:
            force = self.theory(name).force(*creepage)
            forces[name] = np.stack(
                [force.fx * newtons, force.fy * newtons, force.mz * newtons * length]
            )
        return Curve(vary, chosen, forces, self)

    def _range(self, component: int) -> Floats:
        """The usual values of a component, dimensionless."""
        linear = _creepage.Linear(self._data.a_over_b, self._data.poisson)
        gain = abs(linear.derivative()[component if component < 2 else 1, component])
        own = self.dimensionless[component]
        end = max(4.0 / float(gain), 1.25 * abs(own))
        return np.linspace(0.0, end if own >= 0.0 else -end, 101)


@dataclass(frozen=True, slots=True, eq=False)
class Solution:
    """One case solved by one theory, in SI units."""

    theory: _creepage.Theory
    """The theory, prepared for this contact; ask it for more."""
    status: Status
    force: SiForce
    """On the lower body; the upper body feels the reverse."""
    dimensionless: ScalarForce
    """The same in units of mu N and mu N c."""
    creepage: SiCreepage
    contact: Hertz
    friction: float
    adhesion_share: float
    """Adhesion area over contact area, 0 to 1."""
    adhesion_area: float
    """m^2."""
    slip_area: float
    """m^2."""
    heat_per_metre: float
    """Energy turned to heat per metre rolled (J/m)."""
    details: dict[str, float]
    """What only this theory says, such as error bars, by name."""
    _report: dict[str, Any]
    _solved: _creepage.SolvedCase

    @classmethod
    def from_report(
        cls, report: dict[str, Any], theory: _creepage.Theory, solved: _creepage.SolvedCase
    ) -> Solution:
        """From what `report.json` holds."""
        status = Status[report["status"].upper()]
        force, creepage = report["lower_body"], report["creepage"]
        own, areas = report["dimensionless"], report["areas"]
        names = ("longitudinal_n", "lateral_n", "moment_n_m")
        return cls(
            theory=theory,
            status=status,
            force=SiForce(*(force[name] for name in names)),
            dimensionless=Force(own["fx"], own["fy"], own["mz"], status),
            creepage=SiCreepage(
                creepage["longitudinal"], creepage["lateral"], creepage["spin_rad_per_m"]
            ),
            contact=Hertz.from_report(report["contact"]),
            friction=report["friction"],
            adhesion_share=areas["adhesion_share"],
            adhesion_area=areas["adhesion_m2"],
            slip_area=areas["slip_m2"],
            heat_per_metre=report["frictional_power_per_metre_j_per_m"],
            details={name: detail["value"] for name, detail in report["details"].items()},
            _report=report,
            _solved=solved,
        )

    @property
    def length(self) -> float:
        """The unit of length, c = sqrt(a b) (m)."""
        contact = self.contact
        return float(np.sqrt(contact.semi_axis_rolling * contact.semi_axis_lateral))

    def to_dict(self) -> dict[str, Any]:
        """What `report.json` holds; the names carry their units."""
        report: dict[str, Any] = json.loads(json.dumps(self._report))
        return report

    def field(self, points: int = 50) -> Field:
        """Traction and slip at points x points cells, dimensionless."""
        creepage = self._report["creepage"]
        return self.theory.field(creepage["xi"], creepage["eta"], creepage["chi"], points=points)

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
        """Writes report.json, points.csv, contact.svg and contact.png into the directory.

        It is made when missing; files of those names are replaced, all of them or none. Gives
        their paths. Raises OSError.
        """
        return [Path(path) for path in self._solved.write(Path(directory))]

    def plot(self, ax: Axes | None = None) -> Axes:
        """Areas of adhesion and slip and the traction, in millimetres. Needs matplotlib."""
        from ._plot import plot_solution

        return plot_solution(self, ax)


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
