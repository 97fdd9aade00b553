"""The commands of the program, as functions."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any, TypeVar, Union

from . import _wingroot
from ._errors import ComputationError
from ._inputs import Aircraft, AnyPath, Campaign, Corrections, Wing, _folder
from ._progress import Progress
from ._results import Calibration, CorrectedWing, Result

AnyWing = Union[Wing, AnyPath]
AnyCampaign = Union[Campaign, AnyPath, None]
AnyCorrections = Union[Corrections, AnyPath, None]
R = TypeVar("R", bound=Result)


def _words(**options: Any) -> list[str]:
    """`--name value` for each option that is set; a list gives several values, True a switch."""
    words = []
    for name, value in options.items():
        if value is None or value is False:
            continue
        option = "--" + name.replace("_", "-")
        if value is True:
            words.append(option)
        elif isinstance(value, (str, os.PathLike)) or not isinstance(value, Iterable):
            words.append(f"{option}={_word(value)}")
        elif listed := [_word(item) for item in value]:
            words += [option, *listed]
    return words


def _word(value: Any) -> str:
    if isinstance(value, (str, os.PathLike)):
        return os.fspath(value)
    return str(value.item() if hasattr(value, "item") else value)


def _run(kind: type[R], name: str, words: Sequence[str], out: AnyPath | None, progress: bool | None) -> R:
    keep = None
    if out is None:
        where, keep = _folder(None)
        out = where / name
    with Progress(progress) as tick:
        try:
            said = _wingroot.run([name, *words, f"--out={os.fspath(out)}"], tick)
        except ComputationError as error:
            incomplete = Path(out).with_name(Path(out).name + ".incomplete")
            if incomplete.is_dir():
                error.result = kind(incomplete, _keep=keep)
            raise
    return kind(out, *said, keep)


def _corrections(wing: AnyWing, campaign: AnyCampaign, corrections: AnyCorrections, progress: bool | None) -> Any:
    """Those given, or found now."""
    return calibrate(wing, campaign, progress=progress).corrections if corrections is None else corrections


def command(name: str, *words: Any, out: AnyPath | None = None, progress: bool | None = None, **options: Any) -> Result:
    """Any command that writes a folder of results: `command("deck", wing=wing, hdf5=True)`."""
    return _run(Result, name, [*map(_word, words), *_words(**options)], out, progress)


def new(folder: AnyPath, example: str = "own_wing") -> Path:
    """Makes a folder to start from: a commented wing of your own (`own_wing`), or `tuflex`, `weber_brebner`, `pazy`, `mav`."""
    _wingroot.run(["new", os.fspath(folder), "--example", example])
    return Path(folder)


def calibrate(
    wing: AnyWing, campaign: AnyCampaign = None, *, out: AnyPath | None = None, progress: bool | None = None
) -> Calibration:
    """Corrections by airspeed from a campaign's static points (left out: the campaign beside the wing)."""
    return _run(Calibration, "calibrate", _words(wing=wing, campaign=campaign), out, progress)


def simulate(
    wing: AnyWing,
    campaign: AnyCampaign = None,
    *,
    corrections: AnyCorrections = None,
    runs: Iterable[AnyPath] = (),
    maneuvers: Iterable[AnyPath] = (),
    strips: bool = False,
    without: Iterable[str] = (),
    out: AnyPath | None = None,
    progress: bool | None = None,
) -> Result:
    """Runs of the campaign (all, or the files named) and maneuvers declared in RON, flown with the initial and the updated
    model. Tables: a run's name for measured and simulated loads."""
    given = _corrections(wing, campaign, corrections, progress)
    words = _words(wing=wing, campaign=campaign, corrections=given, run=runs, maneuver=maneuvers, strips=strips)
    words += [word for effect in without for word in ("--without", effect)]
    return _run(Result, "simulate", words, out, progress)


def deflection(
    wing: AnyWing,
    campaign: AnyCampaign = None,
    *,
    corrections: AnyCorrections = None,
    out: AnyPath | None = None,
    progress: bool | None = None,
) -> CorrectedWing:
    """How much of a commanded deflection acts, from the campaign's doublets; a wing with it."""
    given = _corrections(wing, campaign, corrections, progress)
    return _run(
        CorrectedWing, "deflection", _words(wing=wing, campaign=campaign, corrections=given), out, progress
    )


def discover(
    wing: AnyWing,
    campaign: AnyCampaign = None,
    *,
    corrections: AnyCorrections = None,
    null_distribution: AnyPath | None = None,
    seed: int | None = None,
    out: AnyPath | None = None,
    progress: bool | None = None,
) -> CorrectedWing:
    """Which physical effect the model lacks, judged on held-out runs; a wing with it, calibrated again. `corrections` are
    taken to come from another campaign; left out, they are found from this one. Takes a minute or two."""
    given = _corrections(wing, campaign, corrections, progress)
    words = _words(
        wing=wing,
        campaign=campaign,
        corrections=given,
        own_corrections=corrections is None,
        null_distribution=null_distribution,
        seed=seed,
    )
    return _run(CorrectedWing, "discover", words, out, progress)


def flutter(
    wing: AnyWing,
    campaign: AnyCampaign = None,
    *,
    corrections: AnyCorrections = None,
    to_m_s: float | None = None,
    out: AnyPath | None = None,
    progress: bool | None = None,
) -> Result:
    """Flutter and divergence speeds up to `to_m_s`, initial and updated. Tables: frequency and damping over airspeed."""
    given = _corrections(wing, campaign, corrections, progress)
    words = _words(wing=wing, campaign=campaign, corrections=given, to=to_m_s)
    return _run(Result, "flutter", words, out, progress)


def modes(
    wing: AnyWing | None = None,
    *,
    deck: AnyPath | None = None,
    count: int | None = None,
    measured: AnyPath | None = None,
    out: AnyPath | None = None,
    progress: bool | None = None,
) -> Result:
    """Natural frequencies and shapes of a wing or of any Nastran deck; with measurements, their fit. (Arrays:
    `Wing.modes`.)"""
    words = _words(wing=wing, deck=deck, count=count, measured=measured)
    return _run(Result, "modes", words, out, progress)


def trim(
    aircraft: Aircraft | AnyPath | None = None,
    *,
    deck: AnyPath | None = None,
    wing: AnyWing | None = None,
    campaign: AnyCampaign = None,
    corrections: AnyCorrections = None,
    out: AnyPath | None = None,
    progress: bool | None = None,
) -> Result:
    """The aircraft in trim, pull-up, push-down, doublet, chirp and gust with both models, and its derivatives; of a
    whole-aircraft Nastran deck its trims (SOL 144)."""
    words = _words(deck=deck) if aircraft is None else _flying(aircraft, wing, campaign, corrections, progress)
    return _run(Result, "fullaircraft", words, out, progress)


def cases(
    aircraft: Aircraft | AnyPath,
    file: AnyPath,
    *,
    wing: AnyWing | None = None,
    campaign: AnyCampaign = None,
    corrections: AnyCorrections = None,
    out: AnyPath | None = None,
    progress: bool | None = None,
) -> Result:
    """A grid of airspeeds, load factors and maneuvers declared in RON, with both models. Tables: `cases`, `envelope`.
    With `out` a run that was stopped goes on when it is started again."""
    words = _flying(aircraft, wing, campaign, corrections, progress)
    return _run(Result, "fullaircraft", [*words, *_words(cases=file)], out, progress)


def _flying(
    aircraft: Aircraft | AnyPath,
    wing: AnyWing | None,
    campaign: AnyCampaign,
    corrections: AnyCorrections,
    progress: bool | None,
) -> list[str]:
    if wing is None:
        wing = (aircraft if isinstance(aircraft, Aircraft) else Aircraft(aircraft)).wing
    given = _corrections(wing, campaign, corrections, progress)
    return _words(aircraft=aircraft, wing=wing, corrections=given)


def response(data: AnyPath, *, out: AnyPath | None = None, progress: bool | None = None, **options: Any) -> Result:
    """Response surfaces of measured coefficients: `response("runs.csv", factors=["alpha", "q"], responses=["CL"],
    blocks=["day"])`. Options are those of `wingroot response --help`, with `_` for `-`."""
    listed = ("factors", "responses", "blocks", "terms", "effects", "effect_blocks", "model")
    joined = {name: ",".join(value) if name in listed and not isinstance(value, str) else value for name, value in options.items()}
    return _run(Result, "response", _words(data=data, **joined), out, progress)
