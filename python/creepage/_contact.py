"""Two bodies and their contact, in SI units."""

from __future__ import annotations

import json
import math
import warnings
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from . import _creepage
from ._errors import CaseError, UnitsWarning
from ._results import Floats
from ._toml import dumps

Radius: TypeAlias = float | Literal["flat"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Body:
    """One body: its material, and its radii of curvature at the contact."""

    poisson: float
    """Poisson's ratio, 0 to 0.5."""
    shear_modulus: float | None = None
    """G (Pa). Give this or young_modulus."""
    young_modulus: float | None = None
    """E (Pa). Give this or shear_modulus."""
    radius_rolling: Radius | None = None
    """Radius of the section along the rolling direction (m): a wheel's rolling radius. Positive
    where convex, negative where hollow; "flat", infinity or None where straight."""
    radius_lateral: Radius | None = None
    """Radius of the section across the rolling direction (m): a rail head's."""

    def __post_init__(self) -> None:
        """Checked at once. Raises CaseError."""
        for name in ("poisson", "shear_modulus", "young_modulus"):
            value = getattr(self, name)
            if value is None and name != "poisson":
                continue
            number(name, value)
            good = 0.0 <= value <= 0.5 if name == "poisson" else 0.0 < value < math.inf
            valid = "between 0 and 0.5" if name == "poisson" else "finite and greater than zero"
            if not good:
                message = f"{name} = {value} is not valid: it must be {valid}"
                raise CaseError(message, None, name, value)
        for name in ("radius_rolling", "radius_lateral"):
            value = getattr(self, name)
            if value is not None and value != "flat":
                number(name, value)

    def section(self, shaped: bool) -> dict[str, Any]:
        """Its section of a case file; `shaped` where the contact follows from the radii."""
        section = asdict(self)
        for key in ("radius_rolling", "radius_lateral"):
            if shaped and section[key] in (None, math.inf, -math.inf):
                section[key] = "flat"
        return section

    def modulus(self) -> float:
        """Its shear modulus (Pa)."""
        if self.shear_modulus is not None and self.young_modulus is None:
            return self.shear_modulus
        if self.young_modulus is not None and self.shear_modulus is None:
            return self.young_modulus / (2.0 * (1.0 + self.poisson))
        raise ValueError("give either shear_modulus or young_modulus")


def floats(name: str, values: ArrayLike) -> Floats:
    """An array of real numbers. Raises TypeError for other values and for masked elements."""
    if np.ma.is_masked(values):
        raise TypeError(f"{name} must not have masked elements: leave them out")
    array = np.asarray(values)
    if not np.can_cast(array.dtype, np.float64, "same_kind"):
        raise TypeError(f"{name} must be real numbers, not an array of {array.dtype}")
    return array.astype(np.float64)


def columns(arrays: Mapping[str, ArrayLike]) -> dict[str, list[float]]:
    """Lists of numbers, as a case file has them."""
    lists = {}
    for name, array in arrays.items():
        values = floats(name, array)
        if values.ndim != 1:
            raise ValueError(f"{name} must be a list of numbers, not of shape {values.shape}")
        lists[name] = values.tolist()
    return lists


def instance(name: str, value: object, kind: type) -> None:
    """Raises TypeError for what is of another kind."""
    if not isinstance(value, kind):
        message = f"{name} must be a creepage.{kind.__name__}, not {type(value).__name__}"
        raise TypeError(message)


def number(name: str, value: object) -> None:
    """Raises TypeError for what is no real number."""
    if np.ma.is_masked(value):
        raise TypeError(f"{name} must not be masked")
    if isinstance(value, np.ndarray) and value.ndim > 0:
        raise TypeError(
            f"{name} must be one number, not an array of shape {value.shape}: many cases at once "
            "are Case.force(...) and creepage.batch(...)"
        )
    if isinstance(value, bool) or not isinstance(value, (int, float, np.number, np.ndarray)):
        raise TypeError(f"{name} must be a number, got {value!r}")


def sections(upper: Body, lower: Body, contact: Mapping[str, Any]) -> dict[str, dict[str, Any]]:
    """The sections of a case file that describe the contact."""
    instance("upper", upper, Body)
    instance("lower", lower, Body)
    shaped = contact.get("semi_axis_rolling") is None and contact.get("semi_axis_lateral") is None
    return {
        "upper": upper.section(shaped),
        "lower": lower.section(shaped),
        "contact": dict(contact),
    }


@dataclass(frozen=True, slots=True)
class Hertz:
    """The contact ellipse of two bodies pressed together (Kalker 1967, (3.36)-(3.52))."""

    normal_force: float
    """N (N)."""
    semi_axis_rolling: float
    """Semi-axis a along the rolling direction (m)."""
    semi_axis_lateral: float
    """Semi-axis b across (m)."""
    a_over_b: float
    peak_pressure: float
    """Pa."""
    approach: float
    """Approach of the bodies (m)."""
    stiffness: float
    """Contact stiffness dN/d(approach) (N/m)."""
    approach_constant: float
    """Approach over the load to the power 2/3, the same for every load (m/N^(2/3))."""
    rho: float
    """Curvature length (m)."""
    angle: float
    """From the upper body's rolling direction to the axis a (rad)."""
    relative_curvature_rolling: float
    """A, along the axis a (1/m)."""
    relative_curvature_lateral: float
    """B, along the axis b (1/m)."""
    shear_modulus: float
    """Combined G (Pa)."""
    poisson: float
    """Combined Poisson's ratio."""
    kappa: float
    """Measure of how unlike the bodies are."""

    @classmethod
    def from_report(cls, report: Mapping[str, Any]) -> Hertz:
        """From the part `contact` of a report."""
        return cls(
            normal_force=report["normal_force_n"],
            semi_axis_rolling=report["semi_axis_rolling_m"],
            semi_axis_lateral=report["semi_axis_lateral_m"],
            a_over_b=report["a_over_b"],
            peak_pressure=report["peak_pressure_pa"],
            approach=report["approach_m"],
            stiffness=report["stiffness_n_per_m"],
            approach_constant=report["approach_constant_m_per_n_2_3"],
            rho=report["rho_m"],
            angle=report["angle_rad"],
            relative_curvature_rolling=report["relative_curvature_rolling_per_m"],
            relative_curvature_lateral=report["relative_curvature_lateral_per_m"],
            shear_modulus=report["solid"]["shear_modulus_pa"],
            poisson=report["solid"]["poisson"],
            kappa=report["solid"]["kappa"],
        )

    def to_dict(self) -> dict[str, float]:
        """The numbers by name, in SI units."""
        return asdict(self)


def hertz(
    upper: Body,
    lower: Body,
    normal_force: float,
    *,
    angle: float | None = None,
    semi_axis_rolling: float | None = None,
    semi_axis_lateral: float | None = None,
) -> Hertz:
    """The contact of two bodies.

    normal_force: N (N). angle: from the upper body's rolling section to the lower's (degrees).
    Both semi-axes (m) replace the bodies' radii. Raises CaseError for numbers out of range,
    contradictions, and bodies without a contact ellipse; warns with UnitsWarning of numbers that look
    like ones in other units.
    """
    contact = {
        "normal_force": normal_force,
        "angle": angle,
        "semi_axis_rolling": semi_axis_rolling,
        "semi_axis_lateral": semi_axis_lateral,
    }
    text = dumps(sections(upper, lower, contact))
    report = json.loads(_creepage.hertz(text))
    if report["caution"] is not None:
        warnings.warn(report["caution"], UnitsWarning, stacklevel=2)
    return Hertz.from_report(report)
