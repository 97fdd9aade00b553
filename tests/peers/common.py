"""What the scripts of this folder share: running a command of ours, and a notice where a peer is absent."""

import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def skip(reason):
    """Ends the script without a failure."""
    print(f"skipped: {reason}")
    sys.exit(0)


def written_deck(*options):
    """Runs `cargo xtask deck` into a new folder; the path of the deck and result.json."""
    out = pathlib.Path(tempfile.mkdtemp()) / "deck"
    command = ["cargo", "run", "--quiet", "--package", "xtask", "--", "deck", "--quiet", "--out", str(out), *options]
    subprocess.run(command, cwd=ROOT, check=True)
    return out / "wing.bdf", json.loads((out / "result.json").read_text())


def panelaero_grid(c):
    """PanelAero's description of boxes given by their corners, boxes by 4 by 3."""
    import numpy as np
    l1, l2, b1, b2 = c[:, 1] - c[:, 0], c[:, 2] - c[:, 3], c[:, 3] - c[:, 0], c[:, 2] - c[:, 1]
    lm, bm, n = (l1 + l2) / 2, (b1 + b2) / 2, len(c)
    normal = np.cross(l1, b1)
    p1, p3, sets = c[:, 0] + l1 / 4, c[:, 3] + l2 / 4, np.arange(6 * n).reshape(n, 6)
    point = {name: c[:, 0] + f * lm + b1 / 2 for name, f in [('offset_l', 0.25), ('offset_k', 0.5), ('offset_j', 0.75)]}
    return {'ID': np.arange(1, n + 1), 'n': n, 'l': lm[:, 0].copy(), 'A': np.linalg.norm(np.cross(lm, bm), axis=1),
            'N': normal / np.linalg.norm(normal, axis=1)[:, None], 'offset_P1': p1, 'offset_P3': p3, 'r': p3 - p1,
            'set_l': sets, 'set_k': sets, 'set_j': sets, 'coord_desc': 'bodyfixed', **point}


class Comparison:
    """Collects numbers beside each other and ends with a failure if one is too far off."""

    def __init__(self):
        self.failed = 0
        print(f"{'quantity':<38}{'ours':>16}{'peer':>16}{'difference':>12}")

    def close(self, what, ours, peer, relative):
        """Within a share of the peer's number."""
        share = abs(ours - peer) / abs(peer) if peer else abs(ours)
        good = share <= relative
        self.failed += not good
        print(f"{what:<38}{ours:>16.8g}{peer:>16.8g}{100 * share:>11.4f}%{'' if good else '   TOO FAR'}")

    def equal(self, what, ours, peer):
        """The same."""
        self.failed += ours != peer
        print(f"{what:<38}{ours!s:>16}{peer!s:>16}{'' if ours == peer else '   DIFFERENT':>12}")

    def end(self):
        """Exit status 1 if anything was too far off."""
        print("all agree" if not self.failed else f"{self.failed} do not agree")
        sys.exit(1 if self.failed else 0)
