"""Flutter of the wing of sixteen metres that a force on its tip holds bent, by flapjax's beam and vortex rings.

    python3.12 -m venv venv && venv/bin/pip install flapjax==1.3.13
    venv/bin/python tests/peers/held_wing.py [FORCE_N ...]

The wing is that of `data/published/nl_hale__patil_flutter.json`; the wing's plane is along the stream, so that there is no steady air,
and one linear system serves all airspeeds. Taken from flapjax: the bent beam and its modes, what rings give each other's
control points, what motions give them, and the forces of circulations. Three things are done otherwise than in its own eigenvalues:

- Its unsteady force is taken by half: `compute_surf_nc` gives the cross product of the diagonals, which is twice the area that its
  documentation names. As it stands, a straight wing in bending feels more than three times Theodorsen's force in phase.
- Time does not go in steps: circulations go as exp(i omega t), wakes carry them on at the airspeed, and the structure is
  continuous (the p-k method). In steps of a box's length forces lag by a step and a half.
- Rings lie a quarter of a box behind the boxes, so that errors fall with the number of boxes along the chord; the last ones
  fall in proportion to 1/m and are taken off by m = 6 and 12.

Two to seven minutes for each force and number of boxes. Without flapjax it says so and ends well.
"""

import json
import sys

from common import ROOT, skip

try:
    import jax
    jax.config.update("jax_enable_x64", True)
    import numpy as np
    from jax import numpy as jnp
    from flapjax.aero.data_structures import GridDiscretisation
    from flapjax.aero.flowfields import ConstantFlowField
    from flapjax.aero.utils import make_rectangular_grid
    from flapjax.aero.uvlm import UVLM
    from flapjax.coupled import CoupledAeroelastic
    from flapjax.structure import BeamStructure
    from flapjax.utils.print_utils import set_verbosity
except ImportError as missing:
    skip(f"flapjax is not here ({missing}); `pip install flapjax==1.3.13` with Python 3.12 or newer")

WING = json.loads((ROOT / "data/published/nl_hale__patil_flutter.json").read_text())["inputs"]
STRIPS, WAKE_CHORDS, MODES = 16, 5, 8
BOXES = [6, 12]
# m/s: of the linear system, and those at which roots are found.
REFERENCE, AIRSPEEDS = 25.0, np.arange(18.0, 37.0, 2.0)
# Share of a step by which the first ring of the wake is younger: its middle is half a step away.
MIDDLE = 0.5


def wing(boxes):
    span, chord = WING["span_m"], WING["chord_m"]
    nodes = STRIPS + 1
    beam = BeamStructure(
        num_nodes=nodes, connectivity=jnp.stack([jnp.arange(STRIPS), jnp.arange(1, nodes)], axis=1),
        y_vector=jnp.zeros((STRIPS, 3)).at[:, 0].set(-1.0), gravity=None)
    rings = UVLM(
        grid_shapes=(GridDiscretisation(m=boxes, n=STRIPS, m_star=WAKE_CHORDS * boxes),), dof_mapping=jnp.arange(nodes),
        mirror_point=jnp.zeros(3), mirror_normal=jnp.array((0.0, 1.0, 0.0)))
    whole = CoupledAeroelastic(structure=beam, aero=rings)
    # Axes of the beam: along the span, forward, up. Beyond bending and torsion it is as good as rigid.
    stiffness = (1e9, 1e9, 1e9, WING["GJ_Nm2"], WING["EI_flat_Nm2"], WING["EI_chord_Nm2"])
    mass, pitch = WING["mass_per_length"], WING["inertia_pitch_kg_m"]
    whole.set_design_variables(
        coords=jnp.zeros((nodes, 3)).at[:, 1].set(jnp.linspace(0.0, span, nodes)), k_cs=jnp.diag(jnp.array(stiffness)),
        m_cs=jnp.diag(jnp.array((mass, mass, mass, pitch, 1e-5, pitch))), m_lumped=None, dt=chord / (REFERENCE * boxes),
        flowfield=ConstantFlowField(u_inf=jnp.array((REFERENCE, 0.0, 0.0)), rho=WING["rho"], relative_motion=True),
        zeta_b0=make_rectangular_grid(m=boxes, n=STRIPS, chord=chord, ea=WING["elastic_axis"] - 0.25 / boxes),
        delta_w=None, orientation_euler=jnp.zeros(3))
    return whole


class Held:
    """The wing under a force on its tip: its modes and its air by frequency."""

    def __init__(self, boxes, force_n):
        whole, clamped = wing(boxes), tuple(range(6))
        load = jnp.zeros((STRIPS + 1, 6)).at[-1, 2].set(force_n)
        still = whole.static_solve(prescribed_dofs=clamped, f_ext_dead=load, horseshoe=False, load_steps=4)
        assert float(jnp.abs(still.aero.gamma_b[0]).max()) < 1e-12, "there is steady air"
        self.tip_m = float(still.structure.hg[-1, 2, 3])
        linear = whole.linearise(still, prescribed_dofs=clamped, n_struct_modes=MODES)
        at = {name: part(linear.state_slices[name].slices) for name in ("gamma_b", "gamma_w", "gamma_b_nm1", "q", "q_dot")}
        system, structure = np.array(linear.sys.a), linear.structure.sys
        rows = slice(at["q"].start, at["q_dot"].stop)
        by_air = system[rows].copy()
        by_air[:, rows] -= np.array(structure.a)
        inputs = part(linear.structure.input_slices["f_ext"].slices)
        force = np.linalg.pinv(np.array(structure.b)[:, inputs]) @ by_air
        motion = linear.structure.linearise_continuous()
        self.motion, self.by_force = np.array(motion.a), np.array(motion.b)[:, inputs]
        self.boxes, self.wake = boxes, WAKE_CHORDS * boxes
        ring = system[at["gamma_b"]]
        self.of_first, self.of_wake, self.of_place, self.of_speed = (ring[:, at[of]] for of in ("gamma_b", "gamma_w", "q", "q_dot"))
        # Circulations of now and of the step before stand for their rate: by half, see above.
        before = force[:, at["gamma_b_nm1"]]
        self.by_ring, self.by_rate, self.by_wake = force[:, at["gamma_b"]] + before, -0.5 * linear.dt * before, force[:, at["gamma_w"]]

    def forces(self, v_m_s, omega):
        """Forces of the modes by their motions as exp(i omega t)."""
        step = WING["chord_m"] / (v_m_s * self.boxes)
        age = (np.arange(1, self.wake + 2) - MIDDLE) * step
        late, last = np.exp(-1j * omega * age), slice(-STRIPS, None)
        # The solution moves the wake on first: its first row stands with the bound rings, the others with the wake's.
        solved = np.eye(self.boxes * STRIPS, dtype=complex) - self.of_first * late[0]
        solved[:, last] -= np.einsum("abj,b->aj", self.of_wake.reshape(-1, self.wake, STRIPS), late[1:])
        faster = v_m_s / REFERENCE
        rings = np.linalg.solve(solved, self.of_place * faster + 1j * omega * self.of_speed)
        behind = (late[:-1, None, None] * rings[last]).reshape(self.wake * STRIPS, -1)
        return (self.by_ring * faster + 1j * omega * self.by_rate) @ rings + faster * (self.by_wake @ behind)

    def torsion(self, v_m_s):
        """The root that begins as torsion, rad/s, by the p-k method."""
        natural = np.sort(np.linalg.eigvals(self.motion).imag)
        root = complex(-1.0, 0.88 * natural[natural > 15.0][0])
        omega = root.imag
        for _ in range(100):
            air = self.forces(v_m_s, omega)
            moving = self.motion.copy()
            moving[:, :MODES] += self.by_force @ air.real
            moving[:, MODES:] += self.by_force @ air.imag / omega
            roots = np.linalg.eigvals(moving)
            # Motions in the plane of a flat wing meet no air.
            roots = roots[(roots.imag > 1e-3) & (np.abs(roots.real) > 1e-7)]
            root = roots[np.argmin(np.abs(roots - root))]
            if abs(root.imag - omega) < 1e-8 * omega:
                break
            omega = root.imag
        return root


def part(slices):
    return slices[0] if isinstance(slices, (list, tuple)) else slices


set_verbosity("silent")
for force_n in [float(force) for force in sys.argv[1:]] or [0.0, 18.0]:
    coarse, fine = (Held(boxes, force_n) for boxes in BOXES)
    limit = np.array([2.0 * fine.torsion(v) - coarse.torsion(v) for v in AIRSPEEDS])
    for v, root in zip(AIRSPEEDS, limit):
        print(f"tip {fine.tip_m:.3f} m, {v:4.1f} m/s: {root.real:8.4f} {root.imag:+8.3f}i")
    grows = np.flatnonzero((limit.real[:-1] < 0.0) & (limit.real[1:] >= 0.0))
    onset = [np.interp(0.0, limit.real[i:i + 2], AIRSPEEDS[i:i + 2]) for i in grows]
    print(f"tip {fine.tip_m:.3f} m: flutter from " + ", ".join(f"{v:.2f} m/s" for v in onset), flush=True)
