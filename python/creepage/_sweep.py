"""Sweeps: series of cases of the numerical theory of chapter 5, in chains."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeAlias, overload

import numpy as np
from numpy.typing import NDArray

from . import _creepage
from ._toml import Source, text_of

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

SweepSource: TypeAlias = Source | Mapping[str, Mapping[str, Any]]

LOOPS = ("chi", "alpha", "upsilon")


@overload
def sweep(source: SweepSource, *, to: Literal["pandas"] = "pandas") -> pd.DataFrame: ...
@overload
def sweep(source: SweepSource, *, to: Literal["xarray"]) -> xr.Dataset: ...
def sweep(
    source: SweepSource, *, to: Literal["pandas", "xarray"] = "pandas"
) -> pd.DataFrame | xr.Dataset:
    """Solves a sweep file, as `creepage sweep` does, on all cores.

    source: the path of a sweep file, its text (a string with line breaks), or its sections as a
    mapping. The columns are those of the command's CSV, a row a case; `to="xarray"` gives them
    over the dimensions chi, alpha, upsilon, or over `case` where a value occurs twice. Needs
    pandas, or xarray. Raises CaseError for what is no sweep, OSError for what cannot be read.
    """
    data = _creepage.SweepData(text_of(source))
    if to == "pandas":
        return _frame(data)
    if to == "xarray":
        return _dataset(data)
    raise ValueError(f"to = {to!r} is not valid: it must be 'pandas' or 'xarray'")


def _frame(data: _creepage.SweepData) -> pd.DataFrame:
    import pandas as pd

    rows = csv.reader(io.StringIO(data.solve(0, data.chains).decode()))
    names = next(rows)
    return pd.DataFrame({name: _column(cells) for name, *cells in zip(names, *rows, strict=True)})


def _column(cells: list[str]) -> NDArray[Any]:
    """Counts, words, or numbers, of which the empty cells do not exist."""
    if all(cell.isdigit() for cell in cells):
        return np.array(cells).astype(np.int64)
    if cells[0].isidentifier() and cells[0] != "nan":
        return np.array(cells, dtype=object)
    return np.array([cell or "nan" for cell in cells]).astype(np.float64)


def _dataset(data: _creepage.SweepData) -> xr.Dataset:
    import xarray as xr

    frame = _frame(data)
    a_over_b, poisson, degree, mesh = data.shared
    attributes = {"a_over_b": a_over_b, "poisson": poisson, "degree": degree, "mesh": mesh}
    loops = {name: frame[name].unique() for name in LOOPS}
    shape = tuple(len(values) for values in loops.values())
    rest = frame.drop(columns=["a_over_b", "poisson"])
    if shape[0] * shape[1] * shape[2] != len(frame):
        columns = {name: ("case", rest[name].to_numpy()) for name in rest}
        return xr.Dataset(columns, attrs=attributes)
    cubes = {
        name: (LOOPS, rest[name].to_numpy().reshape(shape)) for name in rest if name not in LOOPS
    }
    return xr.Dataset(cubes, coords=loops, attrs=attributes)
