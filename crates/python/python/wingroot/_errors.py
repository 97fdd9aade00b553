"""What can go wrong."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._results import Result


class InputError(ValueError):
    """Bad input: what is wrong, where, and what to do about it.

    `file` is None if no file is meant, `line` and `column` (counted from one) if no place in it is.
    """

    def __init__(self, message: str, place: tuple[str, int, int] | None = None, hint: str | None = None) -> None:
        super().__init__(message, place, hint)
        self.message = message
        self.file, line, column = place or (None, 0, 0)
        self.line: int | None = line or None
        self.column: int | None = column or None
        self.hint = hint

    def __str__(self) -> str:
        place = ":".join(str(part) for part in (self.file, self.line, self.column) if part)
        hint = f" (hint: {self.hint})" if self.hint else ""
        return f"{place + ': ' if place else ''}{self.message}{hint}"


class ComputationError(RuntimeError):
    """A computation that could not be completed; `result` is what it has all the same, or None."""

    result: Result | None = None

    def __init__(self, message: str) -> None:
        super().__init__(message)
        self.message = message


