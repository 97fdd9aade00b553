"""Flutter of random wings beside NASTRAN-95 (PyPI nastran95 0.3, Python 3.12 or newer): sweep, dihedral, taper, Mach number.

    python3.12 -m venv venv && venv/bin/pip install nastran95==0.3
    venv/bin/python tests/peers/nastran95_random_flutter.py [WINGS]

A wing is a beam of ten elements with lumped torsional inertia under 6 by 4 boxes on a beam spline; p-k with three modes.
Natural frequencies must agree within 0.5 %, roots within 1 % in frequency and 0.01 in damping g, where g is above -1 and the
frequency within the table of forces. Without the package it says so and ends well.
"""

import math
import random
import re
import subprocess
import sys
import tempfile

from common import ROOT, Comparison, skip

try:
    import nastran95
except ImportError:
    skip("nastran95 is not installed")

K = [0.001, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.6]
MODES = 3


def card(*fields):
    """A card in fields of eight characters."""
    lines = [fields[i:i + 8] for i in range(1, len(fields), 8)]
    text = ""
    for i, line in enumerate(lines):
        head = fields[0] if i == 0 else f"+{fields[0][:2]}{fields[1]}"
        tail = f"+{fields[0][:2]}{fields[1]}" if i + 1 < len(lines) else ""
        text += f"{head:<8}" + "".join(f"{number(value):<8}" for value in line).ljust(64) + tail + "\n"
    return text


def number(value):
    """A number in at most eight characters, of which the last digit is all that is lost."""
    if not isinstance(value, float):
        return str(value)
    for digits in range(7, 0, -1):
        mantissa, exponent = f"{value:.{digits}e}".split("e")
        text = f"{mantissa}{int(exponent):+d}"
        if len(text) <= 8:
            return text
    raise ValueError(value)


def wing(rng):
    """Cards that both programs read, and the numbers beside them."""
    u = rng.uniform
    sweep, dihedral = math.radians(u(-5, 35)), math.radians(u(-10, 15))
    length, root, tip = u(5, 7), u(1.6, 2.4), u(1.0, 1.6)
    ahead = u(0.35, 0.5)
    # the axis' direction, the panel's normal, and x of the axis' system
    y = [math.sin(sweep), math.cos(sweep) * math.cos(dihedral), math.cos(sweep) * math.sin(dihedral)]
    z = [0.0, -math.sin(dihedral), math.cos(dihedral)]
    x = [y[1] * z[2] - y[2] * z[1], y[2] * z[0] - y[0] * z[2], y[0] * z[1] - y[1] * z[0]]
    end = [length * c for c in y]
    deck = card("CORD2R", 1, "", 0.0, 0.0, 0.0, *z, *x)
    deck += card("MAT1", 1, 10.4e6, 3.9e6, "", 2.61e-4)
    bending, torsion = u(0.7, 1.3) * 9.83e-6, u(0.7, 1.3) * 36.8e-6
    deck += card("PBAR", 1, 1, 7.175e-2, bending, bending, torsion)
    deck += card("PARAM", "COUPMASS", 1)
    deck += card("PAERO1", 1)
    deck += card("CAERO1", 101, 1, 0, 6, 4, "", "", 1, -ahead * root, 0.0, 0.0, root,
                 end[0] - ahead * tip, end[1], end[2], tip)
    inertia = u(2.0, 3.5) * 1e-6
    for i in range(1, 12):
        held = 123456 if i == 1 else 126
        deck += card("GRID", i, 1, 0.0, length * (i - 1) / 10, 0.0, 1, held)
        if i > 1:
            deck += card("CBAR", i - 1, 1, i - 1, i, 0.0, 0.0, 1.0)
            deck += card("CMASS2", 10 + i, inertia / (2 if i == 11 else 1), i, 5)
    chord = (root + tip) / 2
    return deck, chord, rng.choice([0.1, 0.3, 0.5]), rng.uniform(0.8, 1.2) * 1.1e-7


def theirs(deck, chord, mach, rho, speeds):
    """Natural frequencies and roots as NASTRAN-95 prints them: {(airspeed, point): (g, Hz)}."""
    text = "ID WING,FLUTTER\nAPP AERO\nSOL 10,0\nTIME 10\nCEND\nTITLE = WING\nSPC = 1\nMETHOD = 10\nCMETHOD = 20\n"
    text += "FMETHOD = 30\nBEGIN BULK\n" + deck
    text += card("AERO", 0, 1.3e4, chord, rho)
    text += card("EIGC", 20, "HESS", "MAX", "", "", "", "", "", "", "", "", "", "", "", MODES)
    text += card("EIGR", 10, "GIV", 0.3, 0.1, "", MODES, "", "", "MAX")
    text += card("FLFACT", 1, 1.0) + card("FLFACT", 2, mach)
    text += "".join(card("FLFACT", 4, *speeds)) + card("FLUTTER", 30, "PK", 1, 2, 4, "L", MODES)
    text += card("MKAERO1", mach, "", "", "", "", "", "", "", *K)
    text += card("PARAM", "LMODES", MODES)
    text += card("SET1", 100, 1, "THRU", 11) + card("SPC1", 1, 345, 1)
    text += card("SPLINE2", 100, 101, 101, 124, 100, 0.0, 1.0, 1, 0.0, 0.0)
    result = nastran95.run("".join(f"{line:<80}\n" for line in (text + "ENDDATA\n").splitlines()))
    roots = {}
    for block in re.split(r"POINT\s*=", result.output)[1:]:
        point = int(re.match(r"\s*(\d+)", block).group(1))
        for line in block.splitlines():
            values = re.findall(r"-?\d\.\d+E[+-]\d+|-?\d+\.\d+", line)
            if len(values) == 7 and float(values[2]) in speeds:
                roots[(float(values[2]), point)] = (float(values[3]), float(values[4]), float(values[0]))
    frequencies = [] if result.eigenvalues is None else [float(hz) for hz in result.eigenvalues.frequencies[:MODES]]
    return frequencies, roots, result.output


def ours(deck, chord, mach, rho, speeds):
    """The same by `pk_of_deck`."""
    with tempfile.NamedTemporaryFile("w", suffix=".bdf") as file:
        file.write(deck)
        file.flush()
        kappa = ",".join(repr(2 * k / chord) for k in [0.0, *K])
        command = ["cargo", "run", "--quiet", "--package", "maneuver", "--example", "pk_of_deck", "--", file.name]
        command += [str(mach), str(rho), str(MODES), kappa, ",".join(map(str, speeds))]
        out = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout
    lines = [line.split(",") for line in out.splitlines()]
    frequencies = [float(value) for line in lines if line[0] == "frequency" for value in line[1:]]
    roots = {(float(line[1]), int(line[2])): (float(line[3]), float(line[4])) for line in lines if line[0] == "root"}
    return frequencies, roots


def main():
    """Compares wing by wing."""
    comparison = Comparison()
    for seed in range(int(sys.argv[1]) if len(sys.argv) > 1 else 5):
        rng = random.Random(seed)
        deck, chord, mach, rho = wing(rng)
        speeds = [3000.0, 4500.0, 6000.0, 7000.0, 8000.0]
        peer_hz, peer, output = theirs(deck, chord, mach, rho, speeds)
        if not peer:
            print(output[-3000:])
            sys.exit(f"wing {seed}: NASTRAN-95 prints no roots")
        hz, roots = ours(deck, chord, mach, rho, speeds)
        for mode, (a, b) in enumerate(zip(hz, peer_hz)):
            comparison.close(f"wing {seed} mode {mode + 1} (Hz)", a, b, 0.005)
        for (speed, _), (g, f, k) in sorted(peer.items()):
            if g < -1 or not K[0] < k < K[-1]:
                continue
            # branches are numbered by each program as it followed them: the nearest root
            near = min((r for (v, _), r in roots.items() if v == speed), key=lambda r: abs(r[1] - f) + f * abs(r[0] - g))
            comparison.close(f"wing {seed} V {speed:.0f} (Hz)", near[1], f, 0.01)
            comparison.close(f"wing {seed} V {speed:.0f} 1 + g", 1 + near[0], 1 + g, 0.01 / (1 + g) if g > -0.9 else 0.1)
    comparison.end()


main()
