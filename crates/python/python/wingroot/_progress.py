"""Progress by tqdm, where it is installed and somebody looks."""

from __future__ import annotations

import sys
from importlib import import_module
from importlib.util import find_spec
from typing import Any, Callable


class Progress:
    """A context that gives what a command calls with what it does, steps done, and all steps; None if nothing is shown."""

    def __init__(self, shown: bool | None) -> None:
        self._wanted = (sys.stderr is not None and sys.stderr.isatty()) or "ipykernel" in sys.modules if shown is None else shown
        self._bar: Any = None
        self._doing: tuple[str, int] | None = None

    def __enter__(self) -> Callable[[str, int, int], None] | None:
        return self._tick if self._wanted and find_spec("tqdm") else None

    def _tick(self, what: str, done: int, total: int) -> None:
        if self._doing != (what, total):
            # Bars of notebooks need their widgets; without them tqdm would complain.
            tqdm = import_module("tqdm.auto" if find_spec("ipywidgets") else "tqdm").tqdm
            self.__exit__()
            self._doing = (what, total)
            self._bar = tqdm(desc=what, total=total, leave=False)
        self._bar.update(done - self._bar.n)

    def __exit__(self, *_: object) -> None:
        if self._bar is not None:
            self._bar.close()
            self._bar = None
