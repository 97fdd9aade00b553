"""Time of PanelAero's doublet lattice on the boxes of a CSV file: twelve numbers a line, the corners of a box.

    python3 -m venv venv && venv/bin/pip install PanelAero==2025.8
    venv/bin/python tests/peers/time_panelaero.py BOXES.csv MACH OMEGA_OVER_V...

`cargo xtask bench --peer-python venv/bin/python` runs it on its own mesh, after its own timing. Prints one line of JSON: wall seconds
of all frequencies with the inverted matrices PanelAero works with, and the process's peak memory in MB. Without PanelAero it
says so and ends well.
"""
import json
import logging
import pathlib
import sys
import time

from common import panelaero_grid, skip

try:
    import numpy as np
    from panelaero import DLM
except ImportError:
    skip('PanelAero is not installed')

logging.disable(logging.CRITICAL)
corners = np.loadtxt(sys.argv[1], delimiter=',').reshape(-1, 4, 3)
grid = panelaero_grid(corners)
mach, kappa = float(sys.argv[2]), [float(word) for word in sys.argv[3:]]
start = time.perf_counter()
DLM.calc_Qjjs(grid, [mach], np.array(kappa))
seconds = time.perf_counter() - start
# not getrusage: its peak is inherited from the program that started this one
status = pathlib.Path('/proc/self/status')
lines = status.read_text().splitlines() if status.exists() else []
peak = [int(line.split()[1]) / 1024 for line in lines if line.startswith('VmHWM')]
print(json.dumps({'boxes': len(corners), 'seconds': seconds, 'peak_MB': round(peak[0]) if peak else None}))
