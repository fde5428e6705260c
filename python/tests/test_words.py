"""What is refused or warned of, in the words of the call."""

# mypy: ignore-errors
# These calls are wrong on purpose: the messages are what is tested.

import inspect
import pickle
import warnings

import numpy as np
import pytest

import creepage

TWIST = """
upper = { shear_modulus = 75e9, poisson = 0.31, radius_rolling = 0.03, radius_lateral = 0.02 }
lower = { shear_modulus = 75e9, poisson = 0.31, radius_rolling = "flat", radius_lateral = "flat" }
contact = { normal_force = 4e3 }
statics = { problem = "twist", moment = 0.1 }
"""
STEEL = creepage.Body(shear_modulus=80e9, poisson=0.29)
WHEEL = creepage.Body(
    shear_modulus=80e9, poisson=0.29, radius_rolling=0.4, radius_lateral=0.3
)
RAIL = creepage.Body(shear_modulus=80e9, poisson=0.29, radius_rolling="flat", radius_lateral=0.5)


@pytest.mark.parametrize("exponent", [2.5, -1, 0.999, "2", None])
def test_an_exponent_is_a_whole_number(exponent):
    with pytest.raises((TypeError, ValueError), match="exponent"):
        creepage.Gap.polynomial([(2, 0, 1.0), (0, exponent, 1.2)])
    with pytest.raises(ValueError, match="a term is"):
        creepage.Gap.polynomial([3])


def test_whole_exponents_of_any_kind_are_the_same():
    gaps = [
        creepage.Gap.polynomial([(i, 0, 1), (0, i, 2.0)]).to_dict() for i in (2, 2.0, np.int32(2))
    ]
    assert gaps[0] == gaps[1] == gaps[2] == {"polynomial": [(2, 0, 1.0), (0, 2, 2.0)]}


def test_masked_elements_are_refused_by_name():
    y = np.linspace(-8e-3, 8e-3, 33)
    gap = np.ma.array(y**2, mask=abs(y) > 7e-3)
    with pytest.raises(TypeError, match="gap must not have masked"):
        creepage.Gap.section(y, gap, radius_rolling=0.5)
    with pytest.raises(TypeError, match="x must not have masked"):
        creepage.Gap.grid(np.ma.array([0.0, 1e-3, 2e-3], mask=[0, 1, 0]), y, np.zeros((3, 33)))
    # Nothing is masked: the array itself.
    creepage.Gap.section(y, np.ma.array(y**2), radius_rolling=0.5)
    case = creepage.Case(upper=WHEEL, lower=RAIL, normal_force=5e4, friction=0.3)
    with pytest.raises(TypeError, match="masked"):
        case.curve("lateral", np.ma.array([1e-4, 2e-4], mask=[0, 1]))


def test_a_missed_accuracy_is_warned_of():
    theory = creepage.automatic(2.0, 0.3, accuracy=1e-6)
    with pytest.warns(creepage.AccuracyWarning, match="above the prescribed accuracy of 1e-6"):
        force = theory.force(0.4, 0.1, 0.5)
    assert max(force.fx_error, force.fy_error) > 1e-6
    with pytest.warns(creepage.AccuracyWarning, match="2 forces"):
        theory.force(np.array([0.4, 0.5]), 0.1, 0.5)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        creepage.automatic(2.0, 0.3, accuracy=0.05).force(0.4, 0.1, 0.5)


def test_a_line_contact_of_other_bodies_is_refused_or_warned_of():
    roller = creepage.Body(young_modulus=2.1e11, poisson=0.3, radius_rolling=0.015)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        contact = creepage.line_contact(roller, roller, 2e5)
        contact.carter(1e-3, friction=0.2)
    assert contact.kappa == 0.0
    crowned = creepage.Body(
        young_modulus=2.1e11, poisson=0.3, radius_rolling=0.015, radius_lateral=0.4
    )
    with pytest.raises(creepage.CaseError, match="lower: radius_lateral = 0.4 is a crown"):
        creepage.line_contact(roller, crowned, 2e5)
    with pytest.warns(creepage.UnitsWarning, match="check the units"):
        creepage.line_contact(roller, roller, 3e11)
    rubber = creepage.Body(young_modulus=8e6, poisson=0.35, radius_rolling=0.015)
    unlike = creepage.line_contact(rubber, roller, 200.0)
    with pytest.warns(creepage.UnlikeBodiesWarning, match="kappa/mu"):
        unlike.carter(1e-3, friction=0.4)


def test_what_is_no_body_is_named():
    with pytest.raises(TypeError, match="upper must be a creepage.Body, not int"):
        creepage.Case(upper=5, lower=RAIL, normal_force=5e4, friction=0.3)
    with pytest.raises(TypeError, match="gap must be a creepage.Gap, not list"):
        creepage.GapCase(gap=[1], upper=STEEL, lower=STEEL, friction=0.3, normal_force=1e4)
    with pytest.raises(TypeError, match=r"cases\[0\] must be a creepage.GapCase"):
        creepage.GapCase.solve_all(["case"])
    with pytest.raises(TypeError, match="upper must be a creepage.Body"):
        creepage.line_contact("wheel", STEEL, 1e5)


def test_a_case_without_creepage_rolls_freely():
    case = creepage.Case(upper=WHEEL, lower=RAIL, normal_force=5e4, friction=0.3)
    assert case.dimensionless == (0.0, 0.0, 0.0)
    assert case.solve("linear").force.longitudinal == 0.0


def test_an_array_without_dimension_is_a_number():
    wheel = creepage.Body(
        shear_modulus=80e9, poisson=0.29, radius_rolling=np.array(0.4), radius_lateral=0.3
    )
    made = [
        creepage.Case(upper=body, lower=RAIL, normal_force=5e4, friction=0.3, xi=0.2)
        for body in (wheel, WHEEL)
    ]
    assert made[0] == made[1]


def test_messages_name_the_argument_and_no_line_of_a_file():
    with pytest.raises(TypeError, match="grid = .* a whole number") as wrong:
        creepage.fastsim(1.0, 0.3, grid=(10.5, 10))
    assert "usize" not in str(wrong.value)
    file = {"upper": {"shear_modulus": "soft", "poisson": 0.3, "radius_rolling": 0.4}}
    file["upper"]["radius_lateral"] = 0.3
    file["lower"] = {"shear_modulus": 8e10, "poisson": 0.3, "radius_rolling": "flat"}
    file["lower"]["radius_lateral"] = 0.5
    file["contact"] = {"normal_force": 5e4, "friction": 0.3}
    file["creepage"] = {"xi": 0.1}
    with pytest.raises(creepage.CaseError) as wrong:
        creepage.Case.from_dict(file)
    assert "TOML" not in str(wrong.value) and "soft" in str(wrong.value)
    for ask in (
        lambda: creepage.theory("f", 1.0, 0.3),
        lambda: creepage.Case(
            upper=WHEEL, lower=RAIL, normal_force=5e4, friction=0.3, xi=0.1, theory="f"
        ),
    ):
        with pytest.raises(creepage.UnknownTheory, match="exact"):
            ask()


def test_a_place_that_is_no_number_has_no_traction():
    solved = creepage.statics(TWIST)
    assert np.isfinite(solved.traction(0.0, 0.0)).all()
    for x in (np.nan, [0.0, np.nan], np.inf):
        with pytest.raises(creepage.InvalidValue, match="x = .* must be finite"):
            solved.traction(x, 0.0)


def test_a_table_measures_its_error():
    for places in (0, 10**12):
        with pytest.raises(creepage.InvalidValue, match="places"):
            creepage.Table.build("polach", 1.0, 0.28, places=places)


@pytest.mark.filterwarnings("ignore")
def test_solutions_go_through_pickle():
    gap = creepage.GapCase(
        gap=creepage.Gap.polynomial([(2, 0, 1.1), (0, 2, 0.9)]),
        upper=STEEL, lower=STEEL, friction=0.3, normal_force=4e4, longitudinal=5e-4,
    )
    wheelset = creepage.Wheelset(
        wheel="S1002", rail="UIC60", cant=0.025, axle_load=9e4, theory="fastsim"
    )
    for solved in (
        gap.solve("fastsim"),
        *creepage.GapCase.solve_all([gap], "linear"),
        wheelset.solve(),
        creepage.statics(TWIST),
    ):
        again = pickle.loads(pickle.dumps(solved))
        assert again.to_dict() == solved.to_dict()
        assert again == solved and hash(again) == hash(solved)
    assert gap.solve("fastsim") != gap.solve("linear")
    assert pickle.loads(pickle.dumps(gap)) == gap and pickle.loads(pickle.dumps(wheelset)) == wheelset
    assert creepage.Gap.polynomial([(2, 0, 1.1)]) != creepage.Gap.polynomial([(2, 0, 1.2)])


def test_batch_says_what_it_gives():
    signature = inspect.signature(creepage.batch)
    assert "Any" not in str(signature.return_annotation)
    assert "Any" not in str(signature.parameters["cases"].annotation)
