"""The deck that `cargo xtask deck` writes, read by pyNastran: no error, the same mass, centre, grids and elements.

Options are handed on to `deck`: `--wing FILE`.

pyNastran takes the mean of two opposite faces times their distance for the volume of a CHEXA, which is not exact for a
tapered one; the volumes are integrated here instead (Gauss, 2 by 2 by 2 points: exact for a trilinear map).
"""

import itertools
import sys

from common import Comparison, skip, written_deck

try:
    from pyNastran.bdf.bdf import read_bdf
    from pyNastran.bdf.mesh_utils.mass_properties import mass_properties
except ImportError as missing:
    skip(f"pyNastran is not here ({missing}); `pip install pynastran setuptools`")

CORNERS = [(-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)]


def volume(points):
    """Of a hexahedron with these corners."""
    total = 0.0
    for place in itertools.product((-(3**-0.5), 3**-0.5), repeat=3):
        rows = [[0.0] * 3 for _ in range(3)]
        for corner, point in zip(CORNERS, points):
            shape = [1 + c * p for c, p in zip(corner, place)]
            for axis in range(3):
                slope = corner[axis] * shape[axis - 1] * shape[axis - 2] / 8
                rows[axis] = [value + slope * x for value, x in zip(rows[axis], point)]
        (a, b, c), (d, e, f), (g, h, i) = rows
        total += a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    return total


deck, ours = written_deck(*sys.argv[1:])
# Reads with cross references: every reference must be there.
model = read_bdf(str(deck), debug=None, xref=True, punch=False)
found = Comparison()
# Without the symmetry that AEROS states: the structure is one half.
mass, centre, _ = mass_properties(model, sym_axis="no")
solids = [element for element in model.elements.values() if element.type == "CHEXA"]
mass += sum(solid.pid_ref.Rho() * (volume(solid.get_node_positions()) - solid.Volume()) for solid in solids)
found.close("mass (kg)", ours["mass_kg"], mass, 1e-6)
found.equal("grids", ours["grids"], len(model.nodes))
counts = {name: len(ids) for name, ids in model._type_to_id_map.items()}
for card, count in sorted(ours["elements"].items()):
    found.equal(card, count, counts.get(card, 0))
found.equal("splines", ours["splines"], len(model.splines))
found.equal("boxes", ours["boxes"], sum(panel.shape[0] * panel.shape[1] for panel in model.caeros.values()))
found.equal("solution", 103, model.sol)
found.equal("monitor points", 1, len(model.monitor_points))
found.end()
