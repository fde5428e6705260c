"""What the tests share."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import creepage
import matplotlib as mpl
import pytest

mpl.use("Agg")

ROOT = Path(__file__).parents[2]


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
