"""What goes in: wings, campaigns, corrections, aircraft, effects. Each stands in a file, as for the command line."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, Union, overload

from . import _wingroot
from ._tables import Table, as_table, csv, plain, read_table

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

AnyPath = Union[str, "os.PathLike[str]"]


class StateSpace(NamedTuple):
    """x' = A x + B u, y = C x + D u: `control.ss(*system[:4])` and `scipy.signal.StateSpace(*system[:4])` go on with it.

    States: modal displacements and velocities, deflections and their rates, lags of the air.
    """

    A: NDArray
    B: NDArray
    C: NDArray
    D: NDArray
    inputs: list[str]
    """Names with units; `one` is 1 at all times (camber, pressure offsets, weight)."""
    outputs: list[str]


class _File:
    """Something that stands in a file; `_keep` holds the temporary folder it may stand in."""

    def __init__(self, path: AnyPath, _keep: object = None) -> None:
        self.path = Path(path)
        self._keep = _keep

    def __fspath__(self) -> str:
        return os.fspath(self.path)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({os.fspath(self.path)!r})"


def _folder(folder: AnyPath | None) -> tuple[Path, object]:
    """The folder named, or a temporary one with what keeps it."""
    if folder is not None:
        Path(folder).mkdir(parents=True, exist_ok=True)
        return Path(folder), None
    from tempfile import TemporaryDirectory

    temporary = TemporaryDirectory(prefix="wingroot-")
    return Path(temporary.name), temporary


class Effects(Sequence[dict]):
    """Effects beyond the model, each a dictionary with `name`, `parameters` and more, as in a wing's file."""

    def __init__(self, effects: Iterable[Mapping[str, Any]] = ()) -> None:
        self._effects = [dict(effect) for effect in effects]

    @staticmethod
    def library(controls: Iterable[str] = ()) -> Table:
        """All effects that the simulator carries, for a wing with these control surfaces: a row a parameter."""
        rows = [
            {"name": effect["name"], "form": effect["form"], "title": effect["title"], "parameter": parameter}
            | dict(zip(("lower", "upper", "plausible"), bounds))
            for effect in _wingroot.effect_library(list(controls))
            for parameter, bounds in effect["parameters"].items()
        ]
        return as_table({name: [row[name] for row in rows] for name in rows[0]})

    @overload
    def __getitem__(self, index: int) -> dict: ...
    @overload
    def __getitem__(self, index: slice) -> list[dict]: ...
    def __getitem__(self, index):
        return self._effects[index]

    def __len__(self) -> int:
        return len(self._effects)

    def __repr__(self) -> str:
        return f"Effects({self._effects!r})"


class Wing(_File):
    """A wing: the file that describes it (checked when it is read), and its matrices (made when they are asked for)."""

    def __init__(self, path: AnyPath, _keep: object = None) -> None:
        super().__init__(path, _keep)
        self.name, self.hash, self._content = _wingroot.read_wing(os.fspath(path))

    @classmethod
    def from_dict(cls, data: Mapping[str, Any], folder: AnyPath | None = None, base: AnyPath = ".") -> Wing:
        """A wing from the fields of its file, as `to_dict` gives them.

        It is written to `folder/wing.ron` (left out: a temporary folder that lives as long as the wing). Files that it
        names (section, beam table) are looked for from `base`, for a changed wing its `path.parent`, and copied beside
        it; a deck is named by its absolute path.
        """
        where, keep = _folder(folder)
        _wingroot.write_wing(plain(data), os.fspath(base), os.fspath(where / "wing.ron"))
        return cls(where / "wing.ron", keep)

    def to_dict(self) -> dict[str, Any]:
        """The fields of its file, defaults filled in; a choice is its name, or {name: content}."""
        from copy import deepcopy

        return deepcopy(self._content)

    @property
    def effects(self) -> Effects:
        """The effects of its file."""
        return Effects(self.to_dict()["effects"])

    def with_effects(self, effects: Iterable[Mapping[str, Any]], folder: AnyPath | None = None) -> Wing:
        """The same wing with these effects instead."""
        return Wing.from_dict(self._content | {"effects": list(effects)}, folder, self.path.parent)

    @cached_property
    def _model(self) -> _wingroot.Model:
        return _wingroot.Model(os.fspath(self.path))

    @cached_property
    def boxes(self) -> dict[str, NDArray]:
        """The boxes, chordwise first: `id`, `corners_m`, `normal`, `area_m2`, `correctable` (places of those with
        corrections), `qjj` (pressure coefficients per incidence), `w2gj_rad` (camber and twist)."""
        return self._model.boxes()

    @property
    def aic(self) -> NDArray:
        """Pressure coefficients of all boxes per incidence (rad) of each: the inverse of the influence matrix."""
        return self.boxes["qjj"]

    @cached_property
    def _matrices(self) -> tuple:
        found = self._model.stiffness_and_mass()
        if found is None:
            raise ValueError(f"{self.name} is rigid: it has neither stiffness nor mass")
        return found

    @property
    def stiffness(self) -> Any:
        """K of the free degrees of freedom, N/m and N m/rad: a `scipy.sparse.csc_array`, without scipy its three arrays."""
        return _csc(self._matrices[0])

    @property
    def mass(self) -> Any:
        """M of the free degrees of freedom, kg: as `stiffness`."""
        return _csc(self._matrices[1])

    @property
    def free(self) -> list[tuple[int, int]]:
        """Grid and component (1 to 6) of each row of `stiffness` and `mass`."""
        return self._matrices[2]

    def modes(self, count: int = 20) -> dict[str, NDArray]:
        """Natural modes: `omega_rad_s`, `modes` (unit generalised mass; six rows a grid, a column a mode), `grid_id`,
        `grid_m`, `box_modes`. Fewer than `count` if the structure has fewer."""
        found = self._model.structure(count)
        if found is None:
            raise ValueError(f"{self.name} is rigid: it has no modes")
        return found

    @overload
    def state_space(self, V_m_s: float, rho_kg_m3: float, corrections: Corrections | AnyPath | None = None) -> StateSpace: ...
    @overload
    def state_space(
        self, V_m_s: Sequence[float], rho_kg_m3: float, corrections: Corrections | AnyPath | None = None
    ) -> list[StateSpace]: ...
    def state_space(self, V_m_s, rho_kg_m3, corrections=None):
        """The linear system on the balance that `simulate` flies at an airspeed, or a list of them at several (which
        share what takes longest); without corrections that of theory. The wing's effects are not in it."""
        several = hasattr(V_m_s, "__len__")
        speeds = [float(v) for v in V_m_s] if several else [float(V_m_s)]
        file = None if corrections is None else os.fspath(corrections)
        systems = [StateSpace(**system) for system in self._model.state_spaces(speeds, rho_kg_m3, file)]
        return systems if several else systems[0]


def _csc(parts: tuple) -> Any:
    try:
        from scipy.sparse import csc_array
    except ImportError:
        return parts
    size = len(parts[2]) - 1
    return csc_array(parts, shape=(size, size))


class Campaign(_File):
    """A folder of measurements: `campaign.ron`, static points and runs; checked when it is read."""

    def __init__(self, folder: AnyPath, _keep: object = None) -> None:
        super().__init__(folder, _keep)
        self._content = _wingroot.read_campaign(os.fspath(folder))
        self.name: str = self._content["name"]
        self.rho_kg_m3: float = self._content["rho_kg_m3"]

    @classmethod
    def from_dict(
        cls, data: Mapping[str, Any], static: Any, runs: Mapping[str, Any] | None = None, folder: AnyPath | None = None
    ) -> Campaign:
        """A campaign from the fields of its file and tables (data frames, dictionaries of columns).

        `static` has the columns `V_m_s,alpha_deg,Fz_N,Mx_Nm,My_Nm` and optionally more; `runs` holds a table for each
        file that `data["runs"]` names. Written to `folder`, or a temporary one.
        """
        where, keep = _folder(folder)
        content = {"static_cases": "static.csv"} | plain(data)
        _wingroot.write_campaign(content, os.fspath(where / "campaign.ron"))
        for name, table in {content["static_cases"]: static, **(runs or {})}.items():
            (where / name).write_text(csv(table), encoding="utf-8")
        return cls(where, keep)

    def to_dict(self) -> dict[str, Any]:
        """The fields of `campaign.ron`."""
        from copy import deepcopy

        return deepcopy(self._content)

    @property
    def static(self) -> Table:
        """The static points."""
        return read_table(self.path / self._content["static_cases"])

    @property
    def runs(self) -> list[str]:
        """Files of the runs."""
        return [run["file"] for run in self._content["runs"]]

    def run(self, file: str) -> Table:
        """A run."""
        return read_table(self.path / file)


class Corrections(_File):
    """Corrections by airspeed of the boxes `Wing.boxes["correctable"]`: a row an airspeed, a column a box."""

    def __init__(self, path: AnyPath, _keep: object = None) -> None:
        super().__init__(path, _keep)
        read = _wingroot.read_corrections(os.fspath(path))
        self.wing: str = read["wing"]
        self.wing_hash: str = read["wing_hash"]
        self.V_m_s: NDArray = read["V_m_s"]
        self.force: NDArray = read["force"]
        """Factors of the lift; 1 is theory."""
        self.moment: NDArray = read["moment"]
        """Factors of the moment about the box's midpoint; 1 is theory."""
        self.pressure_offset: NDArray = read["pressure_offset"]
        """Added to the pressure coefficient; 0 is theory."""

    @classmethod
    def from_arrays(
        cls,
        wing: Wing,
        V_m_s: ArrayLike,
        force: ArrayLike,
        moment: ArrayLike,
        pressure_offset: ArrayLike,
        path: AnyPath | None = None,
    ) -> Corrections:
        """Corrections of one's own for a wing, written to `path` or a temporary file; airspeeds ascend."""
        import numpy

        speeds = numpy.asarray(V_m_s, dtype=float)
        families = [numpy.asarray(family, dtype=float) for family in (force, moment, pressure_offset)]
        shape = (len(speeds), len(wing.boxes["correctable"]))
        if any(family.shape != shape for family in families):
            raise ValueError(f"force, moment and pressure_offset have the shape {shape}: airspeeds, correctable boxes")
        keep = None
        if path is None:
            where, keep = _folder(None)
            path = where / "corrections.ron"
        _wingroot.write_corrections(os.fspath(path), (wing.name, wing.hash), speeds, families)
        return cls(path, keep)


class Aircraft(_File):
    """An aircraft's file: the wing that it names, and what stands around it."""

    def __init__(self, path: AnyPath) -> None:
        super().__init__(path)
        self.name, wing, self.correction_airspeed_m_s, self.rho_kg_m3 = _wingroot.read_aircraft(os.fspath(path))
        self.wing = Wing(wing)
