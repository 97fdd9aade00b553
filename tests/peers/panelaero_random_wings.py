"""Influence matrices of random wings beside PanelAero 2025.8: dihedral, sweep, taper, a fin and a tail on it.

    python3 -m venv venv && venv/bin/pip install PanelAero==2025.8
    venv/bin/python tests/peers/panelaero_random_wings.py [WINGS]

Without PanelAero it says so and ends well. Kept out of the comparison, as PanelAero computes them otherwise: points less
than a thousandth of a half width off a strip's plane, and surfaces in line with each other's strip edges.
Forty wings agree to 3.4e-10 of a matrix's largest entry (its series for points beside a strip ends at the seventh term).
"""
import random
import subprocess
import sys
import tempfile

from common import panelaero_grid as grid

try:
    import numpy as np
    from panelaero import DLM, VLM
except ImportError:
    print('PanelAero is not installed: nothing compared')
    sys.exit(0)


def panel(le_1, chord_1, le_2, chord_2, spanwise, chordwise):
    """Corners of the boxes of a trapezoid, chordwise first."""
    le_1, le_2 = np.array(le_1), np.array(le_2)

    def at(s, c):
        return (1 - s) * le_1 + s * le_2 + np.array([c * ((1 - s) * chord_1 + s * chord_2), 0.0, 0.0])
    return [[at(i / spanwise, j / chordwise), at(i / spanwise, (j + 1) / chordwise),
             at((i + 1) / spanwise, (j + 1) / chordwise), at((i + 1) / spanwise, j / chordwise)]
            for i in range(spanwise) for j in range(chordwise)]


def wing(rng):
    u = rng.uniform
    root, tip, span = u(0.6, 1.5), u(0.3, 1.0), u(1.5, 4.0)
    boxes = panel([0, 0.013, 0], root, [u(-0.5, 1.5), span, u(-0.3, 0.9)], tip, rng.randint(4, 8), rng.randint(2, 4))
    top, back = u(0.9, 1.4), u(2.0, 4.0)
    boxes += panel([back, 0, 0.12], 0.6, [back + u(0, 0.5), 0, top], 0.5, 4, 3)
    boxes += panel([back, u(-1.2, -0.7), top + 0.021], 0.4, [back, u(0.7, 1.2), top + u(0.021, 0.3)], 0.35, 5, 2)
    return np.array(boxes)


def ours(c, mach, kappa, fit):
    with tempfile.NamedTemporaryFile('w', suffix='.csv') as file:
        for box in c:
            file.write(','.join(repr(float(v)) for v in box.flatten()) + '\n')
        file.flush()
        out = subprocess.run(['cargo', 'run', '--quiet', '--package', 'aero', '--example', 'dlm_matrix', '--',
                              file.name, str(mach), str(kappa), fit], check=True, capture_output=True, text=True).stdout
    rows = np.array([[float(v) for v in line.split(',')] for line in out.splitlines()])
    return rows[:, 0::2] + 1j * rows[:, 1::2]


def main():
    wings, worst = int(sys.argv[1]) if len(sys.argv) > 1 else 10, 0.0
    for seed in range(wings):
        rng = random.Random(seed)
        c = wing(rng)
        mach, kappa = rng.choice([0.0, 0.3, 0.7]), rng.uniform(0.05, 3.0)
        for fit in ['parabolic', 'quartic']:
            # Its sign is that of the downwash: w = -A cp.
            steady = -VLM.calc_Ajj(aerogrid=grid(c), Ma=mach)[0]
            theirs = steady - DLM.calc_Ajj(aerogrid=grid(c), Ma=mach, k=kappa, method=fit)
            off = np.abs(ours(c, mach, kappa, fit) - theirs) / np.abs(theirs).max()
            i, j = np.unravel_index(off.argmax(), off.shape)
            worst = max(worst, off.max())
            print(f'wing {seed}: {len(c)} boxes, Mach {mach}, omega/V {kappa:.2f}/m, {fit}: {off.max():.1e} at {i}, {j}')
    if worst > 1e-9:
        sys.exit(f'off by {worst:.1e}')


main()
