"""Calibrates an aeroelastic wing from loads measured at its root, finds what its model lacks, and flies it.

    import wingroot

    wing = wingroot.Wing("wing.ron")
    found = wingroot.calibrate(wing, wingroot.Campaign("campaign"))
    print(found)                      # the table that the command line prints
    found.corrections.force           # factors by airspeed and box
    wing.state_space(20.0, 1.2, found.corrections)   # A, B, C, D

Functions run the commands of the program `wingroot` in this process, with the same digits. Lengths are in metres, forces in
newtons, angles in the unit their names end with; axes are x aft, y to the right tip, z up.
"""

from ._commands import (
    calibrate,
    cases,
    command,
    deflection,
    discover,
    flutter,
    modes,
    new,
    response,
    simulate,
    trim,
)
from ._errors import ComputationError, InputError
from ._inputs import Aircraft, Campaign, Corrections, Effects, StateSpace, Wing
from ._results import CorrectedWing, Calibration, Result
from ._wingroot import VERSION, __version__

__all__ = [
    "Aircraft",
    "Calibration",
    "Campaign",
    "ComputationError",
    "CorrectedWing",
    "Corrections",
    "Effects",
    "InputError",
    "Result",
    "StateSpace",
    "VERSION",
    "Wing",
    "__version__",
    "calibrate",
    "cases",
    "command",
    "deflection",
    "discover",
    "flutter",
    "modes",
    "new",
    "response",
    "simulate",
    "trim",
]
