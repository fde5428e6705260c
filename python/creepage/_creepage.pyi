"""The compiled part: the theories, and the data behind Case, Solution, statics and sweep."""

from collections.abc import Callable, Sequence
from os import PathLike
from typing import Any, Final, Literal, TypeAlias, final, overload

from numpy.typing import ArrayLike
from typing_extensions import disjoint_base

from ._results import (
    Codes,
    CreepageCoefficients,
    ElementField,
    ExactForceArray,
    Field,
    Floats,
    ForceArray,
    Found,
    ScalarExactForce,
    ScalarForce,
)

__all__ = [
    "Automatic",
    "CaseData",
    "ContactMapData",
    "DifferentiableTheory",
    "Exact",
    "Fastrip",
    "Fastsim",
    "GapData",
    "HalfSpaceData",
    "Linear",
    "Polach",
    "RollingData",
    "Saturated",
    "ShenHedrickElkins",
    "SolvedCase",
    "SolvedBearing",
    "SolvedGapData",
    "SolvedStatics",
    "SolvedWheelset",
    "Strip",
    "SweepData",
    "Table",
    "Theory",
    "Variational",
    "VermeulenJohnson",
    "WearData",
    "WheelsetData",
    "__version__",
    "carter",
    "carter_field",
    "case_forces",
    "coefficients",
    "command",
    "hertz",
    "line_contact",
    "roll",
    "row_forces",
    "solve_gaps",
    "viscoelastic_cylinders",
]

__version__: Final[str]

_Pair: TypeAlias = tuple[int, int] | Sequence[int]

@disjoint_base
class Theory:
    """A theory of steady rolling, prepared for one ratio of semi-axes and one Poisson's ratio.

    Prepare once, ask many times, from any number of threads. All quantities are dimensionless.
    Creepages are xi = upsilon_x rho / (mu c) and eta = upsilon_y rho / (mu c), spin is chi = phi
    rho / mu. Forces fx, fy are in units of mu N, the moment mz is in units of mu N c, with c =
    sqrt(a b). x is the rolling direction, z points into the lower body. Creepage is that of the
    upper body relative to the lower, forces are those of the upper body on the lower.
    """

    @property
    def name(self) -> str:
        """The theory's name in case files."""

    @property
    def semi_axes(self) -> tuple[float, float]:
        """Semi-axes (a, b) of the contact in units of c: sqrt(a/b) and sqrt(b/a)."""

    @overload
    def force(self, xi: float = 0.0, eta: float = 0.0, chi: float = 0.0) -> ScalarForce:
        """Force and moment on the lower body.

        xi, eta, chi: dimensionless creepages and spin, floats or anything of which NumPy makes
        arrays of real numbers. They broadcast against each other, those of xarray by the names of
        their dimensions. For floats a Force of floats, else a Force of arrays of the common shape.
        Arrays are solved by all cores with the GIL released, and Ctrl-C ends them; do not write to
        them meanwhile.

        Raises InvalidValue where a component is not finite (or beyond 1e100), with the index of the
        first such element. Raises TypeError for what is no real number, ValueError for shapes that
        do not broadcast.
        """

    @overload
    def force(
        self, xi: ArrayLike = 0.0, eta: ArrayLike = 0.0, chi: ArrayLike = 0.0
    ) -> ForceArray: ...
    def __getnewargs_ex__(self) -> tuple[tuple[()], dict[str, Any]]: ...
    def field(
        self,
        xi: float = 0.0,
        eta: float = 0.0,
        chi: float = 0.0,
        *,
        x: ArrayLike | None = None,
        y: ArrayLike | None = None,
        points: int = 50,
    ) -> Field:
        """Traction and slip in the contact at one creepage.

        x, y: positions in units of c, floats or arrays that broadcast; by default the middles of
        points x points cells of the box around the ellipse, y first. Traction is that on the lower
        body, in units of mu times the peak pressure. Slip is that of the upper body relative to the
        lower, in units of mu c V / rho.
        """

class DifferentiableTheory(Theory):
    """A theory that gives the derivative of its force."""

    def derivative(
        self, xi: ArrayLike = 0.0, eta: ArrayLike = 0.0, chi: ArrayLike = 0.0
    ) -> Floats:
        """Derivative of (fx, fy, mz) (rows) by (xi, eta, chi) (columns).

        An array of shape (3, 3), or (..., 3, 3) for arrays, which broadcast as in force.
        One-sided where the force has a kink. Raises as force does.
        """

@final
class Exact(DifferentiableTheory):
    """The full theory: Coulomb's law at every element, no shape of the traction assumed.

    a_over_b: ratio a/b of the semi-axes, along over across the rolling direction, 1/64 to 64.
    poisson: combined Poisson's ratio, 0 to 0.5. resolution: "fast", "standard" (the default),
    "fine", or (along, across) on a circle, 4 to 200 each, 10000 in all. "fast" has 14 x 12
    elements, 0.3 ms a case, rms error 0.14 % of mu N; "standard" 22 x 18, 0.9 ms, 0.05 %; "fine" 40
    x 32, 6 ms, 0.012 %. kappa_over_mu: how unlike the bodies are, kappa of (2.10) over the
    coefficient of friction; like ones have 0. Their pressure adds to the slip.
    """

    def __new__(
        cls,
        a_over_b: float,
        poisson: float,
        *,
        resolution: Literal["fast", "standard", "fine"] | _Pair | None = None,
        kappa_over_mu: float = 0.0,
    ) -> Exact: ...
    @property
    def elements(self) -> tuple[int, int]:
        """Elements along and across."""

    @overload
    def force(self, xi: float = 0.0, eta: float = 0.0, chi: float = 0.0) -> ScalarExactForce: ...
    @overload
    def force(
        self, xi: ArrayLike = 0.0, eta: ArrayLike = 0.0, chi: ArrayLike = 0.0
    ) -> ExactForceArray: ...
    def element_field(
        self, xi: float = 0.0, eta: float = 0.0, chi: float = 0.0
    ) -> ElementField:
        """The elements at one creepage, strip by strip from negative y, from the leading edge."""

    def find(
        self,
        *,
        xi: float | None = None,
        eta: float | None = None,
        chi: float | None = None,
        fx: float | None = None,
        fy: float | None = None,
        mz: float | None = None,
    ) -> Found:
        """The inverse problem: any three of the six quantities in, the other three out.

        Raises NotReachable where no creepage gives the force, TypeError unless exactly three are
        given, InvalidValue where one is not finite.
        """

@final
class Automatic(DifferentiableTheory):
    """The full theory, as fine as a wanted accuracy of fx and fy (in units of mu N) needs.

    kappa_over_mu as of Exact.
    """

    def __new__(
        cls,
        a_over_b: float,
        poisson: float,
        *,
        accuracy: float = 0.001,
        kappa_over_mu: float = 0.0,
    ) -> Automatic: ...
    @overload
    def force(self, xi: float = 0.0, eta: float = 0.0, chi: float = 0.0) -> ScalarExactForce: ...
    @overload
    def force(
        self, xi: ArrayLike = 0.0, eta: ArrayLike = 0.0, chi: ArrayLike = 0.0
    ) -> ExactForceArray: ...

@final
class Variational(Theory):
    """The numerical theory of chapter 5 (Kalker 1967): polynomial tractions.

    degree: of the polynomials, 0 to 12 (3). mesh: cells (along, across) of the box around the
    ellipse, (10, 10) up to degree 3. bound: whether tractions are kept within it, "automatic" by
    default (where a/b >= 3), "unchecked" (as in the thesis: looked at afterwards), "kept".
    integrand: a function of (x, y, a, b, t, s), lengths in units of c, in place of T S (5.22): it
    gives f, f_t, f_s, f_tt, f_ts, f_ss. weight multiplies it too: an integrand with a weight of its
    own goes with weight="uniform". kappa_over_mu as of Exact.
    """

    def __new__(
        cls,
        a_over_b: float,
        poisson: float,
        *,
        degree: int | None = None,
        mesh: _Pair | None = None,
        weight: Literal["elliptic", "uniform", "root-elliptic"] | None = None,
        bound: Literal["automatic", "unchecked", "kept"] | None = None,
        integrand: Callable[[float, float, float, float, float, float], Sequence[float]]
        | None = None,
        kappa_over_mu: float = 0.0,
    ) -> Variational: ...

@final
class Fastsim(DifferentiableTheory):
    """FASTSIM (Kalker 1982) with the flexibilities of Vollebregt and Voltr (2023).

    grid: cells (along, across), (50, 50). flexibility: "blended" by default. bound: "elliptic" by
    default. reduction: factors (k0, alpha, beta) of surfaces that are not clean and dry, (1, 1, 0).
    """

    def __new__(
        cls,
        a_over_b: float,
        poisson: float,
        *,
        grid: _Pair | None = None,
        flexibility: Literal["blended", "three", "one"] | None = None,
        bound: Literal["elliptic", "parabolic"] | None = None,
        reduction: Sequence[float] | None = None,
    ) -> Fastsim: ...

@final
class Fastrip(DifferentiableTheory):
    """FaStrip (Sichani, Enblom, Berg 2016). variant: "consistent" by default."""

    def __new__(
        cls,
        a_over_b: float,
        poisson: float,
        *,
        grid: _Pair | None = None,
        variant: Literal["consistent", "modified", "original"] | None = None,
    ) -> Fastrip: ...

@final
class Strip(DifferentiableTheory):
    """Strip theory (Haines, Ollerton 1963; Kalker 1967): slender contacts, little spin."""

    def __new__(cls, a_over_b: float, poisson: float) -> Strip: ...

@final
class Polach(DifferentiableTheory):
    """Polach (1999), with his factors of reduction for adhesion and slip."""

    def __new__(
        cls,
        a_over_b: float,
        poisson: float,
        *,
        reduction: Sequence[float] = (1.0, 1.0),
    ) -> Polach: ...

@final
class ShenHedrickElkins(DifferentiableTheory):
    """Shen, Hedrick, Elkins (1983): linear forces with a cubic saturation."""

    def __new__(cls, a_over_b: float, poisson: float) -> ShenHedrickElkins: ...

@final
class VermeulenJohnson(DifferentiableTheory):
    """Vermeulen, Johnson (1964): an ellipse of adhesion; no spin."""

    def __new__(cls, a_over_b: float, poisson: float) -> VermeulenJohnson: ...

@final
class Linear(DifferentiableTheory):
    """The linear theory (Kalker 1967, 4.3): no slip; creepage and spin near zero."""

    def __new__(cls, a_over_b: float, poisson: float) -> Linear: ...

@final
class Saturated(DifferentiableTheory):
    """Slip everywhere, as if the bodies were rigid (Kalker 1967, 4.4)."""

    def __new__(cls, a_over_b: float, poisson: float = 0.0) -> Saturated: ...

@final
class Table:
    """Creep force of one theory, looked up.

    Over creepage and spin from zero to infinity, at one ratio a/b and one Poisson's ratio or over
    ranges of these. `Table.build` makes one, `Table.read` reads a file of `creepage table build`.
    """

    @staticmethod
    def read(path: str | PathLike[str]) -> Table: ...
    @staticmethod
    def from_bytes(bytes: bytes) -> Table:
        """A table of the bytes of its file."""

    def write(self, path: str | PathLike[str]) -> None: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    @staticmethod
    def build(
        theory: str,
        a_over_b: float | tuple[float, float],
        poisson: float | tuple[float, float],
        *,
        intervals: Sequence[int] = ...,
        shapes: int = 9,
        materials: int = 4,
        places: int = 500,
        **options: Any,
    ) -> Table: ...
    @property
    def theory(self) -> str: ...
    @property
    def options(self) -> str: ...
    @property
    def a_over_b(self) -> tuple[float, float]: ...
    @property
    def poisson(self) -> tuple[float, float]: ...
    @property
    def force_error(self) -> tuple[float, float, float, float]:
        """The measured error of (fx, fy) in units of mu N: median, 95 %, 99 %, worst."""

    @property
    def moment_error(self) -> tuple[float, float, float, float]:
        """The measured error of mz in units of mu N c: median, 95 %, 99 %, worst."""

    @overload
    def force(
        self,
        xi: float = 0.0,
        eta: float = 0.0,
        chi: float = 0.0,
        *,
        a_over_b: float | None = None,
        poisson: float | None = None,
    ) -> ScalarForce: ...
    @overload
    def force(
        self,
        xi: ArrayLike = 0.0,
        eta: ArrayLike = 0.0,
        chi: ArrayLike = 0.0,
        *,
        a_over_b: ArrayLike | None = None,
        poisson: ArrayLike | None = None,
    ) -> ForceArray: ...
    def derivative(
        self,
        xi: ArrayLike = 0.0,
        eta: ArrayLike = 0.0,
        chi: ArrayLike = 0.0,
        *,
        a_over_b: ArrayLike | None = None,
        poisson: ArrayLike | None = None,
    ) -> Floats: ...

@overload
def coefficients(
    a_over_b: float, poisson: float, *, degree: int | None = None
) -> CreepageCoefficients[float]: ...
@overload
def coefficients(
    a_over_b: ArrayLike, poisson: ArrayLike, *, degree: int | None = None
) -> CreepageCoefficients[Floats]: ...
def carter(creepage: ArrayLike) -> list[Any]: ...
def carter_field(creepage: ArrayLike, x: ArrayLike) -> tuple[Any, Any, Codes]: ...
def line_contact(
    shear_moduli: Sequence[float],
    poisson: Sequence[float],
    radii: Sequence[float],
    load: float,
) -> tuple[float, float, float, float, str | None]: ...
def viscoelastic_cylinders(
    material: Sequence[float],
    radius: float,
    friction: float,
    speed: ArrayLike,
    load: ArrayLike,
    force: ArrayLike,
) -> list[Any]: ...
def hertz(text: str) -> str: ...
def command(arguments: Sequence[str]) -> int: ...
def case_forces(
    case: CaseData,
    theory: str,
    options: dict[str, Any],
    table: Table | None,
    quantities: dict[str, Any],
) -> dict[str, Any]: ...
def row_forces(
    theory: str,
    options: dict[str, Any],
    table: Table | None,
    columns: Sequence[ArrayLike],
) -> dict[str, Any]: ...

_Three: TypeAlias = tuple[Sequence[float], Sequence[float], Sequence[float]]

@final
class HalfSpaceData:
    """The half-space under tractions on an ellipse: prepared up to a degree."""

    def __new__(
        cls, semi_axes: Sequence[float], poisson: float, modulus: float, degree: int
    ) -> HalfSpaceData: ...
    def displacement(
        self, traction: _Three, edge: str
    ) -> tuple[list[float], list[float], list[float]]: ...
    def traction(
        self, displacement: _Three, edge: str
    ) -> tuple[list[float], list[float], list[float]]: ...
    def resultants(self, traction: _Three, edge: str) -> list[float]: ...
    def displacement_at(
        self, traction: _Three, edge: str, points: Sequence[ArrayLike], kappa: float
    ) -> Any: ...
    def traction_at(self, traction: _Three, edge: str, points: Sequence[ArrayLike]) -> Any: ...


@final
class CaseData:
    """The text of a case file, read and checked."""

    def __new__(cls, text: str) -> CaseData: ...
    def __getnewargs__(self) -> tuple[str]: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def fit(
        self,
        theory: str,
        options: dict[str, Any],
        columns: Sequence[tuple[str, Sequence[float]]],
        slope: bool,
    ) -> tuple[str, list[str]]: ...
    @property
    def damage_columns(self) -> list[str]: ...
    @property
    def text(self) -> str: ...
    @property
    def a_over_b(self) -> float: ...
    @property
    def poisson(self) -> float: ...
    @property
    def friction(self) -> float: ...
    @property
    def speed(self) -> float | None: ...
    @property
    def kappa_over_mu(self) -> float: ...
    @property
    def finds_creepage(self) -> bool: ...
    @property
    def dimensionless(self) -> tuple[float, float, float]: ...
    @property
    def creepage(self) -> tuple[float, float, float]: ...
    @property
    def units(self) -> tuple[float, float, float, float]: ...
    def hertz(self) -> str: ...
    def theory(self) -> str: ...
    def neglects(self, theory: str) -> str | None: ...
    @property
    def units_in_doubt(self) -> str | None: ...
    def solve(self, theory: str, options: dict[str, Any]) -> SolvedCase: ...

@final
class SolvedCase:
    """A case solved by one theory."""

    def below(self, body: str, points: Sequence[ArrayLike]) -> tuple[Any, Any, float]: ...
    @property
    def dimensionless(self) -> ScalarForce: ...
    @property
    def caution(self) -> str | None: ...
    @property
    def force(self) -> tuple[float, float, float]: ...
    @property
    def creepage(self) -> tuple[float, float, float]: ...
    @property
    def adhesion_share(self) -> float: ...
    @property
    def heat_per_metre(self) -> float: ...
    @property
    def heat_per_metre_by_slip(self) -> float | None: ...
    @property
    def power(self) -> float | None: ...
    @property
    def known(self) -> list[str] | None: ...
    @property
    def details(self) -> dict[str, float]: ...
    def quantities(
        self,
    ) -> list[tuple[str, str, str, float | None, float | None]]: ...
    def json(self) -> str: ...
    def text(self) -> str: ...
    def svg(self) -> str: ...
    def write(self, directory: str | PathLike[str]) -> list[str]: ...
    def field(self, points: int) -> Field: ...
    def points(self) -> Field: ...

@final
class SolvedBearing:
    """A ball bearing, solved."""

    def __new__(cls, text: str) -> SolvedBearing: ...
    def quantities(
        self,
    ) -> list[tuple[str, str, str, float | None, float | None]]: ...
    def json(self) -> str: ...
    def text(self) -> str: ...
    def svg(self) -> str: ...
    def write(self, directory: str | PathLike[str]) -> list[str]: ...

@final
class SolvedStatics:
    """A problem without rolling, solved."""

    def __new__(cls, text: str) -> SolvedStatics: ...
    def quantities(
        self,
    ) -> list[tuple[str, str, str, float | None, float | None]]: ...
    def json(self) -> str: ...
    def text(self) -> str: ...
    def svg(self) -> str: ...
    def write(self, directory: str | PathLike[str]) -> list[str]: ...
    def traction(self, x: ArrayLike, y: ArrayLike) -> Floats: ...
    def pressure(self, x: ArrayLike, y: ArrayLike) -> Floats: ...
    def displacement(self, x: ArrayLike, y: ArrayLike) -> Floats: ...

@final
class WheelsetData:
    """A wheelset in its track, read and checked."""

    def __new__(cls, text: str, directory: str | PathLike[str]) -> WheelsetData: ...
    def poisson(self) -> float: ...
    def notes(self) -> list[str]: ...
    def solve(self, derivatives: bool) -> SolvedWheelset: ...
    def by_theory(self, theory: str, options: Sequence[str]) -> WheelsetData: ...
    def at(self, s: float, pitch: float) -> WheelsetData: ...
    def text(self) -> str: ...
    def solve_at(
        self,
        asked: Sequence[float],
        start: SolvedWheelset | None,
        derivatives: bool,
    ) -> SolvedWheelset: ...
    def solve_rows(self, rows: Floats) -> tuple[Floats, list[list[str]]]: ...
    def roll(
        self, columns: Sequence[tuple[str, list[float]]], starts_steady: bool | None
    ) -> tuple[dict[str, Any], list[str]]: ...
    def table(self, axes: Sequence[tuple[str, list[float]]]) -> dict[str, Floats]: ...
    def radius_difference(self, rolls: bool) -> list[tuple[float, float]]: ...
    def conicity(self, amplitudes: Sequence[float], rolls: bool) -> tuple[list[float], list[str]]: ...

@final
class WearData:
    """Wear over a distance, run."""

    @staticmethod
    def run(
        wheelset: WheelsetData,
        text: str | None,
        directory: str | PathLike[str],
        state: str | PathLike[str] | None,
        progress: Callable[[float], object] | None,
    ) -> WearData: ...
    @staticmethod
    def restored(
        wheelset: WheelsetData, text: str | None, directory: str | PathLike[str], saved: str
    ) -> WearData: ...
    def saved(self) -> str: ...
    def bodies(self) -> list[str]: ...
    def stops(self) -> list[Floats]: ...
    def numbers(self, body: str) -> dict[str, Floats]: ...
    def profiles(self, body: str) -> list[tuple[Floats, Floats]]: ...
    def outcome(self) -> tuple[bool, list[str]]: ...
    def ended(self) -> str | None: ...
    def json(self) -> str: ...
    def text(self) -> str: ...
    def svg(self, role: str) -> str | None: ...
    def write(self, directory: str | PathLike[str]) -> list[str]: ...

@final
class ContactMapData:
    """A contact map."""

    @staticmethod
    def check(
        wheelset: WheelsetData,
        plan: Sequence[float],
        loads: Sequence[float],
        states: int,
        resolution: str,
    ) -> None: ...
    @staticmethod
    def build(
        wheelset: WheelsetData,
        ellipses: Table,
        plan: Sequence[float],
        loads: Sequence[float],
        states: int,
        resolution: str,
        journal: PathLike[str] | None,
    ) -> ContactMapData: ...
    @staticmethod
    def load(path: str | PathLike[str]) -> ContactMapData: ...
    @staticmethod
    def from_bytes(bytes: bytes) -> ContactMapData: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def save(self, path: str | PathLike[str]) -> None: ...
    def source(self) -> str: ...
    def own(self) -> list[float]: ...
    def error(self) -> list[list[float]]: ...
    def ranges(self) -> list[list[float]]: ...
    def solve(
        self, row: Sequence[float], derivatives: bool
    ) -> tuple[Floats, Floats, Floats | None]: ...
    def solve_rows(self, rows: Floats) -> tuple[Floats, list[tuple[int, str]]]: ...

@final
class SolvedWheelset:
    """A wheelset, solved."""

    def numbers(self) -> Floats: ...
    def quantities(
        self,
    ) -> list[tuple[str, str, str, float | None, float | None]]: ...
    def position(self) -> list[float]: ...
    def outcome(self) -> tuple[str, list[str]]: ...
    def json(self) -> str: ...
    def derivatives(self) -> list[Floats] | None: ...
    def text(self) -> str: ...
    def svg(self) -> str: ...
    def write(self, directory: str | PathLike[str]) -> list[str]: ...

@final
class GapData:
    """A contact of any shape, read and checked."""

    def __new__(cls, text: str, directory: str | PathLike[str]) -> GapData: ...
    def solve(self, theory: str | None) -> SolvedGapData: ...

@final
class SolvedGapData:
    """A contact of any shape, solved."""

    def quantities(
        self,
    ) -> list[tuple[str, str, str, float | None, float | None]]: ...
    def json(self) -> str: ...
    def text(self) -> str: ...
    def svg(self) -> str: ...
    def write(self, directory: str | PathLike[str]) -> list[str]: ...

def solve_gaps(
    cases: Sequence[GapData], theory: str | None
) -> list[SolvedGapData | Exception]: ...
@final
class RollingData:
    """A contact that rolls step by step."""

    def __new__(
        cls, text: str, is_case: bool, start: bool | tuple[float, float] | None
    ) -> RollingData: ...
    @property
    def caution(self) -> str | None: ...
    def step(
        self, given: Sequence[tuple[str, float]]
    ) -> tuple[float, list[float], list[float], float, int, str | None]: ...
    def save(self) -> bytes: ...
    def restore(self, state: bytes) -> None: ...

def roll(
    text: str,
    is_case: bool,
    start: bool | tuple[float, float] | None,
    columns: Sequence[tuple[str, Floats]],
) -> tuple[dict[str, Floats | Codes], str | None]: ...
@final
class SweepData:
    """The text of a sweep file, read and checked."""

    def __new__(cls, text: str) -> SweepData: ...
    @property
    def cases(self) -> int: ...
    @property
    def chains(self) -> int: ...
    @property
    def shared(self) -> tuple[float, float, int, list[int]]: ...
    def solve(self, first: int, count: int) -> bytes: ...
