"""The Pazy wing's shells under a weight on its tip, large deflections, beside SOL 400 and UM/NAST of Riso and Cesnik.

The decks have no licence and are not in this repository; they are those of github.com/UM-A2SRL/AePW3-LDWG,
00_Models/01_Pazy_Technion/01_Models_GFEM, the folder that is the argument. WINGROOT names the program (default:
target/debug/wingroot). The weight of the wing acts, and the sag under it alone is taken off, as in the source.
"""

import csv
import json
import math
import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

from common import ROOT, skip

WINGROOT = os.environ.get("WINGROOT", str(ROOT / "target/debug/wingroot"))
FOLDER = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else skip("the folder 01_Models_GFEM is the argument")
SEMISPAN_M, CHORD_M, G_M_S2 = 0.55, 0.1, 9.81
MASSES_KG = (1.0, 2.0, 3.0)
# behind the trailing edge: where the equivalent beam under the same weight has the source's twist
ARM_M = 0.04


class NoAnswer(Exception):
    """What the program said."""


def number(field):
    return float(re.sub(r"(?<=[\d.])([+-]\d)", r"e\1", field.strip() or "0"))


def grids(path):
    """Places by number."""
    lines, places = path.read_text().splitlines(), {}
    for line, after in zip(lines, lines[1:] + [""]):
        if line.startswith("GRID*"):
            places[int(line[8:24])] = (number(line[40:56]), number(line[56:72]), number(after[8:24]))
        elif line.startswith("GRID"):
            places[int(line[8:16])] = tuple(number(line[k : k + 8]) for k in (24, 32, 40))
    return places


def moved(name, places, at, mass_kg):
    """Displacements of all grids, m."""
    folder = pathlib.Path(tempfile.mkdtemp())
    names = {path.name: path for path in (FOLDER / name).iterdir()}
    model, held = (next(path for file, path in names.items() if file.startswith(start)) for start in ("fem", "bcs"))
    for path in (model, held):
        (folder / path.name).write_text(path.read_text())
    loads = ["LOAD,9,1.,1.,91" + (",1.,92" if mass_kg else ""), f"GRAV,91,,{G_M_S2},0.,0.,-1."]
    if mass_kg:
        loads.append(f"FORCE,92,{at},,{mass_kg * G_M_S2:.6g},0.,0.,-1.")
    cards = [f"include {model.name}", f"include {held.name}", "SPCADD,2000,1", *loads, "PARAM,AUTOSPC,YES", "PARAM,LGDISP,1"]
    deck = folder / "statics.bdf"
    deck.write_text("SOL 106\nCEND\nSPC = 2000\nLOAD = 9\nBEGIN BULK\n" + "\n".join(cards) + "\nENDDATA\n")
    command = [WINGROOT, "statics", "--deck", str(deck), "--nonlinear", "--quiet", "--out", str(folder / "out")]
    done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if done.returncode:
        raise NoAnswer(done.stderr.strip().splitlines()[-1])
    with (folder / "out/displacements.csv").open() as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return {int(row["grid"]): tuple(float(row[k]) for k in ("x_m", "y_m", "z_m")) for row in rows}


def nearest(places, x, y):
    return min(places, key=lambda grid: math.dist(places[grid], (x, y, 0.0)))


def between(places, values, x, y):
    """A value of the spar's plate between its four nearest grids."""
    spar = {grid: place for grid, place in places.items() if abs(place[2]) < 1e-6}
    below, above = (max((p[1] for p in spar.values() if p[1] < y)), min((p[1] for p in spar.values() if p[1] > y)))
    ends = []
    for row in (below, above):
        line = sorted((place[0], grid) for grid, place in spar.items() if abs(place[1] - row) < 1e-6)
        left = max(entry for entry in line if entry[0] <= x)
        right = min(entry for entry in line if entry[0] > x)
        share = (x - left[0]) / (right[0] - left[0])
        ends.append([(1 - share) * a + share * b for a, b in zip(values[left[1]], values[right[1]])])
    share = (y - below) / (above - below)
    return [(1 - share) * a + share * b for a, b in zip(*ends)]


def table(name, behind_m, case, columns):
    places = grids(next((FOLDER / name).glob("fem*.bdf")))
    tip_y = max(place[1] for place in places.values())
    at = nearest(places, CHORD_M + behind_m if behind_m is not None else 0.5 * CHORD_M, tip_y)
    expected = json.loads((ROOT / f"data/published/{case}.json").read_text())["expected"]
    sag = moved(name, places, at, 0.0)

    def twist_deg(values):
        # of the spar's plate: the rod that carries the weight bends for itself
        ends = [(x, between(places, values, x, SEMISPAN_M)) for x in (0.03, 0.07)]
        nose, tail = ((x + by[0], by[1], by[2]) for x, by in ends)
        return math.degrees(math.asin((nose[2] - tail[2]) / math.dist(nose, tail)))

    print(f"{name}, a weight at x = {places[at][0]:.4f} m of the tip (grid {at}); z, y in % of the semispan, twist in degrees")
    for mass_kg in MASSES_KG:
        values = moved(name, places, at, mass_kg)
        less = {grid: [a - b for a, b in zip(values[grid], sag[grid])] for grid in values}
        x, y, z = (100 * value / SEMISPAN_M for value in between(places, less, 0.5 * CHORD_M, SEMISPAN_M))
        row = lambda key: next(row for row in expected[key] if row[0] == mass_kg)
        theirs = "; ".join(f"{key} {row(key)[1:]}" for key in columns)
        print(f"  {mass_kg} kg: z {z:.3f}, y {y:.3f}, twist {twist_deg(values) - twist_deg(sag):.3f}; {theirs}")


table("01_Skin0_FlexibleTip", ARM_M, "nl_pazy__static_torsion_skin0", ["SOL400_z_y_x", "SOL400_twist_deg", "UMNAST_z_y_x"])
try:
    table("02_Skin1_FlexibleTip", None, "nl_pazy__static_bending_skin1", ["UMNAST_beam_z_y"])
except NoAnswer as said:
    print(f"with its skin (a film of 12 micrometres, which wrinkles): {said}")
print(f"processor time of all runs: {resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime:.0f} s")
