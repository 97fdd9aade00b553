"""Reads qjj.op4 of `cargo xtask deck --corrections F --hdf5` with pyNastran and compares it with model.h5.

    python tests/peers/read_op4.py out/deck

Its rows must be those of boxes/qjj in model.h5 times the force factors. Skips with a notice where a package is absent.
"""

import pathlib
import sys

try:
    import h5py
    import numpy as np
    from pyNastran.op4.op4 import OP4
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(0)

folder = pathlib.Path(sys.argv[1])
matrices = OP4(debug=False).read_op4(str(folder / "qjj.op4"))
entry = matrices["QJJ"]
qjj = entry[1] if isinstance(entry, tuple) else entry.data
with h5py.File(folder / "model.h5", "r") as file:
    theory = file["boxes/qjj"][:]
    factors = np.ones(len(theory))
    factors[file["boxes/correctable"][:]] = file["corrections/force"][:]
error = np.max(np.abs(qjj - factors[:, None] * theory)) / np.max(np.abs(theory))
print(f"QJJ {qjj.shape}: {error:.1e} of the largest entry from the force factors times theory")
assert error < 1e-9
print("good")
