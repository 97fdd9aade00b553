"""The Pazy wing with skin in steady air at large deflections, and its small motions about the bent wing, by flapjax and by `wingroot`.

    python3.12 -m venv venv && venv/bin/pip install flapjax==1.3.13
    venv/bin/python tests/peers/time_flapjax.py [--linearise]

1.225 kg/m3, the wing's weight (tips are those above the wing without wind); beams of two sources (`data/pazy`: measured; flapjax: the
codes' condensed one). Here thirty strips of sixteen boxes and a wake of straight legs; flapjax with the same and ten chords of wake, as in
its own tests of this wing, and with 8 by 15 boxes and five chords (with its straight wake its tip is 12 to 18 % above that of a free
one). flapjax's solution is compiled first (`jax.jit`), which is timed apart. `--linearise` adds its linear system about the equilibrium at 3 degrees and 40 m/s with all eigenvalues (8 by 15 boxes
and five chords of wake, as in its own test of stability) beside `wingroot flutter` with equilibria at all airspeeds. Seconds of the
clock and of the processor; WINGROOT names the program (default: target/debug/wingroot). Without flapjax it says so and ends well.
"""

import copy
import csv
import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

from common import ROOT, skip

try:
    import jax
    jax.config.update("jax_enable_x64", True)
    from jax import numpy as jnp
    from flapjax.aero.flowfields import ConstantFlowField
    from flapjax.models.pazy.straight.pazy_wing import generate_pazy_wing
    from flapjax.utils.print_utils import set_verbosity
except ImportError as missing:
    skip(f"flapjax is not here ({missing}); `pip install flapjax==1.3.13` with Python 3.12 or newer")

WINGROOT = os.environ.get("WINGROOT", str(ROOT / "target/debug/wingroot"))
AIRSPEEDS = [20.0, 30.0, 40.0, 45.0, 50.0]
ROOT_DEG, SEMISPAN_M, RHO_KG_M3 = 5.0, 0.55, 1.225
CLAMPED = tuple(range(6))
# Boxes along the wake by boxes along the chord.
WAKE = {8: 40, 16: 160}


def timed(work):
    """What it returns, seconds of the clock, and processor seconds of this process and its children."""
    def used():
        return sum(part.ru_utime + part.ru_stime for part in map(resource.getrusage, (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)))
    clock, processor = time.perf_counter(), used()
    answer = work()
    return answer, time.perf_counter() - clock, used() - processor


def their_wing(alpha_deg, chordwise, wake, multiplier):
    """At 40 m/s."""
    return generate_pazy_wing(
        m=chordwise, m_star=wake, skin=True, node_multiplier=multiplier, aoa=jnp.deg2rad(alpha_deg), flowfield=air(RHO_KG_M3),
        gravity=jnp.array((0.0, 0.0, -9.81)))


def air(rho_kg_m3):
    return ConstantFlowField(u_inf=jnp.array((40.0, 0.0, 0.0)), rho=rho_kg_m3, relative_motion=True)


def their_tip(wing, v_m_s):
    """Rise of the tip at half of its chord over the semispan, as flapjax's own tests take it. The airspeed is part of what is
    compiled, so that the dynamic pressure comes from the density."""
    wing = copy.deepcopy(wing)
    wing.set_design_variables(
        coords=wing.structure.x0, k_cs=wing.structure.k_cs, m_cs=wing.structure.m_cs, m_lumped=None, dt=wing.aero.dt,
        flowfield=air(RHO_KG_M3 * (v_m_s / 40.0) ** 2), zeta_b0=wing.aero.zeta_b0, remove_checks=True)
    corners = wing.static_solve(prescribed_dofs=CLAMPED, horseshoe=False).aero.zeta_b[0]
    return 0.5 * (corners[0, -1, 2] + corners[-1, -1, 2]) / SEMISPAN_M


def our_wing(folder):
    """`data/pazy` with the peer's number of boxes; where its wing is."""
    source, boxes = (ROOT / "data/pazy/wing.ron").read_text(), "(chordwise: 18, spanwise: 36)"
    assert boxes in source, f"data/pazy/wing.ron has no {boxes}"
    (folder / "wing.ron").write_text(source.replace(boxes, "(chordwise: 16, spanwise: 30)"))
    (folder / "beam_distribution.csv").write_text((ROOT / "data/pazy/beam_distribution.csv").read_text())


def ours(folder, command, *options):
    out = folder / command
    subprocess.run([WINGROOT, command, "--wing", str(folder / "wing.ron"), "--nonlinear", "--quiet", "--out", str(out), *options], check=True)
    return out


def row(what, clock, processor):
    print(f"{what:<72}{clock:>9.2f}{processor:>12.2f}")


set_verbosity("silent")
folder = pathlib.Path(tempfile.mkdtemp())
our_wing(folder)
print(f"{'':<72}{'clock, s':>9}{'processor, s':>12}")
tips = {}
for chordwise, multiplier in ((8, 1), (16, 2)):
    mesh = f"{chordwise} by {15 * multiplier} boxes"
    bent = their_wing(ROOT_DEG, chordwise, WAKE[chordwise], multiplier)
    solve = jax.jit(lambda v_m_s: their_tip(bent, v_m_s))
    at_rest, clock, processor = timed(lambda: float(solve(1e-3)))
    row(f"flapjax, {mesh}: compilation and the wing without wind", clock, processor)
    tips[mesh], clock, processor = timed(lambda: [float(solve(v)) - at_rest for v in AIRSPEEDS])
    row(f"flapjax, {mesh}: a static point, compiled (mean of {len(AIRSPEEDS)})", clock / len(AIRSPEEDS), processor / len(AIRSPEEDS))
for airspeeds in (AIRSPEEDS[:1], AIRSPEEDS):
    speeds = ",".join(map(str, airspeeds))
    out, clock, processor = timed(lambda: ours(folder, "statics", "--airspeeds", speeds, "--alpha", str(ROOT_DEG), "--density", str(RHO_KG_M3)))
    row(f"wingroot statics, the whole command with {len(airspeeds)} airspeed{'s' * (len(airspeeds) > 1)}", clock, processor)
with (out / "airspeeds.csv").open() as file:
    tips["wingroot"] = [float(line["large_tip_z_m"]) / SEMISPAN_M for line in csv.DictReader(file)]
print("tip over semispan, %, at " + ", ".join(f"{v:g}" for v in AIRSPEEDS) + " m/s")
for whose, shares in tips.items():
    print(f"{whose:<20}" + "".join(f"{100 * share:>8.2f}" for share in shares))

if "--linearise" in sys.argv:
    chordwise, alpha_deg = 8, 3.0
    wing = their_wing(alpha_deg, chordwise, WAKE[chordwise], 1)
    solved, clock, processor = timed(lambda: wing.static_solve(prescribed_dofs=CLAMPED, horseshoe=False))
    row(f"flapjax: the equilibrium at {alpha_deg:g} degrees and 40 m/s, {chordwise} by 15 boxes, not compiled before", clock, processor)
    linear, clock, processor = timed(lambda: wing.linearise(solved, prescribed_dofs=CLAMPED))
    row("flapjax: its linear system, compiled meanwhile", clock, processor)
    roots, clock, processor = timed(lambda: linear.modal().block_until_ready())
    row(f"flapjax: {len(roots)} eigenvalues", clock, processor)
    out, clock, processor = timed(lambda: ours(folder, "flutter", "--alpha", f"{alpha_deg:g}", "--to", "60"))
    row("wingroot flutter, the whole command up to 60 m/s in steps of 2", clock, processor)
