"""Cases whose forces are wanted: the creepage is found."""

from __future__ import annotations

import pickle

import creepage
import pytest
from conftest import wheel


def test_a_wanted_force_is_found() -> None:
    # The creepage of a force is found again from that force.
    given = wheel(longitudinal=-1.5e-3, lateral=4e-4, spin=0.1).solve(resolution="fast")
    wanted = wheel(
        longitudinal_force=given.force.longitudinal,
        lateral_force=given.force.lateral,
        spin=0.1,
        speed=20.0,
        resolution="fast",
    )
    found = wanted.solve()
    # Forces to 1e-7 of mu N by the library's tolerance, over slopes of some 1e-4 here.
    assert found.creepage == pytest.approx(given.creepage, rel=1e-4)
    assert found.force == pytest.approx(given.force, rel=1e-4)
    assert found.known == ("chi", "fx", "fy")
    assert "finds" not in repr(wanted) and "wanted" in repr(wanted)
    assert found.field(points=3).traction.shape == (3, 3, 2)
    assert pickle.loads(pickle.dumps(wanted)).solve().force == found.force
    for ask in (lambda: wanted.creepage, lambda: wanted.dimensionless, wanted.curve):
        with pytest.raises(creepage.CaseError, match=r"\[wanted\] asks for a creepage"):
            ask()


def test_a_wanted_force_that_cannot_be() -> None:
    # Sliding that turns about the middle of a circle gives 3 pi / 16 of mu N c, and no more.
    with pytest.raises(creepage.NotReachable, match="moment = ") as caught:
        wheel(mz=0.9, xi=0.0, eta=0.0).solve(resolution="fast")
    assert 0.3 < caught.value.nearest[2] < 0.65
    with pytest.raises(creepage.CaseError, match="at most 24000"):
        wheel(longitudinal_force=26e3, lateral=0.0, spin=0.0)
    with pytest.raises(creepage.CaseError, match="needs the theory exact") as refused:
        wheel(fx=0.5, eta=0.0, chi=0.0).solve("fastsim")
    assert refused.value.section == "wanted"
    with pytest.raises(creepage.CaseError, match="three"):
        wheel(fx=0.5, eta=0.0)
