"""Many cases as a table, here or on the workers of a Dask client."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias, overload

import numpy as np

from . import _creepage
from ._bulk import COLUMNS, words
from ._case import QUANTITIES, Case
from ._parts import Client, Out, files, frame, ranges
from ._theories import chosen, find

if TYPE_CHECKING:
    import pandas as pd
    import polars as pl

    Cases: TypeAlias = pd.DataFrame | Mapping[str, Any]

CONTACT = ("a_over_b", "poisson", "kappa_over_mu")
COMPONENTS = ("xi", "eta", "chi")


@overload
def batch(
    cases: Cases,
    theory: str | _creepage.Theory | _creepage.Table | None = None,
    *,
    case: Case | None = None,
    client: Client | None = None,
    parts: int = 256,
    out: Out,
    **options: Any,
) -> Path: ...
@overload
def batch(
    cases: Cases,
    theory: str | _creepage.Theory | _creepage.Table | None = None,
    *,
    case: Case | None = None,
    client: Client | None = None,
    parts: int = 256,
    **options: Any,
) -> pd.DataFrame: ...
@overload
def batch(
    cases: pl.DataFrame,
    theory: str | _creepage.Theory | _creepage.Table | None = None,
    *,
    case: Case | None = None,
    **options: Any,
) -> pl.DataFrame: ...
@overload
def batch(
    cases: _creepage.Theory,
    theory: Cases,
    *,
    client: Client | None = None,
    parts: int = 256,
) -> pd.DataFrame: ...
@overload
def batch(
    cases: _creepage.Theory,
    theory: Cases,
    *,
    client: Client | None = None,
    parts: int = 256,
    out: Out,
) -> Path: ...
def batch(
    cases: Cases | pl.DataFrame | _creepage.Theory,
    theory: str | _creepage.Theory | _creepage.Table | Cases | None = None,
    *,
    case: Case | None = None,
    client: Client | None = None,
    parts: int = 256,
    out: Out | None = None,
    **options: Any,
) -> pd.DataFrame | pl.DataFrame | Path:
    """Solves the cases of a table, a row a case; gives the table with the answers appended.

    cases: a frame of pandas or polars, or a mapping of arrays of one length (for pandas). Its
    columns are `a_over_b`, `poisson`, `xi`, `eta`, `chi` and, if need be, `kappa_over_mu`.
    Creepages that are left out are zero. With `case`, a Case, the rows are in SI units. Columns are
    then `longitudinal`, `lateral`, `spin`, `normal_force`, `friction`, radii, semi-axes, `speed`,
    as of `Case.force`. What has no column is the case's. theory: by name with its options, a Table,
    or a prepared theory, whose contact all rows then have. With `case` its own is taken if none is
    given. A prepared theory may also stand first.

    Appended are fx, fy, mz, error bars where the theory has them, status and message, as by the
    command `creepage batch`. With `case` longitudinal_n, lateral_n, moment_n_m and the frictional
    power come first. A case with `damage` has wear and fatigue numbers too. Index and columns of
    the frame are kept. A row that is no case, such as one with NaN, has NaN, the status "invalid",
    and the reason for a message.

    client: a `dask.distributed.Client`, on whose workers the parts are solved; where a worker dies,
    its part is solved elsewhere. Without a client they are solved here, to the same numbers. parts:
    into how many pieces of work, and files. out: a folder, which gets a Parquet file a part, and
    whose path is the answer; workers must see it too. It is new or empty, or that of the same cases
    and theory in as many parts, of which then the missing ones are solved. One run at a time writes
    to it.

    Needs pandas or polars, and pyarrow for files. Raises ValueError for columns that are missing, or
    that would be appended and are there already; UnknownTheory; FileExistsError for a folder that
    holds anything else.
    """
    rows: Any = cases
    by: Any = theory
    if isinstance(cases, _creepage.Theory):
        rows, by = theory, cases
    question = _question(by, case, options)
    if type(rows).__module__.partition(".")[0] == "polars":
        return _polars(question, rows)
    import pandas as pd

    table = pd.DataFrame(rows)
    check(question, list(table.columns))
    pieces = [(question, table.iloc[first:end]) for first, end in ranges(len(table), parts)]
    if out is None and client is None:
        return solve(question, table)
    if out is None:
        return frame(solve, pieces, client, keep_index=True)
    return files(solve, pieces, client, out, _digest(question, table))


Question: TypeAlias = tuple[str, dict[str, Any], Any, Any, dict[str, float]]
"""A theory's name and options, a table, the data of a case, and what all rows share."""


def _question(
    theory: str | _creepage.Theory | _creepage.Table | None,
    case: Case | None,
    options: dict[str, Any],
) -> Question:
    data = None if case is None else case._data
    if isinstance(theory, _creepage.Table):
        if options:
            raise TypeError(f"a table has no options, such as {next(iter(options))!r}")
        axes = (("a_over_b", theory.a_over_b), ("poisson", theory.poisson))
        return "exact", {}, theory, data, {name: low for name, (low, high) in axes if low == high}
    if isinstance(theory, _creepage.Theory):
        if options or case is not None:
            raise TypeError("a prepared theory takes neither options nor a case: give its name")
        own: dict[str, Any] = dict(theory.__getnewargs_ex__()[1])
        shared = {name: own.pop(name) for name in CONTACT if name in own}
        return theory.name, own, None, None, shared
    if data is not None:
        return *chosen(data, theory, options), None, data, {}
    if theory is None:
        raise TypeError("batch() needs a theory, or a case")
    find(theory)
    return theory, options, None, None, {}


def check(question: Question, columns: list[Any]) -> None:
    """Raises ValueError where columns are missing or would be written twice."""
    *_, data, shared = question
    given = [name for name in QUANTITIES if name in columns]
    if data is not None and not given:
        raise ValueError(f"none of the columns differs from the case: {', '.join(QUANTITIES)}")
    if data is None:
        if not set(COMPONENTS) & set(columns):
            raise ValueError("cases have none of the columns xi, eta, chi")
        for name in ("a_over_b", "poisson"):
            if name not in columns and name not in shared:
                raise ValueError(f"column {name!r} is missing")
        fixed = [name for name in CONTACT if name in columns and name in shared]
        if fixed and question[2] is None:
            raise ValueError(
                f"cases have a column {fixed[0]!r}, but the theory is prepared for one contact: "
                "give its name"
            )
    ours = [*COLUMNS.values(), *data.damage_columns] if data is not None else []
    for name in (*ours, "fx", "fy", "mz", "fx_error", "fy_error", "mz_error", "status", "message"):
        if name in columns:
            raise ValueError(f"column {name!r} is there already: it is one of those to be appended")


def answers(question: Question, column: Any, columns: list[Any]) -> dict[str, Any]:
    """The columns to append; `column` gives one by its name."""
    name, options, table, data, shared = question
    if data is not None:
        quantities = {key: floats(column(key), key) for key in QUANTITIES if key in columns}
        found = _creepage.case_forces(data, name, options, table, quantities)
    else:
        usual = {"kappa_over_mu": 0.0, "xi": 0.0, "eta": 0.0, "chi": 0.0, **shared}
        rows = [
            floats(column(key), key) if key in columns else usual[key]
            for key in (*CONTACT, *COMPONENTS)
        ]
        found = _creepage.row_forces(name, options, table, rows)
    messages, codes = dict(found.pop("messages")), found.pop("status")
    renamed = {COLUMNS.get(key, key): value for key, value in found.items()}
    return {**renamed, **words(codes, messages)}


def floats(column: Any, name: str) -> np.ndarray[Any, np.dtype[np.float64]]:
    """A column as numbers; what is missing is NaN, and a flat radius infinite."""
    if np.ma.is_masked(column):
        column = np.ma.filled(np.ma.asarray(column, dtype=np.float64), np.nan)
    array = np.asarray(column)
    if array.dtype == object or array.dtype.kind in "US":
        numbers = [np.inf if value == "flat" else _float(value, name) for value in array.tolist()]
        return np.array(numbers, dtype=np.float64)
    return np.ascontiguousarray(array, dtype=np.float64)


def _float(value: object, name: str) -> float:
    if value is None or type(value).__name__ == "NAType":
        return np.nan
    if isinstance(value, (int, float, np.number)):
        return float(value)
    raise TypeError(f"column {name!r} must hold numbers, not {value!r}")


def solve(question: Question, cases: pd.DataFrame) -> pd.DataFrame:
    """One part."""
    found = answers(question, lambda name: cases[name], list(cases.columns))
    return cases.assign(**found)


def _polars(question: Question, cases: pl.DataFrame) -> pl.DataFrame:
    import polars as pl

    check(question, cases.columns)
    found = answers(question, lambda name: cases[name].to_numpy(), cases.columns)
    text = {name: found[name].tolist() for name in ("status", "message")}
    return cases.with_columns([pl.Series(name, v) for name, v in {**found, **text}.items()])


def _digest(question: Question, cases: pd.DataFrame) -> Iterator[bytes]:
    """All that the answer depends on."""
    import pandas as pd

    name, options, table, data, shared = question
    case = "" if data is None else data.text
    yield from (b"batch", repr((name, options, table, shared)).encode(), case.encode())
    for column, values in cases.items():
        yield f"{column!r} {values.dtype}".encode()
        yield pd.util.hash_pandas_object(values, index=False).to_numpy().tobytes()
