"""Many cases of one theory as a table, here or on the workers of a Dask client."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, overload

import numpy as np
from numpy.typing import ArrayLike

from . import _creepage
from ._parts import Client, Out, files, frame, ranges

if TYPE_CHECKING:
    import pandas as pd

COMPONENTS = ("xi", "eta", "chi")


@overload
def batch(
    theory: _creepage.Theory,
    cases: pd.DataFrame | Mapping[str, ArrayLike],
    *,
    client: Client | None = None,
    parts: int = 256,
) -> pd.DataFrame: ...
@overload
def batch(
    theory: _creepage.Theory,
    cases: pd.DataFrame | Mapping[str, ArrayLike],
    *,
    client: Client | None = None,
    parts: int = 256,
    out: Out,
) -> Path: ...
def batch(
    theory: _creepage.Theory,
    cases: pd.DataFrame | Mapping[str, ArrayLike],
    *,
    client: Client | None = None,
    parts: int = 256,
    out: Out | None = None,
) -> pd.DataFrame | Path:
    """Solves the cases of a table, a row a case.

    cases: columns `xi`, `eta`, `chi`, of which those left out are zero; a mapping of arrays of one
    length will do. Other columns pass through. The answer has the columns of the theory's force
    and its status in words beside them.

    client: a `dask.distributed.Client`, on whose workers the parts are solved, again elsewhere
    where a worker dies; without one they are solved here, to the same numbers. parts: into how
    many pieces of work, and files. out: a folder, which gets a Parquet file a part, and whose path
    is the answer; workers must see it too. It is new or empty, or that of the same cases and theory
    in as many parts, of which then the missing ones are solved. One run at a time writes to it.

    Needs pandas, and pyarrow for files. Raises what the theory's force raises, with the index in
    the part; ValueError where there is none of the three columns, FileExistsError for a folder
    that holds anything else.
    """
    import pandas as pd

    table = pd.DataFrame(cases)
    if not set(COMPONENTS) & set(table.columns):
        raise ValueError("cases have none of the columns xi, eta, chi")
    pieces = [
        (theory, table.iloc[first:end].reset_index(drop=True))
        for first, end in ranges(len(table), parts)
    ]
    if out is None:
        return frame(solve, pieces, client)
    return files(solve, pieces, client, out, _question(theory, table))


def _question(theory: _creepage.Theory, cases: pd.DataFrame) -> Iterator[bytes]:
    """All that the answer depends on."""
    import pandas as pd

    # The theory's repr has all that it was made with.
    yield from (b"batch", repr(theory).encode())
    for name, column in cases.items():
        yield f"{name!r} {column.dtype}".encode()
        yield pd.util.hash_pandas_object(column, index=False).to_numpy().tobytes()


def solve(theory: _creepage.Theory, cases: pd.DataFrame) -> pd.DataFrame:
    """One part."""
    zero = np.zeros(len(cases))
    columns = [cases[name].to_numpy() if name in cases else zero for name in COMPONENTS]
    return cases.assign(**theory.force(*columns).to_dict())
