"""The deck that `cargo xtask deck` writes, read by pyNastran: no error, the same mass, centre, grids and elements.

Options are handed on to `deck`: `--wing FILE`.
"""

import sys

from common import Comparison, skip, written_deck

try:
    from pyNastran.bdf.bdf import read_bdf
    from pyNastran.bdf.mesh_utils.mass_properties import mass_properties
except ImportError as missing:
    skip(f"pyNastran is not here ({missing}); `pip install pynastran setuptools`")

deck, ours = written_deck(*sys.argv[1:])
# Reads with cross references: every reference must be there.
model = read_bdf(str(deck), debug=None, xref=True, punch=False)
found = Comparison()
# Without the symmetry that AEROS states: the structure is one half.
mass, centre, _ = mass_properties(model, sym_axis="no")
found.close("mass (kg)", ours["mass_kg"], mass, 1e-6)
found.equal("grids", ours["grids"], len(model.nodes))
counts = {name: len(ids) for name, ids in model._type_to_id_map.items()}
for card, count in sorted(ours["elements"].items()):
    found.equal(card, count, counts.get(card, 0))
found.equal("splines", ours["splines"], len(model.splines))
found.equal("boxes", ours["boxes"], sum(panel.nspan_nchord_boxes() if hasattr(panel, "nspan_nchord_boxes") else panel.shape[0] * panel.shape[1] for panel in model.caeros.values()))
found.equal("solution", 103, model.sol)
found.equal("monitor points", 1, len(model.monitor_points))
found.end()
