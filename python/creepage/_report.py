"""What every solved problem can say and draw, and every problem that is read from a file with others
beside it."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

from ._toml import Source, dumps, read

if TYPE_CHECKING:
    from typing_extensions import Self


@dataclass(frozen=True, slots=True)
class Quantity:
    """One number of a report."""

    label: str
    """What it is, in words."""
    unit: str
    """Its SI unit; empty for a number without one."""
    value: float | None
    """The number; None if it is unknown, as the frictional power without a rolling velocity."""
    error: float | None
    """Its error bar: zero for what was given or has a closed form, None where nothing is known."""


def quantities(
    tuples: Iterable[tuple[str, str, str, float | None, float | None]],
) -> dict[str, Quantity]:
    """By their path in report.json."""
    return {
        path: Quantity(label, unit, value, error) for path, label, unit, value, error in tuples
    }


class Solved(Protocol):
    """A solution of the library."""

    def json(self) -> str: ...
    def text(self) -> str: ...
    def svg(self) -> str: ...
    def write(self, directory: str | os.PathLike[str]) -> list[str]: ...


class Reported:
    """A solution that prints, draws and saves itself as the command does."""

    __slots__ = ()
    _solved: Solved
    _again: Callable[[], Any]
    """Solves it once more, which is the same to the last bit: for pickle."""

    def __reduce__(self) -> tuple[Any, ...]:
        return _silently, (self._again,)

    def __eq__(self, other: object) -> bool:
        """The same report, to the last bit."""
        if type(other) is not type(self):
            return NotImplemented
        return self._solved.json() == other._solved.json()

    def __hash__(self) -> int:
        return hash(self._solved.json())

    def to_dict(self) -> dict[str, Any]:
        """What `report.json` holds; the names carry their units."""
        report: dict[str, Any] = json.loads(self._solved.json())
        return report

    def text(self) -> str:
        """A short report for a terminal."""
        return self._solved.text()

    def __str__(self) -> str:
        return self.text()

    def svg(self) -> str:
        """The picture of a report."""
        return self._solved.svg()

    def _repr_svg_(self) -> str:
        return self.svg()

    def save(self, directory: str | os.PathLike[str]) -> list[Path]:
        """Writes what the command writes with `--out` into a directory: report.json, and the points and
        pictures that there are. Raises OSError, FileExistsError for a file that the problem was read from."""
        return [Path(path) for path in self._solved.write(Path(directory))]


class ReportedList(Reported):
    """A solution whose every number has a path in the report."""

    __slots__ = ()

    @property
    def quantities(self) -> dict[str, Quantity]:
        """Every number of the report by its path, with label, unit and error bar; those of wheels, contacts and
        balls too, such as `left.patches.0.normal_force_n`."""
        solved: Any = self._solved
        return quantities(solved.quantities())


def _silently(again: Callable[[], Any]) -> Any:
    """What was warned of when it was solved is not warned of again."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return again()


class FromFile:
    """A problem by its file, with files of profiles or points beside it."""

    _text: str
    _directory: Path

    def _read(self, text: str, directory: Path) -> None:
        self._text, self._directory = text, directory

    @classmethod
    def from_toml(cls, source: Source, directory: str | os.PathLike[str] | None = None) -> Self:
        """From a case file: a path, or its text (a string with line breaks). Files that it names are
        looked for in directory, by default the file's own. Raises CaseError and OSError.
        """
        text = read(source)
        if directory is None:
            directory = "." if text is source else Path(source).parent
        return cls._made(text, directory)

    @classmethod
    def from_dict(
        cls, file: Mapping[str, Mapping[str, Any]], directory: str | os.PathLike[str] = "."
    ) -> Self:
        """From the sections of a case file as a mapping. Raises as from_toml."""
        return cls._made(dumps(file), directory)

    @classmethod
    def _made(cls, text: str, directory: str | os.PathLike[str]) -> Self:
        made = cls.__new__(cls)
        made._read(text, Path(directory))
        return made

    def to_toml(self) -> str:
        """The text of its file."""
        return self._text

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self).from_toml, (self._text, self._directory)

    def __eq__(self, other: object) -> bool:
        """The same file, which looks for others in the same directory."""
        if type(other) is not type(self):
            return NotImplemented
        return (self._text, self._directory) == (other._text, other._directory)

    def __hash__(self) -> int:
        return hash((self._text, self._directory))
