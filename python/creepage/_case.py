"""Cases in SI units: two bodies, what presses them together, how they creep."""

from __future__ import annotations

import json
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, get_args, overload

import numpy as np
from numpy.typing import ArrayLike

from . import _creepage
from ._bulk import CaseForce, case_force
from ._contact import Body, Hertz, columns, floats, number, sections
from ._errors import AccuracyWarning, InvalidValue, UnitsWarning, UnlikeBodiesWarning
from ._fit import COLUMNS, FrictionFit, fit
from ._results import Codes, Comparable, Floats, Status
from ._solution import SiCreepage, Solution
from ._theories import chosen, prepared
from ._toml import Source, dumps, read

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Component = Literal["longitudinal", "lateral", "spin"]
COMPONENTS: tuple[Component, ...] = get_args(Component)
QUANTITIES = (
    "longitudinal",
    "lateral",
    "spin",
    "normal_force",
    "friction",
    "upper_radius_rolling",
    "upper_radius_lateral",
    "lower_radius_rolling",
    "lower_radius_lateral",
    "semi_axis_rolling",
    "semi_axis_lateral",
    "speed",
)
"""What may differ from row to row."""


class Case:
    """One rolling contact in SI units.

    x is the rolling direction, y points to its right, z into the lower body. Raises CaseError for
    numbers out of range, for contradictions, and for bodies without a contact ellipse along the
    rolling direction. It names the section and the key of the case file.
    """

    def __init__(
        self,
        *,
        upper: Body,
        lower: Body,
        normal_force: float,
        friction: float | Mapping[str, Any],
        longitudinal: float | None = None,
        lateral: float | None = None,
        spin: float | None = None,
        xi: float | None = None,
        eta: float | None = None,
        chi: float | None = None,
        speed: float | None = None,
        longitudinal_force: float | None = None,
        lateral_force: float | None = None,
        moment: float | None = None,
        fx: float | None = None,
        fy: float | None = None,
        mz: float | None = None,
        angle: float | None = None,
        semi_axis_rolling: float | None = None,
        semi_axis_lateral: float | None = None,
        layer: Mapping[str, float] | None = None,
        damage: Mapping[str, Any] | None = None,
        heat: Mapping[str, Any] | None = None,
        slip: Mapping[str, ArrayLike] | None = None,
        theory: str = "exact",
        **options: Any,
    ) -> None:
        """normal_force: N (N). friction: mu, or a law of it by the speed of slip or across the
        contact as a case file has it. Creepage is either in SI units, longitudinal and lateral
        (relative velocity over rolling velocity) and spin (rad/m), or dimensionless, xi, eta, chi.
        What is left out is zero. speed: rolling velocity (m/s), for the frictional power. Forces on
        the lower body (N, N m), or dimensionless ones, may be wanted in place of creepages, which
        are then found. Exactly three quantities are given, zeros too. angle: from the upper body's
        rolling section to the lower's (degrees). Both semi-axes (m) replace the bodies' radii.
        layer: `thickness` (m), `shear_modulus` (Pa) and the other keys of `[layer]` in a case file.
        damage: `{}`, or constants as in `[damage]`, for `Solution.damage`. heat: `upper` and
        `lower`, each `{"material": "steel"}` or its numbers as in `[heat]`, for `Solution.heat`;
        needs speed. slip: rigid slip beside creepage and spin, by the points of a rectangular grid,
        as lists `x`, `y` (m), `longitudinal`, `lateral` (over the rolling velocity); by exact alone.
        theory and its options are those of `solve`.
        """
        numbers = {
            "normal_force": normal_force, "friction": friction, "longitudinal": longitudinal,
            "lateral": lateral, "spin": spin, "xi": xi, "eta": eta, "chi": chi, "speed": speed,
            "longitudinal_force": longitudinal_force, "lateral_force": lateral_force,
            "moment": moment, "fx": fx, "fy": fy, "mz": mz, "angle": angle,
            "semi_axis_rolling": semi_axis_rolling, "semi_axis_lateral": semi_axis_lateral,
        }  # fmt: skip
        for name, value in numbers.items():
            if value is not None and not (name == "friction" and isinstance(value, Mapping)):
                number(name, value)
        contact: dict[str, Any] = {
            "normal_force": normal_force,
            "friction": friction,
            "angle": angle,
            "semi_axis_rolling": semi_axis_rolling,
            "semi_axis_lateral": semi_axis_lateral,
        }
        creepage = {
            "longitudinal": longitudinal,
            "lateral": lateral,
            "spin": spin,
            "xi": xi,
            "eta": eta,
            "chi": chi,
            "speed": speed,
        }
        forces = {
            "longitudinal_force": longitudinal_force,
            "lateral_force": lateral_force,
            "moment": moment,
            "fx": fx,
            "fy": fy,
            "mz": mz,
        }
        if slip is not None:
            contact["slip"] = columns(slip)
        file = sections(upper, lower, contact)
        moves = (name for name in (*creepage, *forces) if name != "speed")
        if all(numbers[name] is None for name in moves):
            creepage["longitudinal"] = 0.0  # free rolling
        file["creepage"] = creepage
        file["wanted"] = forces
        file |= {
            name: dict(section)
            for name, section in (("layer", layer), ("damage", damage), ("heat", heat))
            if section is not None
        }
        file["solve"] = {"theory": theory, **options}
        self._read(dumps(file))

    def _read(self, text: str) -> None:
        self._data = _creepage.CaseData(text)

    @classmethod
    def from_toml(cls, source: Source) -> Case:
        """From a case file: a path, or a string with line breaks as the text itself. A file of slips
        that it names stands in the working directory.

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
        return self._data.text

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self).from_toml, (self.to_toml(),)

    def __eq__(self, other: object) -> bool:
        """The same contact, creepage or wanted forces, and theory."""
        if not isinstance(other, Case):
            return NotImplemented
        return self._data == other._data

    def __hash__(self) -> int:
        return hash(self._data)

    def __repr__(self) -> str:
        contact = self.contact
        creepage = "forces wanted" if self._data.finds_creepage else str(self.creepage)
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
        """Creepage and spin in SI units. Raises CaseError where forces are wanted."""
        return SiCreepage(*self._data.creepage)

    @property
    def dimensionless(self) -> tuple[float, float, float]:
        """(xi, eta, chi). Raises CaseError where forces are wanted."""
        return self._data.dimensionless

    @property
    def theory_name(self) -> str:
        """The theory that the case asks for; "exact" by default."""
        return chosen(self._data, None, {})[0]

    def theory(self, name: str | None = None, **options: Any) -> _creepage.Theory:
        """A theory prepared for this contact: by default the case's own with its options.

        Another theory than the case's has its usual options. "exact" with resolution="auto" is an
        Automatic, for accuracy=0.001 unless another is given. Raises UnknownTheory, TypeError for
        an option that the theory does not have, and what its class raises. Warns with
        UnlikeBodiesWarning where the theory neglects how unlike the bodies are, and that matters.
        """
        return prepared(self._data, *self._chosen(name, options))

    def _chosen(self, name: str | None, options: Mapping[str, Any]) -> tuple[str, dict[str, Any]]:
        """The theory and its options; warns the caller's caller of what it neglects."""
        name, together = chosen(self._data, name, options)
        for words, kind in (
            (self._data.neglects(name), UnlikeBodiesWarning),
            (self._data.units_in_doubt, UnitsWarning),
        ):
            if words is not None:
                warnings.warn(words, kind, stacklevel=3)
        return name, together

    @overload
    def force(
        self,
        *,
        longitudinal: float | None = None,
        lateral: float | None = None,
        spin: float | None = None,
        normal_force: float | None = None,
        friction: float | None = None,
        upper_radius_rolling: float | None = None,
        upper_radius_lateral: float | None = None,
        lower_radius_rolling: float | None = None,
        lower_radius_lateral: float | None = None,
        semi_axis_rolling: float | None = None,
        semi_axis_lateral: float | None = None,
        speed: float | None = None,
        theory: str | _creepage.Table | None = None,
        **options: Any,
    ) -> CaseForce[float, Status]: ...
    @overload
    def force(
        self,
        *,
        longitudinal: ArrayLike | None = None,
        lateral: ArrayLike | None = None,
        spin: ArrayLike | None = None,
        normal_force: ArrayLike | None = None,
        friction: ArrayLike | None = None,
        upper_radius_rolling: ArrayLike | None = None,
        upper_radius_lateral: ArrayLike | None = None,
        lower_radius_rolling: ArrayLike | None = None,
        lower_radius_lateral: ArrayLike | None = None,
        semi_axis_rolling: ArrayLike | None = None,
        semi_axis_lateral: ArrayLike | None = None,
        speed: ArrayLike | None = None,
        theory: str | _creepage.Table | None = None,
        **options: Any,
    ) -> CaseForce[Floats, Codes]: ...
    def force(
        self,
        *,
        theory: str | _creepage.Table | None = None,
        **given: Any,
    ) -> CaseForce[Any, Any]:
        """Forces in SI units where some quantities differ from the case's: floats or arrays, which
        broadcast, such as a measured history.

        longitudinal, lateral: creepages. spin (rad/m). normal_force (N). friction. Radii and
        semi-axes are in m. A radius is infinite where flat; semi-axes replace the case's radii.
        speed (m/s), for the frictional power. theory: by name, or a Table; the case's own if not
        given, with its options. An element that is no case, such as one with NaN, has NaN and the
        status INVALID; `messages` says why. The numbers are those of `creepage batch --case` to the
        last bit.

        xarray's DataArrays broadcast by the names of their dimensions. Raises as solve; ValueError for
        shapes that do not broadcast, TypeError for what is no number.
        """
        quantities = {name: given.pop(name) for name in QUANTITIES if name in given}
        quantities = {name: value for name, value in quantities.items() if value is not None}
        table = theory if isinstance(theory, _creepage.Table) else None
        name, options = self._chosen(None if isinstance(theory, _creepage.Table) else theory, given)
        return case_force(self._data, name, options, table, quantities)

    def fit(
        self, *, theory: str | None = None, slope: bool = False, **given: Any
    ) -> FrictionFit:
        """The coefficient of friction whose forces are nearest to measured ones (least squares).

        Arguments are arrays of one shape, or that broadcast. At least one of longitudinal, lateral
        (creepages) and spin (rad/m) is needed. So is at least one force: longitudinal_force,
        lateral_force (N, of the upper body on the lower), or longitudinal_coefficient,
        lateral_coefficient (force over normal force). normal_force (N) is given where it differs
        from the case's. uncertainty is one standard deviation of the forces in their unit. slope:
        find a factor of the initial slope too. Further keywords are the theory's options; the
        case's own theory and friction are where the search begins.

        Points that do not belong to the others are left out, and AccuracyWarning names them; so it does
        elements without a finite number. Raises ValueError for too few points and for points that say
        nothing of friction, TypeError for other values than numbers and for masked elements, CaseError
        where the case wants forces, and as theory.
        """
        columns = {name: given.pop(name) for name in COLUMNS if name in given}
        columns = {name: value for name, value in columns.items() if value is not None}
        if not columns:
            raise ValueError("a creepage is needed: longitudinal, lateral or spin")
        name, options = self._chosen(theory, given)
        found = fit(self._data, name, options, columns, slope)
        if found.cautions:
            warnings.warn("; ".join(found.cautions), AccuracyWarning, stacklevel=2)
        return found

    def solve(self, theory: str | None = None, **options: Any) -> Solution:
        """Solves the case by its own theory, or by the one of that name.

        Where forces are wanted, the creepage is found first. Raises as theory; NotReachable where
        no creepage gives the wanted forces, CaseError by a theory that does not find creepages.
        """
        return Solution(self._data, *self._chosen(theory, options))

    def curve(
        self,
        vary: Component = "longitudinal",
        values: ArrayLike | None = None,
        theories: Sequence[str] = (),
    ) -> Curve:
        """Creep-force curves: one component of the creepage varies, the others are the case's.

        values: of that component in SI units. By default there are 101, from zero to four times
        that at which the linear theory reaches mu N. theories: by name; by default the case's own.
        Raises InvalidValue where a value is not finite, CaseError where forces are wanted, and as
        theory.
        """
        if vary not in COMPONENTS:
            raise ValueError(f"vary = {vary!r} is not valid: it must be one of {COMPONENTS}")
        k = COMPONENTS.index(vary)
        names = tuple(theories) or (self.theory_name,)
        length, unit, newtons, _ = self._data.units
        units = np.array([unit, unit, unit / length])
        chosen = self._range(k) * units[k] if values is None else floats("values", values)
        if chosen.ndim != 1:
            raise ValueError(f"values must be a list of numbers, not of shape {chosen.shape}")
        creepage: list[Any] = list(self.dimensionless)
        creepage[k] = chosen / units[k]
        forces = {}
        for name in names:
            known, options = self._chosen(name, {})
            force: Any
            if options.get("coupled"):
                force = self._coupled_force(known, options, vary, chosen)
            else:
                force = prepared(self._data, known, options).force(*creepage)
            forces[name] = np.stack(
                [force.fx * newtons, force.fy * newtons, force.mz * newtons * length]
            )
        return Curve(vary, chosen, forces, self)

    def _coupled_force(
        self, name: str, options: dict[str, Any], vary: Component, values: Floats
    ) -> CaseForce[Any, Any]:
        """Forces of coupled bodies, which depend on friction by itself. Raises InvalidValue where a value is not finite."""
        if not np.isfinite(values).all():
            worst = float(values[~np.isfinite(values)][0])
            raise InvalidValue(f"{vary} = {worst} must be finite", vary, worst, "finite")
        return case_force(self._data, name, options, None, {vary: values})

    def _range(self, component: int) -> Floats:
        """The usual values of a component, dimensionless."""
        linear = _creepage.Linear(self._data.a_over_b, self._data.poisson)
        gain = abs(linear.derivative()[component if component < 2 else 1, component])
        own = self.dimensionless[component]
        end = max(4.0 / float(gain), 1.25 * abs(own))
        return np.linspace(0.0, end if own >= 0.0 else -end, 101)


@dataclass(frozen=True, slots=True, eq=False)
class Curve(Comparable):
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
        """The force that the component makes, a line a theory; the case itself is marked. Needs
        matplotlib."""
        from ._plot import plot_lines

        row, force = (0, "longitudinal") if self.vary == "longitudinal" else (1, "lateral")
        creepage = "spin (rad/m)" if self.vary == "spin" else f"{self.vary} creepage"
        return plot_lines(
            self.values,
            {name: forces[row] for name, forces in self.forces.items()},
            getattr(self.case.creepage, self.vary),
            self.case.friction * self.case.contact.normal_force,
            (creepage, f"{force} force on the lower body (kN)"),
            ax,
        )
