"""Sweeps: series of cases of the numerical theory of chapter 5, in chains."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, TypeAlias, overload

import numpy as np
from numpy.typing import NDArray

from . import _creepage
from ._parts import Client, Out, files, frame, ranges
from ._toml import Source, text_of

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

SweepSource: TypeAlias = Source | Mapping[str, Mapping[str, Any]]

LOOPS = ("chi", "alpha", "upsilon")


@overload
def sweep(
    source: SweepSource,
    *,
    to: Literal["pandas"] = "pandas",
    client: Client | None = None,
    parts: int = 256,
) -> pd.DataFrame: ...
@overload
def sweep(
    source: SweepSource,
    *,
    to: Literal["xarray"],
    client: Client | None = None,
    parts: int = 256,
) -> xr.Dataset: ...
@overload
def sweep(
    source: SweepSource, *, client: Client | None = None, parts: int = 256, out: Out
) -> Path: ...
def sweep(
    source: SweepSource,
    *,
    to: Literal["pandas", "xarray"] = "pandas",
    client: Client | None = None,
    parts: int = 256,
    out: Out | None = None,
) -> pd.DataFrame | xr.Dataset | Path:
    """Solves a sweep file, as `creepage sweep` does, on all cores.

    source: the path of a sweep file, its text (a string with line breaks), or its sections as a
    mapping. The columns are those of the command's CSV, a row a case; `to="xarray"` gives them
    over the dimensions chi, alpha, upsilon, or over `case` where a value occurs twice.

    client: a `dask.distributed.Client`, on whose workers the chains are solved; where a worker
    dies, its chain is solved elsewhere. The answer is the same to the last bit. parts: into how
    many pieces of work at most, and files. out: a folder, which gets a Parquet file a part, and
    whose path is the answer; workers must see it too. It is new or empty, or that of the same sweep
    in as many parts, of which then the missing ones are solved. One run at a time writes to it.

    Needs pandas; xarray, or pyarrow for files. Raises CaseError for what is no sweep, OSError for
    what cannot be read, FileExistsError for a folder that holds anything else.
    """
    if to not in ("pandas", "xarray"):
        raise ValueError(f"to = {to!r} is not valid: it must be 'pandas' or 'xarray'")
    text = text_of(source)
    data = _creepage.SweepData(text)
    # Without workers and files there is nothing to gain by parts.
    parts = 1 if client is None and out is None else parts
    pieces = [(text, first, end - first) for first, end in ranges(data.chains, parts)]
    if out is not None:
        return files(solve, pieces, client, out, [b"sweep", text.encode()])
    table = frame(solve, pieces, client)
    return table if to == "pandas" else _dataset(data, table)


def solve(text: str, first: int, count: int) -> pd.DataFrame:
    """Some chains of a sweep file."""
    import pandas as pd

    rows = csv.reader(io.StringIO(_read(text).solve(first, count).decode()))
    names = next(rows)
    return pd.DataFrame({name: _column(cells) for name, *cells in zip(names, *rows, strict=True)})


@lru_cache(maxsize=1)
def _read(text: str) -> _creepage.SweepData:
    """Read once, asked for chain after chain."""
    return _creepage.SweepData(text)


def _column(cells: list[str]) -> NDArray[Any]:
    """Counts, words, or numbers, of which the empty cells do not exist."""
    if all(cell.isdigit() for cell in cells):
        return np.array(cells).astype(np.int64)
    if cells[0].isidentifier() and cells[0] != "nan":
        return np.array(cells, dtype=object)
    return np.array([cell or "nan" for cell in cells]).astype(np.float64)


def _dataset(data: _creepage.SweepData, table: pd.DataFrame) -> xr.Dataset:
    import xarray as xr

    a_over_b, poisson, degree, mesh = data.shared
    attributes: dict[str, Any] = {
        "a_over_b": a_over_b,
        "poisson": poisson,
        "degree": degree,
        "mesh": mesh,
    }
    loops = {name: table[name].unique() for name in LOOPS}
    shape = tuple(len(values) for values in loops.values())
    # The same in all rows, as the shape and Poisson's ratio are.
    attributes["kappa_over_mu"] = float(table["kappa_over_mu"].iloc[0])
    rest = table.drop(columns=["a_over_b", "poisson", "kappa_over_mu"])
    if shape[0] * shape[1] * shape[2] != len(table):
        columns = {name: ("case", rest[name].to_numpy()) for name in rest}
        return xr.Dataset(columns, attrs=attributes)
    cubes = {
        name: (LOOPS, rest[name].to_numpy().reshape(shape)) for name in rest if name not in LOOPS
    }
    return xr.Dataset(cubes, coords=loops, attrs=attributes)
