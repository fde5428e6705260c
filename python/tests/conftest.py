"""What the tests share."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import creepage
import matplotlib as mpl
import pytest

mpl.use("Agg")

ROOT = Path(__file__).parents[2]
STEEL: dict[str, Any] = {"shear_modulus": 82e9, "poisson": 0.28}
WHEEL = creepage.Body(**STEEL, radius_rolling=0.46)
RAIL = creepage.Body(**STEEL, radius_rolling="flat", radius_lateral=0.30)
STEEL_WHEEL: dict[str, Any] = {"upper": WHEEL, "lower": RAIL, "normal_force": 80e3}
LOAD: dict[str, Any] = {"normal_force": 80e3, "friction": 0.3}


def wheel(**more: Any) -> creepage.Case:
    """The wheel of the examples with another motion, theory or option."""
    return creepage.Case(upper=WHEEL, lower=RAIL, **LOAD, **more)


@pytest.fixture(scope="session")
def wheel_on_rail() -> creepage.Case:
    return creepage.Case.from_toml(ROOT / "examples" / "wheel-on-rail.toml")


@pytest.fixture(params=list(creepage.THEORIES), scope="session")
def theory(request: pytest.FixtureRequest) -> creepage.Theory:
    """Every theory, coarse where that makes it quick."""
    options: dict[str, dict[str, Any]] = {
        "exact": {"resolution": "fast"},
        "automatic": {"accuracy": 0.1},
    }
    name: str = request.param
    return creepage.theory(name, 1.3, 0.28, **options.get(name, {}))


@pytest.fixture(scope="session")
def mapped() -> creepage.Wheelset:
    return creepage.Wheelset(
        wheel="S1002", rail="UIC60", cant=0.024994793618920, axle_load=100e3, speed=20.0
    )


@pytest.fixture(scope="session")
def contact_map(mapped: creepage.Wheelset) -> creepage.ContactMap:
    """About the middle of the track, coarse: the shapes of areas there are within the table's."""
    ellipses = creepage.Table.build(
        "exact",
        a_over_b=(0.15, 30.0),
        shapes=7,
        poisson=0.28,
        intervals=(8, 8, 16),
        resolution="fast",
        places=10,
    )
    return mapped.map(
        ellipses=ellipses, y=0.001, yaw=0.004, loads=[20e3, 50e3, 100e3], tolerance=0.05, states=1,
        resolution="fast",
    )
