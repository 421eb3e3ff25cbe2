"""What is refused, and why: every message names the variable, its value and what is admitted."""

from __future__ import annotations

import operator
from typing import Any

__all__ = [
    "BadValueError",
    "ContactError",
    "ContactWarning",
    "NoDerivativeError",
    "ProfileError",
    "UnknownVariableError",
]


class ContactError(ValueError):
    """Something is refused.

    Attributes
    ----------
    variable : str or None
        FMI name of the variable at fault, such as ``wheel.nominal_radius``.
    row : int or None
        Row of the broadcast arrays, counted in C order from 0, if it is about one of them.
    """

    variable: str | None
    row: int | None

    def __init__(
        self, message: str, *, variable: str | None = None, row: int | None = None
    ) -> None:
        super().__init__(message if row is None else f"row {row}: {message}")
        self.variable = variable
        self.row = row
        self._message = message

    def __reduce__(self) -> tuple[object, ...]:
        # Errors cross processes under Dask.
        return _rebuilt, (type(self), self._message, self.variable, self.row)


def _rebuilt(
    kind: type[ContactError], message: str, variable: str | None, row: int | None
) -> ContactError:
    return kind(message, variable=variable, row=row)


class BadValueError(ContactError):
    """A value outside what is admitted, or of the wrong type."""


class UnknownVariableError(ContactError):
    """A name that no variable has; the message names the nearest one."""


class ProfileError(ContactError):
    """A profile that cannot be found, read or used."""


class NoDerivativeError(ContactError):
    """Derivatives that there are none of: with these models, or at this input."""


class ContactWarning(UserWarning):
    """Nothing that is refused, but worth knowing before wondering at the forces."""


def admitted_count(name: str, value: Any, least: int, greatest: int | None = None) -> int:
    """The value as a whole number within its bounds."""
    count: int | None = None
    if hasattr(value, "__index__"):
        count = operator.index(value)
    if count is None or count < least or (greatest is not None and count > greatest):
        range_of = f"at least {least}" if greatest is None else f"{least} to {greatest}"
        raise BadValueError(
            f"{name} = {value!r} is not admitted: a whole number, {range_of}", variable=name
        )
    return count
