"""What can be wrong with a question."""

from __future__ import annotations


class CreepageError(Exception):
    """All exceptions of this package."""

    def __str__(self) -> str:
        return str(self.args[0])


class InvalidValue(CreepageError, ValueError):
    """A number outside the range in which a theory is defined."""

    def __init__(
        self,
        message: str,
        quantity: str,
        value: float,
        valid: str,
        index: tuple[int, ...] | None = None,
    ) -> None:
        super().__init__(message, quantity, value, valid, index)
        self.quantity = quantity
        """Its name, as in the function's signature."""
        self.value = value
        self.valid = valid
        """What the value must be, in words that follow "it must be"."""
        self.index = index
        """Where it stands in the arrays, once broadcast; None for a float."""


class InvalidOption(CreepageError, ValueError):
    """An option of a theory that means nothing to it."""

    def __init__(self, message: str, option: str) -> None:
        super().__init__(message, option)
        self.option = option


class UnknownTheory(CreepageError, ValueError):
    """A name that no theory has."""

    def __init__(self, message: str, name: str) -> None:
        super().__init__(message, name)
        self.name = name


class CaseError(CreepageError, ValueError):
    """A case, statics or sweep file that is none; the message names section and key."""

    def __init__(
        self,
        message: str,
        section: str | None = None,
        key: str | None = None,
        value: float | None = None,
    ) -> None:
        super().__init__(message, section, key, value)
        self.section = section
        self.key = key
        self.value = value


class NotReachable(CreepageError, ValueError):
    """No creepage gives the wanted force."""

    def __init__(
        self,
        message: str,
        nearest: tuple[float, float, float],
        at: tuple[float, float, float],
    ) -> None:
        super().__init__(message, nearest, at)
        self.nearest = nearest
        """The force (fx, fy, mz) that came nearest."""
        self.at = at
        """Its creepage (xi, eta, chi)."""


class TableError(CreepageError, ValueError):
    """A file that is no table of creep force or is damaged, a theory of which there is none."""


class UnlikeBodiesWarning(UserWarning):
    """Bodies whose difference matters to the force, and a theory that leaves it out."""


class AccuracyWarning(UserWarning):
    """Error bars above the accuracy that was asked for, at the finest resolution."""


class UnitsWarning(UserWarning):
    """A number that looks like one in another unit, such as MPa for Pa or degrees for radians."""
