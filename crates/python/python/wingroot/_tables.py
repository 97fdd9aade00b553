"""Tables: pandas where it is installed, else a dictionary of numpy arrays."""

from __future__ import annotations

import os
from typing import Any, Mapping, Union

from . import _wingroot

Table = Any
"""A pandas DataFrame, or a dictionary of numpy arrays where pandas is not installed."""
Path = Union[str, "os.PathLike[str]"]


def read_table(path: Path) -> Table:
    """A CSV file as the program reads it; empty cells of columns of numbers are nan."""
    return as_table(_wingroot.read_table(os.fspath(path)))


def as_table(columns: Mapping[str, Any]) -> Table:
    """Columns as a table."""
    try:
        from pandas import DataFrame
    except ImportError:
        import numpy

        return {name: numpy.asarray(column) for name, column in columns.items()}
    return DataFrame(columns)


def csv(table: Any) -> str:
    """A table as CSV, numbers with all their digits; nothing where a number is missing."""
    import numpy

    names = list(table)
    columns = [numpy.asarray(table[name]).tolist() for name in names]
    cell = lambda value: "" if value is None or value != value else repr(value) if isinstance(value, float) else str(value)
    rows = (",".join(map(cell, row)) for row in zip(*columns, strict=True))
    return "\n".join([",".join(map(str, names)), *rows, ""])


def plain(value: Any) -> Any:
    """A value without numpy types and paths."""
    if isinstance(value, Mapping):
        return {str(key): plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    return value.tolist() if hasattr(value, "tolist") else value
