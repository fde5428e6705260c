"""Two cylinders: Hertz's line contact, and Carter's theory of its rolling."""

from __future__ import annotations

import math
import warnings
from dataclasses import asdict, dataclass
from typing import Any, Generic, overload

from numpy.typing import ArrayLike

from . import _creepage
from ._contact import Body, instance
from ._errors import CaseError, UnitsWarning, UnlikeBodiesWarning
from ._results import Comparable, Floats, Number, by_name

UNLIKE = 0.01
"""kappa/mu from which on leaving it out matters."""


@dataclass(frozen=True, slots=True, eq=False)
class CarterSolution(Comparable, Generic[Number]):
    """Carter's theory of two cylinders; lengths in units of the half-width, leading edge at 1."""

    creepage: Number
    """Dimensionless, upsilon_x rho / (mu a)."""
    force: Number
    """Per length of the cylinders, in units of mu N."""
    derivative: Number
    """Of the force by the creepage."""
    adhesion_half_width: Number
    """1 in free rolling, 0 in gross sliding."""
    trailing_edge: Number
    """Of the adhesion area: -1 in free rolling, 1 in gross sliding."""

    def field(self, x: Any) -> tuple[Any, Any, Any]:
        """Traction, slip and Region numbers at x, which broadcasts against the creepage.

        Traction is in units of mu times the peak pressure, slip in units of mu a V / rho.
        Raises InvalidValue where x is not finite.
        """
        return _creepage.carter_field(self.creepage, x)

    def to_dict(self) -> dict[str, Any]:
        """The numbers by name."""
        return by_name(self)


@overload
def carter(creepage: float) -> CarterSolution[float]: ...
@overload
def carter(creepage: ArrayLike) -> CarterSolution[Floats]: ...
def carter(creepage: Any) -> CarterSolution[Any]:
    """Carter's theory (1926) of two cylinders with parallel axes.

    creepage: dimensionless, upsilon_x rho / (mu a) with a the half-width of the contact; gross
    sliding sets in at 4. A float or an array. Raises InvalidValue where it is not finite.
    """
    return CarterSolution(*_creepage.carter(creepage))


@dataclass(frozen=True, slots=True)
class LineContact:
    """Two cylinders with parallel axes pressed together: Hertz's line contact."""

    half_width: float
    """a (m)."""
    peak_pressure: float
    """Pa."""
    rho: float
    """Characteristic length of (1.2) (m): the diameter, for equal cylinders."""
    load: float
    """N per m of the cylinders' length."""
    kappa: float
    """Measure of how unlike the bodies are, (1.41)."""

    def to_dict(self) -> dict[str, float]:
        """The numbers by name, in SI units."""
        return asdict(self)

    def carter(self, creepage: Any, friction: float) -> CarterSolution[Any]:
        """Carter's theory at the longitudinal creepage upsilon_x, a float or an array.

        The force is in units of `friction * load`. Raises ValueError unless friction is positive,
        InvalidValue where the creepage is not finite; warns with UnlikeBodiesWarning of bodies so
        unlike that it matters, which this theory leaves out.
        """
        if not (friction > 0.0 and math.isfinite(friction)):
            raise ValueError(f"friction = {friction} is not valid: it must be finite and positive")
        kappa_over_mu = self.kappa / friction
        if abs(kappa_over_mu) >= UNLIKE:
            warnings.warn(
                f"Carter's theory takes the bodies for like ones (kappa/mu = {kappa_over_mu:.3f}): for "
                f"that the force may be off by some {100 * min(abs(kappa_over_mu), 1.0):.0f} % of mu N",
                UnlikeBodiesWarning,
                stacklevel=2,
            )
        return carter(creepage * (self.rho / (friction * self.half_width)))


def line_contact(upper: Body, lower: Body, load: float) -> LineContact:
    """Presses two cylinders together by their radius_rolling; load in N per m of their length.

    Raises InvalidValue for numbers out of range, CaseError for bodies that are crowned and do not
    touch along a line. Warns with UnitsWarning of numbers that look like ones in other units.
    """
    radii = []
    for name, body in (("upper", upper), ("lower", lower)):
        instance(name, body, Body)
        if body.radius_lateral not in (None, "flat", math.inf, -math.inf):
            message = (
                f"{name}: radius_lateral = {body.radius_lateral} is a crown, which does not touch "
                "along a line: leave it out, or ask creepage.hertz for the ellipse"
            )
            raise CaseError(message, name, "radius_lateral", float(body.radius_lateral or 0.0))
        flat = body.radius_rolling in (None, "flat")
        radii.append(math.inf if flat else float(body.radius_rolling or 0.0))
    moduli = (upper.modulus(), lower.modulus())
    half_width, peak_pressure, rho, kappa, caution = _creepage.line_contact(
        moduli, (upper.poisson, lower.poisson), (radii[0], radii[1]), load
    )
    if caution is not None:
        warnings.warn(caution, UnitsWarning, stacklevel=2)
    return LineContact(half_width, peak_pressure, rho, load, kappa)


@dataclass(frozen=True, slots=True, eq=False)
class ViscoelasticSolution(Comparable, Generic[Number]):
    """Two like viscoelastic cylinders in steady rolling, to +x; per metre of their length."""

    trailing_edge: Number
    """m, from the line of the centres; negative."""
    leading_edge: Number
    """m."""
    peak_pressure: Number
    """Pa."""
    peak_place: Number
    """m."""
    pressure_centre: Number
    """How far the centre of pressure lies ahead (m)."""
    rolling_resistance: Number
    """N/m: the energy lost per metre rolled and metre of length."""
    creepage: Number
    """At the tangential force that was asked for."""

    def to_dict(self) -> dict[str, Any]:
        """The numbers by name."""
        return by_name(self)


def viscoelastic_cylinders(
    *,
    shear_modulus: float,
    poisson: float,
    ratio: float,
    time: float,
    radius: float,
    speed: Any,
    load: Any,
    friction: float = 0.3,
    force: Any = 0.0,
) -> ViscoelasticSolution[Any]:
    """Two like cylinders whose compliance grows, with the retardation time (s), from that of the
    glassy shear_modulus (Pa) to 1 + ratio times it. Poisson's ratio is constant. radius: 1/(1/R1 +
    1/R2) (m). speed (m/s), load and tangential force (N/m) are floats or arrays, which broadcast.
    Raises InvalidValue for numbers out of range.
    """
    material = [shear_modulus, poisson, ratio, time]
    return ViscoelasticSolution(
        *_creepage.viscoelastic_cylinders(material, radius, friction, speed, load, force)
    )
