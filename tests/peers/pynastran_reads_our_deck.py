"""Reads a deck with pyNastran and prints its mass, centre of gravity and numbers of nodes and elements as JSON.

    python3 tests/peers/pynastran_reads_our_deck.py DECK

Ends with 1 if pyNastran refuses the deck. Where pyNastran is absent it prints a notice and ends with 0.
The mass is in the deck's own units: PARAM WTMASS is in it, and SPC or MPC play no part.
"""

import json
import sys


def main() -> int:
    if len(sys.argv) != 2:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    try:
        from pyNastran.bdf.bdf import BDF
        from pyNastran.bdf.mesh_utils.mass_properties import mass_properties
    except ImportError:
        print("notice: pyNastran is not installed, so the deck was not checked (pip install pyNastran)")
        return 0
    model = BDF(debug=None)
    try:
        model.read_bdf(sys.argv[1], punch=None, xref=True)
        mass, centre, inertia = mass_properties(model, reference_point=[0.0, 0.0, 0.0])
    except Exception as error:  # pyNastran raises many kinds; each means that it does not read the deck
        print(f"pyNastran refuses {sys.argv[1]}: {error}", file=sys.stderr)
        return 1
    found = {
        "mass": float(mass),
        "centre_of_gravity": [float(value) for value in centre],
        "inertia": [float(value) for value in inertia],
        "nodes": len(model.nodes),
        "elements": len(model.elements),
        "mass_elements": len(model.masses),
        "rigid_elements": len(model.rigid_elements),
        "cards": {name: int(count) for name, count in sorted(model.card_count.items())},
    }
    print(json.dumps(found, indent=1))
    return 0


if __name__ == "__main__":
    sys.exit(main())
