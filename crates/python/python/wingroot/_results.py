"""What comes out: the folder that a command writes, as numbers, tables and figures."""

from __future__ import annotations

import json
from functools import cached_property
from pathlib import Path
from typing import Any

from ._inputs import AnyPath, Corrections, Effects, Wing
from ._tables import Table, read_table


class Result:
    """The result of a command.

    `print(result)` shows what the command line prints, a notebook the figures. Without `out` it stands in a temporary
    folder that lives as long as this object; `save` keeps it.
    """

    def __init__(self, folder: AnyPath, summary: str = "", notes: list[str] | None = None, _keep: object = None) -> None:
        self.folder = Path(folder)
        self.summary = summary
        self.notes = notes or []
        """Remarks and warnings of the command."""
        self._keep = _keep

    @cached_property
    def data(self) -> dict[str, Any]:
        """`result.json`: numbers with units in their names; `docs/results.md` says what None means where."""
        return json.loads((self.folder / "result.json").read_text(encoding="utf-8"))

    def __getitem__(self, key: str) -> Any:
        return self.data[key]

    @property
    def tables(self) -> list[str]:
        """Names of the CSV files."""
        return self._names(".csv")

    def table(self, name: str) -> Table:
        """A CSV file, its name with or without the ending: a pandas DataFrame, or a dictionary of arrays without pandas."""
        return read_table(self._file(name, ".csv"))

    @property
    def figures(self) -> list[str]:
        """Names of the figures; each is there as SVG and PNG."""
        return self._names(".svg")

    def figure(self, name: str) -> str:
        """A figure as SVG."""
        return self._file(name, ".svg").read_text(encoding="utf-8")

    @property
    def report(self) -> Path:
        """The page with all numbers and figures, for a browser."""
        return self.folder / "report.html"

    def save(self, folder: AnyPath) -> Path:
        """Copies everything to a new folder."""
        from shutil import copytree

        return Path(copytree(self.folder, folder))

    def _names(self, ending: str) -> list[str]:
        found = sorted(self.folder.rglob("*" + ending))
        return [path.relative_to(self.folder).with_suffix("").as_posix() for path in found]

    def _file(self, name: str, ending: str) -> Path:
        path = self.folder / (name if name.endswith(ending) else name + ending)
        if not path.is_file():
            raise KeyError(f"there is no {name}; there is {', '.join(self._names(ending))}")
        return path

    def __str__(self) -> str:
        return "\n".join([self.summary, *(f"note: {note}" for note in self.notes)])

    def __repr__(self) -> str:
        return f"<wingroot result of {self.data.get('command', self.folder.name)}: {', '.join(self.data)}>"

    def _repr_html_(self) -> str:
        from base64 import b64encode
        from html import escape

        def image(name: str) -> str:
            svg = b64encode(self.figure(name).encode()).decode()
            return f'<img alt="{escape(name)}" title="{escape(name)}" src="data:image/svg+xml;base64,{svg}">'

        return f"<pre>{escape(str(self))}</pre>" + "".join(map(image, self.figures))


class Calibration(Result):
    """The result of `calibrate`."""

    @cached_property
    def corrections(self) -> Corrections:
        """The corrections found."""
        return Corrections(self.folder / "corrections.ron", self)


class CorrectedWing(Calibration):
    """The result of `deflection` and `discover`: a wing with what was found, and its corrections."""

    @cached_property
    def wing(self) -> Wing:
        """The wing with what was found."""
        return Wing(self.folder / "wing.ron", self)

    @property
    def effects(self) -> Effects:
        """The effects found (and those that were there)."""
        return self.wing.effects
