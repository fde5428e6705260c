"""A wheelset asked in many positions and motions."""

import importlib.util
import math
import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import creepage

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def wheelset() -> creepage.Wheelset:
    return creepage.Wheelset(
        wheel="S1002", rail="UIC60", cant=0.025, axle_load=200e3, y=0.002, yaw=0.001, theory="fastsim"
    )


def test_what_is_left_out_is_the_wheelset_s_own(wheelset: creepage.Wheelset) -> None:
    own, asked = wheelset.solve(), wheelset.solver().solve()
    assert own.left is not None and own.right is not None
    for side, report in ((asked.left, own.left), (asked.right, own.right)):
        keys = ("longitudinal_n", "lateral_n", "vertical_n")
        assert side.force.tolist() == [report["force"][key] for key in keys]
        assert side.patches[0].normal_force == report["patches"][0]["normal_force_n"]
    assert asked.status == own.status


def test_the_same_question_has_the_same_bits_whatever_came_before(wheelset: creepage.Wheelset) -> None:
    solver = wheelset.solver()
    first = solver.solve(y=0.003, speed=20.0)
    solver.solve(y=-0.004, axle_load=120e3)
    assert solver.solve(y=0.003, speed=20.0).wrench.tolist() == first.wrench.tolist()


def test_a_start_nearby_gives_the_same_within_the_load_s_bars(wheelset: creepage.Wheelset) -> None:
    solver = wheelset.solver()
    before = solver.solve(y=0.003)
    cold, warm = solver.solve(y=0.00305), solver.solve(y=0.00305, start=before)
    # A load is met to 1e-4, and friction follows it.
    assert np.abs(cold.wrench[:3] - warm.wrench[:3]).max() < 5e-4 * 200e3


def test_a_solver_and_its_results_go_through_pickle(wheelset: creepage.Wheelset) -> None:
    solver = wheelset.solver("fastsim")
    copy = pickle.loads(pickle.dumps(solver))
    assert copy == solver and copy != wheelset.solver("linear")
    one = solver.solve(y=0.003, derivatives=True)
    assert copy.solve(y=0.003, derivatives=True) == one
    again = pickle.loads(pickle.dumps(one))
    assert again == one and again.left == one.left and again != solver.solve(y=0.003)
    # By what is found and not given they are NaN.
    assert one.derivatives is not None and np.array_equal(again.derivatives, one.derivatives, equal_nan=True)
    # As a start it says nothing: the bits are those from nothing.
    assert solver.solve(y=0.00305, start=again) == solver.solve(y=0.00305)


def test_many_rows_have_the_bits_of_each_alone(wheelset: creepage.Wheelset) -> None:
    solver = wheelset.solver()
    y, load = np.array([-0.002, 0.0, 0.004]), np.array([[150e3], [220e3]])
    many = solver.solve_many(y=y, axle_load=load)
    assert many.left.shape == (2, 3, 6) and (many.status == "solved").all()
    alone = solver.solve(y=0.004, axle_load=220e3)
    assert many.wrench[1, 2].tolist() == alone.wrench.tolist()
    assert (many.z[1, 2], many.roll[1, 2]) == (alone.z, alone.roll)


def test_many_rows_carry_the_cautions_of_each_alone(wheelset: creepage.Wheelset) -> None:
    solver = wheelset.solver()
    loads = [100e3, 2e6]  # Steel yields under the second.
    many = solver.solve_many(axle_load=loads)
    alone = [solver.solve(axle_load=load).cautions for load in loads]
    assert many.cautions.tolist() == ["; ".join(cautions) for cautions in alone]
    assert any("yield" in caution for caution in alone[1])


def test_the_wrench_is_the_sum_of_both_rails_forces(wheelset: creepage.Wheelset) -> None:
    asked = wheelset.solver().solve(yaw=0.002)
    # Rounding of a sum.
    assert asked.wrench[:3] == pytest.approx(-(asked.left.force + asked.right.force), abs=1e-6)
    assert asked.wrench[2] == pytest.approx(-200e3, rel=2e-4)
    # Nothing turns the axle: the pitch rate was found so, to 1e-5 of what friction could. It points along
    # (-sin yaw, cos yaw cos roll, cos yaw sin roll); loads pass through it but for their places.
    axle = np.array([-np.sin(asked.yaw), np.cos(asked.yaw) * np.cos(asked.roll), np.sin(asked.roll)])
    assert abs(asked.wrench[3:] @ axle) < 1e-4 * 0.3 * 200e3 * 0.46


def test_a_height_and_a_roll_press_as_the_load_did(wheelset: creepage.Wheelset) -> None:
    solver = wheelset.solver()
    loaded = solver.solve()
    placed = solver.solve(z=loaded.z, roll=loaded.roll, pitch_rate=loaded.pitch_rate)
    assert placed.wrench[2] == pytest.approx(loaded.wrench[2], rel=1e-3)


def test_a_roll_rate_is_a_lateral_velocity_of_the_treads(wheelset: creepage.Wheelset) -> None:
    """Below the centre by the radius the surface moves to the left, at -radius times the rate. The wheels
    move up and down besides, by 1.6 times as much, on treads that slope by 1:40 to 1:20: 4 to 8 %."""
    solver = wheelset.solver()
    rolling = solver.solve(y=0.0, yaw=0.0, roll_rate=0.01)
    moving = solver.solve(y=0.0, yaw=0.0, lateral_velocity=-0.0046)
    still = solver.solve(y=0.0, yaw=0.0)
    by_rate, by_velocity = (one.wrench[1] - still.wrench[1] for one in (rolling, moving))
    assert by_rate == pytest.approx(by_velocity, rel=0.08) and abs(by_rate) > 100.0


def test_a_mirrored_motion_has_mirrored_forces(wheelset: creepage.Wheelset) -> None:
    solver = wheelset.solver()
    motion: dict[str, Any] = {"lateral_velocity": 0.01, "roll_rate": 0.02, "yaw_rate": 0.01}
    one = solver.solve(y=0.003, yaw=0.001, vertical_velocity=0.01, **motion)
    other = solver.solve(
        y=-0.003, yaw=-0.001, vertical_velocity=0.01, **{name: -value for name, value in motion.items()}
    )
    signs = np.array([1, -1, 1, -1, 1, -1])
    # Both search for their height from different sides: the load's tolerance.
    assert one.wrench == pytest.approx(signs * other.wrench, abs=5e-4 * 200e3)


def test_another_theory_and_derivatives(wheelset: creepage.Wheelset) -> None:
    solver = wheelset.solver("exact", resolution="fast")
    asked = solver.solve(derivatives=True)
    assert asked.derivatives is not None and asked.derivatives.shape == (2, 6, 8)
    assert asked.left.force[0] != wheelset.solver().solve().left.force[0]


def test_nonsense_is_refused_in_python_s_words(wheelset: creepage.Wheelset) -> None:
    solver = wheelset.solver()
    with pytest.raises(TypeError, match="y must be a number, got '2'"):
        solver.solve(y="2")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="yaw must be finite"):
        solver.solve(yaw=float("nan"))
    with pytest.raises(ValueError, match="exclude each other"):
        solver.solve(z=0.0, axle_load=1e5)
    with pytest.raises(TypeError, match="unknown quantity 'yawn'"):
        solver.solve_many(yawn=[0.0])
    with pytest.raises(creepage.CaseError, match="at rest"):
        solver.solve(speed=0.0)
    many = solver.solve_many(y=[0.0, 0.5])
    assert many.status[0] == "solved" and "solved" != many.status[1]
    assert np.isnan(many.wrench[1]).all()


def test_the_example_hunts_from_the_critical_speed_of_wickens_on() -> None:
    pytest.importorskip("scipy")
    path = ROOT / "python" / "examples" / "hunting.py"
    spec = importlib.util.spec_from_file_location("hunting", path)
    assert spec is not None and spec.loader is not None
    hunting = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(hunting)
    setattr(hunting, "STIFFNESS", (2e6, 2e6))
    cone = creepage.Wheelset(
        wheel="cone-1:20", rail="UIC60", cant=math.atan(1 / 20), axle_load=100e3, friction=0.4
    )
    # Wickens: V^2 = (r l / lambda) (k_y l^2 + k_psi) / (m l^2 + I) = (108.58 m/s)^2, l = .75 m, without spin,
    # gravity and the difference of both creep coefficients: with these 108.63.
    assert hunting.critical_speed(cone.solver(), 100.0, 118.0) == pytest.approx(108.6, rel=5e-3)


def test_a_small_swing_grows_as_derivatives_have_it() -> None:
    path = ROOT / "python" / "examples" / "hunting_with_height.py"
    spec = importlib.util.spec_from_file_location("hunting_with_height", path)
    assert spec is not None and spec.loader is not None
    example = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(example)
    wheelset = creepage.Wheelset(
        wheel="S1002", rail="UIC60", cant=0.025, axle_load=100e3, friction=0.4, theory="fastsim"
    )
    hunting = example.Hunting(wheelset, wheelset.solver(), 60.0)
    grows = example.damping(hunting.matrix())
    # A swing of 20 um is not small without end: the slopes of S1002 change within it.
    assert grows > 1.0 and hunting.growth(0.1, 5e-4) == pytest.approx(grows, rel=0.05)


def test_a_moment_and_independent_wheels() -> None:
    wheelset = creepage.Wheelset(
        wheel="S1002", rail="UIC60", cant=0.025, axle_load=180e3, theory="fastsim"
    )
    solver = wheelset.solver()
    pressed = solver.solve(y=0.003, axle_load=180e3, roll_moment=2e3)
    # To 1e-4 of the load at levers of .75 m.
    assert pressed.wrench[3] == pytest.approx(-2e3, abs=2e-4 * 180e3 * 0.75)
    with pytest.raises(creepage.CaseError):
        solver.solve(roll=0.0, roll_moment=2e3)
    with pytest.raises(creepage.CaseError):
        solver.solve(z=0.0, roll_moment=2e3)
    back = solver.solve(y=0.003, yaw=-0.001, speed=-20.0)
    ahead = solver.solve(y=0.003, yaw=0.001, speed=20.0)
    np.testing.assert_array_equal(back.right.force, ahead.right.force * [-1.0, 1.0, 1.0])
    assert back.right.pitch_rate == -ahead.right.pitch_rate
