"""Every number of a report has an attribute in Python: the tables here name it. A new quantity without one fails."""

from __future__ import annotations

import math
import pickle
import re
from collections.abc import Callable, Mapping
from typing import Any

import creepage
import pytest
from conftest import ROOT
from creepage import Gap, GapCase, GapSolution, Quantity, Solution, StaticsSolution, Wheelset, WheelsetSolution

Attribute = Callable[[Any], float | None]

# Of an ellipse and of areas of any shape alike.
ROLLING: dict[str, Attribute] = {
    "friction": lambda one: one.friction,
    "creepage.longitudinal": lambda one: one.creepage.longitudinal,
    "creepage.lateral": lambda one: one.creepage.lateral,
    "creepage.spin_rad_per_m": lambda one: one.creepage.spin,
    "creepage.xi": lambda one: one.dimensionless_creepage.xi,
    "creepage.eta": lambda one: one.dimensionless_creepage.eta,
    "creepage.chi": lambda one: one.dimensionless_creepage.chi,
    "lower_body.longitudinal_n": lambda one: one.force.longitudinal,
    "lower_body.lateral_n": lambda one: one.force.lateral,
    "lower_body.moment_n_m": lambda one: one.force.moment,
    # The upper body feels the reverse.
    "upper_body.longitudinal_n": lambda one: -one.force.longitudinal,
    "upper_body.lateral_n": lambda one: -one.force.lateral,
    "upper_body.moment_n_m": lambda one: -one.force.moment,
    "areas.adhesion_share": lambda one: one.adhesion_share,
    "areas.adhesion_m2": lambda one: one.adhesion_area,
    "areas.slip_m2": lambda one: one.slip_area,
    "frictional_power_per_metre_j_per_m": lambda one: one.heat_per_metre,
    "frictional_power_per_metre_by_slip_j_per_m": lambda one: one.heat_per_metre_by_slip,
    "rolling_velocity_m_per_s": lambda one: one.speed,
    "frictional_power_w": lambda one: one.power,
    "contact.stiffness_n_per_m": lambda one: one.contact.stiffness,
    "contact.solid.shear_modulus_pa": lambda one: one.contact.shear_modulus,
    "contact.solid.poisson": lambda one: one.contact.poisson,
    "contact.solid.kappa": lambda one: one.contact.kappa,
}
ELLIPSE: dict[str, Attribute] = ROLLING | {
    "contact.normal_force_n": lambda one: one.contact.normal_force,
    "contact.semi_axis_rolling_m": lambda one: one.contact.semi_axis_rolling,
    "contact.semi_axis_lateral_m": lambda one: one.contact.semi_axis_lateral,
    "contact.a_over_b": lambda one: one.contact.a_over_b,
    "contact.peak_pressure_pa": lambda one: one.contact.peak_pressure,
    "contact.approach_m": lambda one: one.contact.approach,
    "contact.area_m2": lambda one: one.adhesion_area + one.slip_area,
    "contact.approach_constant_m_per_n_2_3": lambda one: one.contact.approach_constant,
    "contact.rho_m": lambda one: one.contact.rho,
    "contact.angle_rad": lambda one: one.contact.angle,
    "contact.relative_curvature_rolling_per_m": lambda one: one.contact.relative_curvature_rolling,
    "contact.relative_curvature_lateral_per_m": lambda one: one.contact.relative_curvature_lateral,
    "dimensionless.fx": lambda one: one.dimensionless.fx,
    "dimensionless.fy": lambda one: one.dimensionless.fy,
    "dimensionless.mz": lambda one: one.dimensionless.mz,
    "dimensionless.friction_used": lambda one: one.dimensionless.magnitude,
}
AREAS: dict[str, Attribute] = ROLLING | {
    "contact.normal_force_n": lambda one: one.contact.normal_force.value,
    "contact.approach_m": lambda one: one.contact.approach.value,
    "contact.peak_pressure_pa": lambda one: one.contact.peak_pressure.value,
    "contact.area_m2": lambda one: one.contact.area.value,
    "dimensionless.fx": lambda one: one.dimensionless[0],
    "dimensionless.fy": lambda one: one.dimensionless[1],
    "dimensionless.mz": lambda one: one.dimensionless[2],
    "dimensionless.friction_used": lambda one: one.friction_used,
    "friction_used": lambda one: one.friction_used,
}
WHEELSET: dict[str, Attribute] = {
    "y_m": lambda one: one.y,
    "z_m": lambda one: one.z,
    "roll_rad": lambda one: one.roll,
    "yaw_rad": lambda one: one.yaw,
    "s_m": lambda one: one.s,
    "pitch_rad": lambda one: one.pitch,
    "speed_m_per_s": lambda one: one.speed,
    "pitch_rate_rad_per_s": lambda one: one.pitch_rate,
    "lateral_velocity_m_per_s": lambda one: one.lateral_velocity,
    "vertical_velocity_m_per_s": lambda one: one.vertical_velocity,
    "roll_rate_rad_per_s": lambda one: one.roll_rate,
    "yaw_rate_rad_per_s": lambda one: one.yaw_rate,
    "friction": lambda one: one.friction,
    "least_friction": lambda one: one.least_friction,
}
WHEEL: dict[str, Attribute] = {
    "force.longitudinal_n": lambda one: one.force.longitudinal,
    "force.lateral_n": lambda one: one.force.lateral,
    "force.vertical_n": lambda one: one.force.vertical,
    "force.moment_x_n_m": lambda one: one.force.moment_x,
    "force.moment_y_n_m": lambda one: one.force.moment_y,
    "force.moment_z_n_m": lambda one: one.force.moment_z,
    "guard.force.longitudinal_n": lambda one: one.guard_force.longitudinal,
    "guard.force.lateral_n": lambda one: one.guard_force.lateral,
    "guard.force.vertical_n": lambda one: one.guard_force.vertical,
    "guard.force.moment_x_n_m": lambda one: one.guard_force.moment_x,
    "guard.force.moment_y_n_m": lambda one: one.guard_force.moment_y,
    "guard.force.moment_z_n_m": lambda one: one.guard_force.moment_z,
    "guard.clearance_m": lambda one: one.guard_clearance,
    "z_m": lambda one: one.z,
    "pitch_rate_rad_per_s": lambda one: one.pitch_rate,
    "clearance_m": lambda one: one.clearance,
}
CONTACT: dict[str, Attribute] = {
    "y_rail_m": lambda one: one.y_rail,
    "y_wheel_m": lambda one: one.y_wheel,
    "x_m": lambda one: one.reference[0],
    "y_m": lambda one: one.reference[1],
    "z_m": lambda one: one.reference[2],
    "contact_angle_rad": lambda one: one.contact_angle,
    "contact_slope_rad": lambda one: one.contact_slope,
    "normal_force_n": lambda one: one.normal_force.value,
    "approach_m": lambda one: one.approach.value,
    "peak_pressure_pa": lambda one: one.peak_pressure.value,
    "area_m2": lambda one: one.area.value,
    "longitudinal_creepage": lambda one: one.creepage.longitudinal,
    "lateral_creepage": lambda one: one.creepage.lateral,
    "spin_rad_per_m": lambda one: one.creepage.spin,
    "longitudinal_n": lambda one: one.force.longitudinal,
    "lateral_n": lambda one: one.force.lateral,
    "moment_n_m": lambda one: one.force.moment,
    "adhesion_share": lambda one: one.adhesion_share,
    "frictional_power_per_metre_j_per_m": lambda one: one.heat_per_metre,
}
# The axes of `WheelsetSolution.derivatives`.
OF = ["longitudinal_n", "lateral_n", "vertical_n", "moment_x_n_m", "moment_y_n_m", "moment_z_n_m"]
BY = [
    "y_m", "z_m", "roll_rad", "yaw_rad", "speed_m_per_s", "pitch_rate_rad_per_s", "lateral_velocity_m_per_s",
    "yaw_rate_rad_per_s",
]


def check(path: str, quantity: Quantity, found: float | None) -> None:
    """The attribute is the quantity."""
    if quantity.value is None:
        assert found is None or math.isnan(found), path
        return
    # A rounding or two: some are scaled in Python.
    assert found == pytest.approx(quantity.value, rel=1e-14, abs=1e-300), path


def check_all(solution: Solution | GapSolution, table: Mapping[str, Attribute]) -> None:
    for path, quantity in solution.quantities.items():
        assert path in table, f"{path} has no attribute in Python"
        check(path, quantity, table[path](solution))
    assert set(table) == set(solution.quantities), "an attribute of no quantity"


BODY = creepage.Body(shear_modulus=82e9, poisson=0.28)


def test_every_number_of_an_ellipse_has_an_attribute() -> None:
    wheel = creepage.Body(shear_modulus=82e9, poisson=0.28, radius_rolling=0.46)
    rail = creepage.Body(shear_modulus=82e9, poisson=0.28, radius_lateral=0.30)
    for speed in (None, 20.0):
        case = creepage.Case(
            upper=wheel, lower=rail, normal_force=80e3, friction=0.3, longitudinal=-1e-3, lateral=4e-4, spin=0.1, speed=speed
        )
        for theory in ("exact", "fastsim", "polach"):
            solution = case.solve(theory)
            check_all(solution, ELLIPSE)
            errors = solution.force_error
            assert (errors is None) == (theory != "exact")
            if errors is not None:
                assert errors.lateral == solution.quantities["lower_body.lateral_n"].error


def test_every_number_of_areas_has_an_attribute() -> None:
    for speed in (None, 20.0):
        case = GapCase(
            gap=Gap.polynomial([(2, 0, 1.0), (0, 2, 2.0)]), upper=BODY, lower=BODY, normal_force=1e4, friction=0.3,
            longitudinal=-1e-3, spin=0.2, speed=speed, theory="fastsim",
        )
        solution = case.solve()
        check_all(solution, AREAS)
        assert solution.contact.area.error == solution.quantities["contact.area_m2"].error
        # The dictionary of before is there too, and both survive pickle.
        again = pickle.loads(pickle.dumps(solution))
        assert again.contact["area_m2"] == again.contact.area.value == solution.contact.area.value


def test_every_number_of_a_wheelset_has_an_attribute() -> None:
    wheelset = Wheelset(wheel="S1002", rail="UIC60", cant=0.025, axle_load=200e3, y=4e-3, theory="fastsim")
    solution = wheelset.solve(derivatives=True)
    assert solution.derivatives is not None and solution.derivative_errors is not None
    seen: set[str] = set()
    for path, quantity in solution.quantities.items():
        seen.add(of_wheelset(solution, path, quantity))
    assert {"y_m", "force.lateral_n", "area_m2", "derivatives"} <= seen


def test_every_number_of_a_guard_rail_has_an_attribute() -> None:
    wheelset = Wheelset.from_toml(ROOT / "examples" / "wheelset" / "guard-rail.toml")
    solution = wheelset.solve()
    seen = {of_wheelset(solution, path, quantity) for path, quantity in solution.quantities.items()}
    assert "guard.clearance_m" in seen


def of_wheelset(solution: WheelsetSolution, path: str, quantity: Quantity) -> str:
    """Compares a quantity with its attribute, and gives its path in its table."""
    side, _, rest = path.partition(".")
    if side not in ("left", "right"):
        assert path in WHEELSET, f"{path} has no attribute in Python"
        check(path, quantity, WHEELSET[path](solution))
        return path
    wheel = solution.left if side == "left" else solution.right
    assert wheel is not None
    if patch := re.fullmatch(r"patches\.(\d+)\.(.*)", rest):
        contact, key = wheel.patches[int(patch[1])], patch[2]
        assert key in CONTACT, f"{path} has no attribute in Python"
        check(path, quantity, CONTACT[key](contact))
        return key
    if by := re.fullmatch(r"derivatives\.(\w+)\.(\w+)", rest):
        place = (["left", "right"].index(side), OF.index(by[2]), BY.index(by[1]))
        assert solution.derivatives is not None and solution.derivative_errors is not None
        check(path, quantity, solution.derivatives[place])
        assert quantity.error == solution.derivative_errors[place]
        # A force by a length is in N/m though its key, as that of the force, ends in _n.
        assert quantity.unit != "N" or by[2].startswith("moment"), path
        return "derivatives"
    assert rest in WHEEL, f"{path} has no attribute in Python"
    check(path, quantity, WHEEL[rest](wheel))
    return rest


@pytest.mark.parametrize("path", sorted((ROOT / "examples" / "statics").glob("*.toml")), ids=lambda path: path.stem)
def test_every_number_without_rolling_has_a_name(path: Any) -> None:
    solution: StaticsSolution = creepage.statics(path)
    parts: dict[str, Mapping[str, float]] = {"given": solution.given, "found": solution.found}
    parts |= {f"steps.{k}": step for k, step in enumerate(solution.steps)}
    expected = {f"{part}.{key}": value for part, numbers in parts.items() for key, value in numbers.items()}
    assert {path: quantity.value for path, quantity in solution.quantities.items()} == expected
    assert all(quantity.label for quantity in solution.quantities.values())
