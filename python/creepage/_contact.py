"""Two bodies and their contact, in SI units."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any, Literal, TypeAlias

from . import _creepage
from ._toml import dumps

Radius: TypeAlias = float | Literal["flat"]


@dataclass(frozen=True, slots=True)
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


def sections(upper: Body, lower: Body, contact: Mapping[str, Any]) -> dict[str, dict[str, Any]]:
    """The sections of a case file that describe the contact."""
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
    contradictions, and bodies without a contact ellipse.
    """
    contact = {
        "normal_force": normal_force,
        "angle": angle,
        "semi_axis_rolling": semi_axis_rolling,
        "semi_axis_lateral": semi_axis_lateral,
    }
    text = dumps(sections(upper, lower, contact))
    return Hertz.from_report(json.loads(_creepage.hertz(text)))
