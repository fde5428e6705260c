"""Work in parts: here, or on the workers of a Dask client; answers in memory or in files."""

from __future__ import annotations

import importlib
import os
import uuid
from collections.abc import Callable, Iterator
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol, TypeAlias

import numpy as np

if TYPE_CHECKING:
    import pandas as pd

Out: TypeAlias = "str | os.PathLike[str]"
Solve: TypeAlias = "Callable[..., pd.DataFrame]"


class Client(Protocol):
    """What is used of a `dask.distributed.Client`."""

    def submit(self, func: Callable[..., Any], *args: Any, **kwargs: Any) -> Any: ...
    def gather(self, futures: Any) -> Any: ...


def ranges(count: int, parts: int) -> Iterator[tuple[int, int]]:
    """Cuts `count` things into at most `parts` runs of much the same length: (first, end)."""
    if parts < 1:
        raise ValueError(f"parts = {parts} is not valid: it must be at least 1")
    edges = np.linspace(0, count, min(parts, max(count, 1)) + 1).astype(int).tolist()
    return pairwise(edges)


def frame(solve: Solve, pieces: list[tuple[Any, ...]], client: Client | None) -> pd.DataFrame:
    """The tables of all pieces, one below the other."""
    import pandas as pd

    table: pd.DataFrame = pd.concat(_run(solve, pieces, client), ignore_index=True)
    return table


def files(solve: Solve, pieces: list[tuple[Any, ...]], client: Client | None, out: Out) -> Path:
    """The same as a folder of Parquet files, each written where its piece is solved."""
    importlib.import_module("pyarrow")  # that it is missing is told before the work
    folder = Path(out).absolute()
    folder.mkdir(parents=True, exist_ok=True)
    if any(folder.iterdir()):
        raise FileExistsError(f"{folder} is not empty: parts of two runs would mix")
    jobs = [
        (folder / f"part-{k:05}.parquet", solve, *piece) for k, piece in enumerate(pieces)
    ]
    _run(_write, jobs, client)
    for left in folder.glob(".*.partial"):  # of workers that died
        left.unlink(missing_ok=True)
    return folder


def _write(path: Path, solve: Solve, *piece: Any) -> None:
    """The file appears when it is whole; who writes it again writes the same."""
    partial = path.with_name(f".{path.name}.{uuid.uuid4().hex}.partial")
    solve(*piece).to_parquet(partial, engine="pyarrow", index=False)
    partial.replace(path)


def _run(
    task: Callable[..., Any], jobs: list[tuple[Any, ...]], client: Client | None
) -> list[Any]:
    if client is None:
        return [task(*job) for job in jobs]
    # One by one: each job travels by itself, and the scheduler keeps what it needs to do it again.
    futures = [
        client.submit(task, *job, key=f"creepage-{uuid.uuid4().hex}", retries=2) for job in jobs
    ]
    answers: list[Any] = client.gather(futures)
    return answers
