"""Sweeps of the numerical theory."""

from __future__ import annotations

from typing import Any

import creepage
import numpy as np
import pytest
from conftest import ROOT

SWEEP: dict[str, dict[str, Any]] = {
    "contact": {"a_over_b": 0.5, "poisson": 0.28},
    "creepage": {
        "chi": [2.0, 0.5],
        "alpha": {"from": -30, "step": 30, "to": 30},
        "upsilon": [2.5, 2.0, 1.7],
    },
}


def test_a_table_has_a_row_a_case() -> None:
    table = creepage.sweep(SWEEP)
    assert len(table) == 18
    assert table.chi.tolist() == [2.0] * 9 + [0.5] * 9
    assert table.upsilon.tolist()[:4] == [2.5, 2.0, 1.7, 2.5]
    assert (table.status == "solved").all()
    theory = creepage.variational(0.5, 0.28)
    force = theory.force(table.xi, table.eta, table.chi)
    # Other starts, the same minimum: to the square root of the iteration's delta^2 = 1e-12.
    np.testing.assert_allclose(table.fx, force.fx, atol=1e-5)
    np.testing.assert_allclose(table.fy, force.fy, atol=1e-5)


def test_a_dataset_has_the_loops_as_dimensions() -> None:
    table, cube = creepage.sweep(SWEEP), creepage.sweep(SWEEP, to="xarray")
    assert dict(cube.sizes) == {"chi": 2, "alpha": 3, "upsilon": 3}
    assert cube.attrs["a_over_b"] == 0.5
    row = table[(table.chi == 0.5) & (table.alpha == 30) & (table.upsilon == 2.0)].iloc[0]
    assert float(cube.fy.sel(chi=0.5, alpha=30.0, upsilon=2.0)) == row.fy
    twice = {**SWEEP, "creepage": {"upsilon": [1.0, 1.0]}}
    assert dict(creepage.sweep(twice, to="xarray").sizes) == {"case": 2}


def test_a_file_of_the_catalogue_and_chains_by_themselves() -> None:
    path = ROOT / "examples" / "catalogue" / "figure-12.toml"
    table = creepage.sweep(path)
    assert table.fx.notna().all()
    data = creepage._creepage.SweepData(path.read_text())
    assert data.cases == len(table)
    whole = data.solve(0, data.chains).splitlines()
    parts = [data.solve(k, 1).splitlines() for k in range(data.chains)]
    assert [row for part in parts for row in part[1:]] == whole[1:]
    with pytest.raises(IndexError):
        data.solve(data.chains, 1)


def test_errors() -> None:
    with pytest.raises(creepage.CaseError, match="a_over_b") as caught:
        creepage.sweep({**SWEEP, "contact": {"a_over_b": -1.0, "poisson": 0.28}})
    assert caught.value.section == "contact"
    with pytest.raises(creepage.CaseError, match="too many") as caught:
        creepage.sweep({**SWEEP, "creepage": {"chi": {"from": 0, "step": 1e-9, "to": 1}}})
    assert caught.value.key == "chi"
    with pytest.raises(ValueError, match="pandas"):
        creepage.sweep(SWEEP, to="parquet")  # type: ignore[call-overload]
