"""Reads model.h5 of `cargo xtask deck --hdf5` with h5py and checks that it fits together.

    python tests/peers/read_hdf5.py out/deck/model.h5

Skips with a notice where h5py is absent.
"""

import sys

try:
    import h5py
    import numpy as np
except ImportError:
    print("skipped: h5py is not installed")
    sys.exit(0)

with h5py.File(sys.argv[1], "r") as file:
    print(file.attrs["about"])
    for name, group in file.items():
        print(f"{name}: {group.attrs['about']}")
        for key, values in group.items():
            print(f"    {key} {values.shape} {values.dtype}")
    boxes = file["boxes"]
    corners = boxes["corners_m"][:]
    # Areas from the diagonals, as the boxes are plane.
    area = 0.5 * np.linalg.norm(
        np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]), axis=1
    )
    assert np.allclose(area, boxes["area_m2"][:], rtol=1e-9), "areas"
    lift = boxes["normal"][:, 2] * boxes["area_m2"][:] @ boxes["qjj"][:]
    slope = lift @ boxes["normal"][:, 2] / np.sum(area)
    print(f"rigid lift slope {slope:.4f} per rad")
    assert 1.0 < slope < 2.0 * np.pi, "lift slope"
    if "updated" in file:
        for name in ("initial", "updated"):
            a, b, c, d = (file[name][key][:] for key in "ABCD")
            inputs = [word.decode() for word in file[name]["inputs"][:]]
            outputs = [word.decode() for word in file[name]["outputs"][:]]
            assert b.shape == (len(a), len(inputs)) and c.shape == (len(outputs), len(a)), name
            steady = d - c @ np.linalg.solve(a, b)
            fz = steady[outputs.index("Fz_N"), inputs.index("alpha_rad")]
            print(f"{name}: dFz/dalpha {fz:.4f} N/rad, slowest decay {np.max(np.linalg.eigvals(a).real):.4f} 1/s")
            assert np.max(np.linalg.eigvals(a).real) < 0, "unstable"
print("good")
