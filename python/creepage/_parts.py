"""Work in parts: here, or on the workers of a Dask client; answers in memory or in files."""

from __future__ import annotations

import hashlib
import importlib
import os
import uuid
from collections.abc import Callable, Iterable, Iterator
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol, TypeAlias

import numpy as np

from . import _creepage

if TYPE_CHECKING:
    import pandas as pd

Out: TypeAlias = "str | os.PathLike[str]"
Solve: TypeAlias = "Callable[..., pd.DataFrame]"

MARK = ".creepage"
"""In a folder of parts: the digest of their question. Readers pass over names with a dot."""
UNFINISHED = f"{MARK}-*.partial"


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


def frame(
    solve: Solve,
    pieces: list[tuple[Any, ...]],
    client: Client | None,
    *,
    keep_index: bool = False,
) -> pd.DataFrame:
    """The tables of all pieces, one below the other."""
    import pandas as pd

    table: pd.DataFrame = pd.concat(_run(solve, pieces, client), ignore_index=not keep_index)
    return table


def files(
    solve: Solve,
    pieces: list[tuple[Any, ...]],
    client: Client | None,
    out: Out,
    question: Iterable[bytes],
) -> Path:
    """The same as a folder of Parquet files, each written where its piece is solved.

    question: all that the answer depends on. Where the folder holds parts of the same question,
    of the same number of parts, only those are solved that are missing.
    """
    importlib.import_module("pyarrow")  # that it is missing is told before the work
    folder = Path(out).absolute()
    folder.mkdir(parents=True, exist_ok=True)
    _claim(folder, _digest(question, len(pieces)))
    paths = [folder / f"part-{k:05}.parquet" for k in range(len(pieces))]
    work = zip(paths, pieces, strict=True)
    jobs = [(path, solve, *piece) for path, piece in work if not path.exists()]
    _run(_write, jobs, client)
    for left in folder.glob(UNFINISHED):  # by workers and runs that died
        left.unlink(missing_ok=True)
    return folder


def _digest(question: Iterable[bytes], parts: int) -> str:
    """Of the question, how it is cut, and who answers it."""
    digest = hashlib.sha256(f"creepage {_creepage.__version__}, {parts} parts\n".encode())
    for piece in question:
        digest.update(f"{len(piece)}\n".encode())
        digest.update(piece)
    return digest.hexdigest()


def _claim(folder: Path, digest: str) -> None:
    """Makes the folder that of one question, or finds that it is.

    Raises FileExistsError where it holds anything else.
    """
    mark = folder / MARK
    try:
        found = mark.read_text(encoding="utf-8").strip()
    except FileNotFoundError:
        if any(not path.match(UNFINISHED) for path in folder.iterdir()):
            message = f"{folder} is not empty, and holds no parts that could be gone on with"
            raise FileExistsError(message) from None
        _appear(mark, lambda partial: partial.write_text(digest + "\n", encoding="utf-8"))
        return
    if found != digest:
        raise FileExistsError(
            f"{folder} holds parts of another run, and parts of two would mix: it is gone on with "
            "by the same cases, theory, number of parts and version of creepage"
        )


def _write(path: Path, solve: Solve, *piece: Any) -> None:
    """Who writes it again writes the same."""
    table = solve(*piece)
    _appear(path, lambda partial: table.to_parquet(partial, engine="pyarrow", index=False))


def _appear(path: Path, write: Callable[[Path], object]) -> None:
    """The file appears when it is whole and on the disk: no failure leaves a part of it."""
    partial = path.with_name(f"{MARK}-{path.name}-{uuid.uuid4().hex}.partial")
    write(partial)
    with partial.open("r+b") as file:
        os.fsync(file.fileno())
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
