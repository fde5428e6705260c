"""The load-displacement equations of chapters 2 and 3 of the thesis, both ways."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from . import _creepage
from ._contact import number
from ._results import Floats

Edge = Literal["vanishing", "singular"]


class HalfSpace:
    """Two like bodies, or a half-space, under tractions on an ellipse: (2.47), (3.5), and their inverse.

    A polynomial in x and y is the list of its coefficients in the order of (2.49): 1, x, y, x^2,
    xy, y^2, x^3 and so on. A list has all terms of its highest degree; one that is left out is
    zero. A traction is three polynomials (X, Y, Z), exerted on the lower body, times a root of 1 -
    x^2/a^2 - y^2/b^2. The root is ^(1/2), which vanishes at the edge, or ^(-1/2), which is singular
    there. Displacement differences u+ - u- inside the ellipse are three polynomials (u, v, w).

    Hertz: a paraboloid pressed flat::

        half = creepage.HalfSpace(semi_axis_rolling=1, semi_axis_lateral=1, poisson=0.28)
        u, v, w = half.displacement(z=[0.1])

    semi_axis_rolling, semi_axis_lateral: a, b (m). poisson: the combined Poisson's ratio, 0 to 0.5.
    shear_modulus: the combined one (Pa); 1 for tractions over it. degree: the highest degree of
    displacements, 200 at most. Raises InvalidValue for numbers out of range, ValueError for what is
    singular to working precision.
    """

    def __init__(
        self,
        *,
        semi_axis_rolling: float,
        semi_axis_lateral: float,
        poisson: float,
        shear_modulus: float = 1.0,
        degree: int = 12,
    ) -> None:
        for name, value in (
            ("semi_axis_rolling", semi_axis_rolling),
            ("semi_axis_lateral", semi_axis_lateral),
            ("poisson", poisson),
            ("shear_modulus", shear_modulus),
        ):
            number(name, value)
        self.semi_axes = (float(semi_axis_rolling), float(semi_axis_lateral))
        """a, b (m)."""
        self.poisson = float(poisson)
        """The combined Poisson's ratio."""
        self.shear_modulus = float(shear_modulus)
        """The combined shear modulus (Pa)."""
        self.degree = degree
        """The highest degree of displacements."""
        self._data = _creepage.HalfSpaceData(
            self.semi_axes, self.poisson, self.shear_modulus, degree
        )

    def __repr__(self) -> str:
        a, b = self.semi_axes
        return f"<creepage.HalfSpace a = {a:.4g} m, b = {b:.4g} m, degree {self.degree}>"

    def displacement(
        self,
        *,
        x: ArrayLike = (),
        y: ArrayLike = (),
        z: ArrayLike = (),
        edge: Edge = "vanishing",
    ) -> tuple[Floats, Floats, Floats]:
        """Coefficients of (u, v, w), in m over m^(p+q), that the traction (x, y, z) causes, in Pa over
        m^(p+q). Raises ValueError where their degree is higher than was prepared."""
        return _arrays(self._data.displacement(_lists(x, y, z), edge))

    def traction(
        self,
        *,
        u: ArrayLike = (),
        v: ArrayLike = (),
        w: ArrayLike = (),
        edge: Edge = "singular",
    ) -> tuple[Floats, Floats, Floats]:
        """Coefficients of the traction (X, Y, Z) that causes (u, v, w): singular at the edge, which
        always exists (2.22), or vanishing there, which exists for special displacements. Raises
        ValueError where there is none, with the part by which the nearest one misses it."""
        return _arrays(self._data.traction(_lists(u, v, w), edge))

    def resultants(
        self,
        *,
        x: ArrayLike = (),
        y: ArrayLike = (),
        z: ArrayLike = (),
        edge: Edge = "vanishing",
    ) -> tuple[float, float, float, float]:
        """F_x, F_y, N (N) and M_z (N m) of a traction."""
        fx, fy, n, mz = self._data.resultants(_lists(x, y, z), edge)
        return fx, fy, n, mz

    def displacement_at(
        self,
        px: ArrayLike,
        py: ArrayLike,
        *,
        x: ArrayLike = (),
        y: ArrayLike = (),
        z: ArrayLike = (),
        edge: Edge = "vanishing",
        kappa: float = 0.0,
    ) -> Floats:
        """(u, v, w) (m) at points (px, py) (m) inside or outside the ellipse, shape (..., 3).

        kappa: how unlike the bodies are (2.10): Z then moves u and v, and X and Y move w."""
        found: Floats = self._data.displacement_at(_lists(x, y, z), edge, (px, py), kappa)
        return found

    def traction_at(
        self,
        px: ArrayLike,
        py: ArrayLike,
        *,
        x: ArrayLike = (),
        y: ArrayLike = (),
        z: ArrayLike = (),
        edge: Edge = "vanishing",
    ) -> Floats:
        """(X, Y, Z) (Pa) at points (px, py) (m), shape (..., 3); zero outside."""
        found: Floats = self._data.traction_at(_lists(x, y, z), edge, (px, py))
        return found


def _lists(*parts: ArrayLike) -> tuple[list[float], list[float], list[float]]:
    one, two, three = (np.atleast_1d(np.asarray(part, dtype=float)).ravel().tolist() for part in parts)
    return one, two, three


def _arrays(parts: tuple[list[float], ...]) -> tuple[Floats, Floats, Floats]:
    one, two, three = (np.array(part) for part in parts)
    return one, two, three
