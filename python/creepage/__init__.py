"""Rolling contact of two elastic bodies with dry friction.

Creepage and spin in, tangential force and moment out::

    import creepage
    force = creepage.exact(a_over_b=1.5, poisson=0.28).force(xi=0.9, eta=0.1, chi=0.2)
    print(force.fx, "+-", force.fx_error)

A theory is prepared once from the shape of the contact and asked many times, with floats or with
arrays that broadcast as in NumPy. `Case` is the front door in SI units. x is the rolling direction,
z points into the lower body. Creepage and spin are the velocity of the upper body relative to the
lower over the rolling velocity. Forces are those of the upper body on the lower. Equation numbers
are those of J.J. Kalker, On the rolling contact of two elastic bodies in the presence of dry
friction, thesis, Delft, 1967.
"""

from ._batch import batch
from ._bearing import BearingBall, BearingRace, BearingSolution, bearing
from ._bulk import CaseForce
from ._case import Case, Curve
from ._contact import Body, Hertz, hertz
from ._creepage import (
    Automatic,
    DifferentiableTheory,
    Exact,
    Fastrip,
    Fastsim,
    Linear,
    Polach,
    Saturated,
    ShenHedrickElkins,
    Strip,
    Table,
    Theory,
    Variational,
    VermeulenJohnson,
    __version__,
    coefficients,
)
from ._errors import (
    AccuracyWarning,
    CaseError,
    CreepageError,
    InvalidOption,
    InvalidValue,
    NotReachable,
    TableError,
    UnitsWarning,
    UnknownTheory,
    UnlikeBodiesWarning,
)
from ._line_contact import (
    CarterSolution,
    LineContact,
    ViscoelasticSolution,
    carter,
    line_contact,
    viscoelastic_cylinders,
)
from ._report import Quantity
from ._report_parts import AreaContact, Estimate, RailForce, Wheel, WheelContact
from ._results import (
    CreepageCoefficients,
    ElementField,
    ExactForce,
    ExactForceArray,
    Field,
    Force,
    ForceArray,
    Found,
    Region,
    ScalarExactForce,
    ScalarForce,
    SiField,
    Status,
)
from ._fit import Fitted, FrictionFit
from ._gap import Gap, GapCase, GapSolution
from ._half_space import HalfSpace
from ._map import CellError, ContactMap, ErrorSpread, MapErrors, MapMany, MapResult
from ._rolling import Rolling, RollingStep, roll
from ._solution import Below, DimensionlessCreepage, SiCreepage, SiForce, Solution
from ._statics import StaticsSolution, statics
from ._sweep import sweep
from ._theories import THEORIES, theory
from ._wear import Wear, WornBody, wear
from ._wheelset import Wheelset, WheelsetSolution
from ._wheelset_solver import Patch, WheelResult, WheelsetMany, WheelsetResult, WheelsetSolver

exact = Exact
automatic = Automatic
variational = Variational
fastrip = Fastrip
fastsim = Fastsim
strip = Strip
polach = Polach
shen_hedrick_elkins = ShenHedrickElkins
vermeulen_johnson = VermeulenJohnson
linear = Linear
saturated = Saturated

__all__ = [
    "THEORIES",
    "AccuracyWarning",
    "AreaContact",
    "Automatic",
    "BearingBall",
    "BearingRace",
    "BearingSolution",
    "Below",
    "Body",
    "CarterSolution",
    "Case",
    "CaseError",
    "CaseForce",
    "CellError",
    "ContactMap",
    "CreepageCoefficients",
    "CreepageError",
    "Curve",
    "DifferentiableTheory",
    "DimensionlessCreepage",
    "ElementField",
    "ErrorSpread",
    "Estimate",
    "Exact",
    "ExactForce",
    "ExactForceArray",
    "Fastrip",
    "Fastsim",
    "Field",
    "Force",
    "ForceArray",
    "Fitted",
    "Found",
    "FrictionFit",
    "Gap",
    "GapCase",
    "GapSolution",
    "HalfSpace",
    "Hertz",
    "InvalidOption",
    "InvalidValue",
    "LineContact",
    "Linear",
    "MapErrors",
    "MapMany",
    "MapResult",
    "NotReachable",
    "Patch",
    "Polach",
    "Quantity",
    "RailForce",
    "Region",
    "Rolling",
    "RollingStep",
    "Saturated",
    "ScalarExactForce",
    "ScalarForce",
    "ShenHedrickElkins",
    "SiCreepage",
    "SiField",
    "SiForce",
    "Solution",
    "StaticsSolution",
    "Status",
    "Strip",
    "Table",
    "TableError",
    "Theory",
    "UnitsWarning",
    "UnknownTheory",
    "UnlikeBodiesWarning",
    "Variational",
    "VermeulenJohnson",
    "ViscoelasticSolution",
    "Wear",
    "Wheel",
    "WheelContact",
    "WheelResult",
    "Wheelset",
    "WheelsetMany",
    "WheelsetResult",
    "WheelsetSolution",
    "WheelsetSolver",
    "WornBody",
    "__version__",
    "automatic",
    "batch",
    "bearing",
    "carter",
    "coefficients",
    "exact",
    "fastrip",
    "fastsim",
    "hertz",
    "line_contact",
    "linear",
    "polach",
    "roll",
    "saturated",
    "shen_hedrick_elkins",
    "statics",
    "strip",
    "sweep",
    "theory",
    "variational",
    "vermeulen_johnson",
    "viscoelastic_cylinders",
    "wear",
]
