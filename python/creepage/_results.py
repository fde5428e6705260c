"""Answers, dimensionless: dataclasses of floats or of NumPy arrays."""

from __future__ import annotations

import enum
from collections.abc import Iterator
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any, Generic, TypeAlias, TypeVar

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Floats: TypeAlias = NDArray[np.float64]
Codes: TypeAlias = NDArray[np.uint8]

Number = TypeVar("Number", float, Floats)
Outcome = TypeVar("Outcome", "Status", Codes)


class Status(enum.IntEnum):
    """Whether a force may be trusted."""

    SOLVED = 0
    """The theory's equations are solved, within the range where the theory holds."""
    NOT_CONVERGED = 1
    """The iteration ended before its tolerance was met; the force is that of the last iterate."""
    CREEPAGE_TOO_SMALL = 2
    """Solved, but the creepage is too small for the theory's resolution. Use linear theory."""
    SPIN_TOO_LARGE = 3
    """Solved, but the spin is beyond the bound up to which the theory holds."""
    INVALID = 4
    """In a table only: the row is no case, such as one with NaN; its numbers are NaN."""
    SEVERAL_SOLUTIONS = 5
    """Solved from friction at rest, but friction falls so steeply that another solution exists."""
    NO_CONTACT = 6
    """No load presses the bodies together: no force."""


class Region(enum.IntEnum):
    """Stick or slip."""

    ADHESION = 0
    SLIP = 1
    OUTSIDE = 2


def by_name(record: Any) -> dict[str, Any]:
    """The fields of a dataclass."""
    return {field.name: getattr(record, field.name) for field in fields(record)}


def same(one: Any, two: Any) -> bool:
    """Whether two numbers, arrays, or lists and mappings of these are the same; NaN is the same as NaN."""
    if isinstance(one, dict):
        return (
            isinstance(two, dict)
            and one.keys() == two.keys()
            and all(same(value, two[name]) for name, value in one.items())
        )
    if isinstance(one, (list, tuple)):
        pairs = zip(one, two, strict=False) if isinstance(two, (list, tuple)) else ()
        return type(one) is type(two) and len(one) == len(two) and all(same(a, b) for a, b in pairs)
    if isinstance(one, (float, np.ndarray)):
        has_nan = np.asarray(one).dtype.kind == "f" and np.asarray(two).dtype.kind == "f"
        return np.array_equal(one, two, equal_nan=has_nan)
    return bool(one == two)


class Comparable:
    """A dataclass that compares by its numbers; as arrays it has no hash."""

    __slots__ = ()

    def __eq__(self, other: object) -> bool:
        """The same numbers, of the same kind; NaN is the same as NaN."""
        if type(other) is not type(self):
            return NotImplemented
        return same(by_name(self), by_name(other))

    __hash__ = None  # type: ignore[assignment]


def names(codes: Status | Codes) -> str | NDArray[np.str_]:
    """Statuses in words."""
    if isinstance(codes, Status):
        return codes.name.lower()
    return np.array([status.name.lower() for status in Status])[codes]


@dataclass(frozen=True, slots=True, eq=False)
class Force(Comparable, Generic[Number, Outcome]):
    """Force and moment on the lower body: floats and a Status, or arrays of one shape."""

    fx: Number
    """Longitudinal, F_x / (mu N)."""
    fy: Number
    """Lateral, F_y / (mu N)."""
    mz: Number
    """Moment about the normal, M_z / (mu N c)."""
    status: Outcome
    """A Status, or an array of their numbers: `force.status == Status.SOLVED`."""

    def __iter__(self) -> Iterator[Number]:
        """fx, fy, mz: `fx, fy, mz = force`."""
        return iter((self.fx, self.fy, self.mz))

    @property
    def magnitude(self) -> Number:
        """The used share of the friction force mu N."""
        size: Number = np.hypot(self.fx, self.fy)
        return float(size) if isinstance(self.fx, float) else size

    @property
    def converged(self) -> bool | NDArray[np.bool_]:
        """False where the iteration ended before its tolerance was met."""
        converged: bool | NDArray[np.bool_] = self.status != Status.NOT_CONVERGED
        return converged

    def to_dict(self) -> dict[str, Any]:
        """The numbers by name, and the status in words; pandas.DataFrame takes it as it is."""
        return {**by_name(self), "status": names(self.status)}


@dataclass(frozen=True, slots=True, eq=False)
class ExactForce(Force[Number, Outcome]):
    """A force with error bars: the error of discretization is smaller in at least 95 % of cases."""

    fx_error: Number
    """Error bar of fx, in units of mu N."""
    fy_error: Number
    """Error bar of fy, in units of mu N."""
    mz_error: Number
    """Error bar of mz, in units of mu N c."""


ScalarForce: TypeAlias = Force[float, Status]
ForceArray: TypeAlias = Force[Floats, Codes]
ScalarExactForce: TypeAlias = ExactForce[float, Status]
ExactForceArray: TypeAlias = ExactForce[Floats, Codes]


@dataclass(frozen=True, slots=True, eq=False)
class Field(Comparable):
    """Traction and slip at points of the contact. Vectors have x and y in a last dimension."""

    position: Floats
    """In units of c = sqrt(a b), shape (..., 2)."""
    traction: Floats
    """On the lower body, in units of mu times the peak pressure, shape (..., 2)."""
    slip: Floats
    """Of the upper body relative to the lower, in units of mu c V / rho, shape (..., 2); NaN
    where the theory does not give it."""
    region: Codes
    """Numbers of Region, shape (...)."""
    semi_axes: tuple[float, float]
    """Of the contact, along and across, in units of c."""

    @property
    def adhesion(self) -> NDArray[np.bool_]:
        """Where the surfaces stick, shape (...)."""
        adhesion: NDArray[np.bool_] = self.region == Region.ADHESION
        return adhesion

    @property
    def inside(self) -> NDArray[np.bool_]:
        """Which points lie in the contact, shape (...)."""
        inside: NDArray[np.bool_] = self.region != Region.OUTSIDE
        return inside

    def to_dict(self) -> dict[str, Any]:
        """A column for each component, flat; pandas.DataFrame takes it as it is."""
        vectors = {"": self.position, "traction_": self.traction, "slip_": self.slip}
        columns = {
            f"{name}{axis}": vector[..., k].ravel()
            for name, vector in vectors.items()
            for k, axis in enumerate("xy")
        }
        words = np.array([region.name.lower() for region in Region])
        return {**columns, "region": words[self.region].ravel()}

    def plot(self, ax: Axes | None = None) -> Axes:
        """Areas of adhesion and slip, and the traction as arrows. Needs matplotlib."""
        from ._plot import plot_field

        return plot_field(self.position, self.region, self.traction, self.semi_axes, ax)


@dataclass(frozen=True, slots=True, eq=False)
class SiField(Comparable):
    """Pressure, traction and slip in SI units. Vectors have x and y in a last dimension."""

    position: Floats
    """From the middle of the contact (m), shape (..., 2)."""
    pressure: Floats
    """Pa, shape (...)."""
    traction: Floats
    """Of the upper body on the lower (Pa), shape (..., 2)."""
    slip: Floats
    """Velocity of the upper body relative to the lower over the rolling velocity, shape (..., 2);
    NaN where the theory does not give it."""
    region: Codes
    """Numbers of Region, shape (...)."""
    semi_axes: tuple[float, float]
    """Of the contact, along and across (m)."""

    def to_dict(self) -> dict[str, Any]:
        """A column for each component, flat; pandas.DataFrame takes it as it is."""
        words = np.array([region.name.lower() for region in Region])
        return {
            "x_m": self.position[..., 0].ravel(),
            "y_m": self.position[..., 1].ravel(),
            "pressure_pa": self.pressure.ravel(),
            "traction_x_pa": self.traction[..., 0].ravel(),
            "traction_y_pa": self.traction[..., 1].ravel(),
            "slip_x": self.slip[..., 0].ravel(),
            "slip_y": self.slip[..., 1].ravel(),
            "region": words[self.region].ravel(),
        }


@dataclass(frozen=True, slots=True, eq=False)
class ElementField(Field):
    """The elements of the full theory."""

    bound: Floats
    """Mean over the element of the traction bound over its largest value."""
    share: Floats
    """Share of the normal force that the element carries."""
    power: Floats
    """Frictional power of the element over mu N mu c V / rho."""
    corners: Floats
    """Corners of each element, all around, shape (n, 4, 2)."""
    beyond: Floats
    """How far each corner is from the border of adhesion along x, shape (n, 4). It is negative in
    adhesion, positive in slip, -1 and 1 where elements adhere or slide everywhere."""


@dataclass(frozen=True, slots=True)
class Found:
    """Creepage and force that fit together."""

    xi: float
    eta: float
    chi: float
    force: ScalarExactForce
    steps: int
    """Newton steps."""

    def to_dict(self) -> dict[str, Any]:
        """All numbers by name."""
        force = self.force.to_dict()
        return {"xi": self.xi, "eta": self.eta, "chi": self.chi, **force, "steps": self.steps}


@dataclass(frozen=True, slots=True, eq=False)
class CreepageCoefficients(Comparable, Generic[Number]):
    """Coefficients of the linear theory; floats or arrays."""

    c11: Number
    """Longitudinal force by longitudinal creepage."""
    c22: Number
    """Lateral force by lateral creepage."""
    c23: Number
    """Lateral force by spin."""
    c32: Number
    """Moment by lateral creepage, -c23."""
    c33: Number
    """Moment by spin."""

    def to_dict(self) -> dict[str, Any]:
        """The coefficients by name."""
        return by_name(self)
