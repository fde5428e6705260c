"""Parts of reports: dictionaries as report.json has them, whose numbers are attributes too."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from ._solution import SiCreepage, SiForce


class Estimate(NamedTuple):
    """A number and its error bar, in the same unit."""

    value: float
    error: float | None
    """Zero for what was given, None where nothing is known."""


class RailForce(NamedTuple):
    """Force and moment on a rail, in track axes: x forward, y right, z down."""

    longitudinal: float
    """N."""
    lateral: float
    """N."""
    vertical: float
    """N."""
    moment_x: float
    """About the origin of the rail's profile (N m)."""
    moment_y: float
    """N m."""
    moment_z: float
    """N m."""


_FORCES = ("longitudinal_n", "lateral_n", "vertical_n")
_MOMENTS = ("moment_x_n_m", "moment_y_n_m", "moment_z_n_m")


class _Part(dict[str, Any]):
    """A part of a report."""

    def _number(self, key: str) -> float:
        value = self[key]
        return math.nan if value is None else float(value)

    def _estimate(self, name: str, unit: str) -> Estimate:
        return Estimate(self[f"{name}_{unit}"], self[f"{name}_error_{unit}"])


class _Pressed(_Part):
    """What presses."""

    @property
    def normal_force(self) -> Estimate:
        """N."""
        return self._estimate("normal_force", "n")

    @property
    def approach(self) -> Estimate:
        """Of the bodies (m)."""
        return self._estimate("approach", "m")

    @property
    def peak_pressure(self) -> Estimate:
        """Pa."""
        return self._estimate("peak_pressure", "pa")

    @property
    def area(self) -> Estimate:
        """m^2."""
        return self._estimate("area", "m2")


class AreaContact(_Pressed):
    """Bodies of any shape pressed together: `contact` of report.json."""

    @property
    def stiffness(self) -> float:
        """Contact stiffness dN/d(approach) (N/m)."""
        return self._number("stiffness_n_per_m")

    @property
    def shear_modulus(self) -> float:
        """Combined G (Pa)."""
        return float(self["solid"]["shear_modulus_pa"])

    @property
    def poisson(self) -> float:
        """Combined Poisson's ratio."""
        return float(self["solid"]["poisson"])

    @property
    def kappa(self) -> float:
        """Measure of how unlike the bodies are."""
        return float(self["solid"]["kappa"])


class WheelContact(_Pressed):
    """A place of contact of a wheel: one of `patches` of report.json.

    Its axes: x forward, s across along (cos angle, sin angle) in the track's (y, z), the normal into the rail.
    """

    @property
    def y_rail(self) -> float:
        """In the rail's profile (m)."""
        return self._number("y_rail_m")

    @property
    def y_wheel(self) -> float:
        """On the wheel (m)."""
        return self._number("y_wheel_m")

    @property
    def reference(self) -> tuple[float, float, float]:
        """Its reference point in track axes (m)."""
        return (self["x_m"], self["y_m"], self["z_m"])

    @property
    def contact_angle(self) -> float:
        """From the track's z to the normal into the rail, about x (rad)."""
        return self._number("contact_angle_rad")

    @property
    def contact_slope(self) -> float | None:
        """By which the contact falls ahead (rad); None of profiles that do not vary along rolling."""
        slope: float | None = self.get("contact_slope_rad")
        return slope

    @property
    def creepage(self) -> SiCreepage:
        """Of the wheel relative to the rail."""
        return SiCreepage(
            self["longitudinal_creepage"], self["lateral_creepage"], self["spin_rad_per_m"]
        )

    @property
    def force(self) -> SiForce:
        """On the rail in the plane of contact; the moment about the normal."""
        return SiForce(self["longitudinal_n"], self["lateral_n"], self["moment_n_m"])

    @property
    def force_error(self) -> SiForce | None:
        """Error bars of the force; None by a theory without."""
        keys = ("longitudinal_error_n", "lateral_error_n", "moment_error_n_m")
        errors = [self[key] for key in keys]
        return None if None in errors else SiForce(*errors)

    @property
    def adhesion_share(self) -> float:
        """Adhesion area over contact area, 0 to 1."""
        return self._number("adhesion_share")

    @property
    def heat_per_metre(self) -> float:
        """Energy turned to heat per metre rolled (J/m)."""
        return self._number("frictional_power_per_metre_j_per_m")


class Wheel(_Part):
    """One wheel on its rail: `left` or `right` of report.json."""

    def __init__(self, wheel: dict[str, Any]) -> None:
        super().__init__(wheel)
        self["patches"] = [WheelContact(patch) for patch in wheel["patches"]]

    @property
    def force(self) -> RailForce:
        """On the rail, with that on the guard rail beside it."""
        return RailForce(*(self["force"][key] for key in _FORCES + _MOMENTS))

    @property
    def force_error(self) -> tuple[float, float, float] | None:
        """Error bars of the force along x, y, z (N); None by a theory without."""
        x, y, z = (self["force"][key.replace("_n", "_error_n")] for key in _FORCES)
        return None if None in (x, y, z) else (x, y, z)

    @property
    def patches(self) -> list[WheelContact]:
        """Its places of contact, by falling load."""
        patches: list[WheelContact] = self["patches"]
        return patches

    @property
    def z(self) -> float:
        """The wheelset's height for this wheel (m)."""
        return self._number("z_m")

    @property
    def pitch_rate(self) -> float:
        """Its angular velocity about the axle (rad/s)."""
        return self._number("pitch_rate_rad_per_s")

    @property
    def clearance(self) -> float | None:
        """How far it would have to go down to touch (m), where it touches nothing."""
        clearance: float | None = self["clearance_m"]
        return clearance

    @property
    def guard_force(self) -> RailForce | None:
        """The part of the force that is on the guard rail; None without one."""
        guard = self.get("guard")
        return None if guard is None else RailForce(*(guard["force"][key] for key in _FORCES + _MOMENTS))

    @property
    def guard_clearance(self) -> float | None:
        """Distance of the flange's back from the guard rail (m), where it is free of it."""
        guard = self.get("guard")
        return None if guard is None else guard["clearance_m"]
