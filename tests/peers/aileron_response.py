"""Writes data/loads_kernel/aileron_response.csv: the aileron of that wing in the frequency domain, in numpy on PanelAero.

    python3 -m venv venv && venv/bin/pip install PanelAero==2025.8 scipy
    venv/bin/python tests/peers/aileron_response.py > data/loads_kernel/aileron_response.csv

Ten modes, boxes on their nearest node, the doublet lattice at each frequency ('lattice'), or the rational function that
Loads Kernel 2026.5 makes of it ('fit': Roger's four poles from eight frequencies, no term in k squared; its value at rest
replaced by the vortex lattice's). Loads and tip per rad of deflection, with or without the incidence of the hinge's rate.
"""
import sys
from pathlib import Path

from common import panelaero_grid

try:
    import numpy as np
    from panelaero import DLM, VLM
    from scipy.linalg import eigh
except ImportError:
    print('PanelAero or SciPy is not installed: nothing computed', file=sys.stderr)
    sys.exit(0)

DATA = Path(__file__).parents[2] / 'data' / 'loads_kernel'
NODES, MODES, STRIPS, ROWS = 29, 10, 56, 12
V, RHO, MACH, C_REF, DAMPING = 30.0, 101325 / 287.0531 / 288.15, 0.088, 0.225, 0.01
FREQUENCIES_HZ = (0.2, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 12.0, 20.0)
K_FIT = np.array([0.001, 0.05, 0.1, 0.2, 0.4, 0.6, 0.8, 1.0])
POLES = K_FIT.max() / np.arange(1, 5)
BALANCE = np.array([0.1, 0.0, 0.0])
# origin and a point of the x axis of CORD2R 901, printed digits
HINGE, TOWARDS_X = np.array([0.39076, 0.51429, 0.0]), np.array([1.34254, 0.20752, 0.0])


def rows(name):
    lines = [line for line in (DATA / name).read_text().splitlines() if not line.startswith('#')]
    return [[float(cell) for cell in line.split(',')] for line in lines[1:]]


def matrix(name):
    full = np.zeros((6 * NODES, 6 * NODES))
    for i, j, value in rows(name):
        full[int(i), int(j)] = full[int(j), int(i)] = value
    return full


def corners():
    def at(s, c):
        return np.array([0.69265 * s + c * (0.30 - 0.15 * s), 1.8 * s, 0.0])
    return np.array([[at(i / STRIPS, j / ROWS), at(i / STRIPS, (j + 1) / ROWS),
                      at((i + 1) / STRIPS, (j + 1) / ROWS), at((i + 1) / STRIPS, j / ROWS)]
                     for i in range(STRIPS) for j in range(ROWS)])


class Wing:
    def __init__(self):
        self.grid = panelaero_grid(corners())
        self.nodes = np.array([row[1:] for row in rows('grid.csv')])
        self.mass = matrix('mgg.csv')
        omega2, shapes = eigh(matrix('kgg.csv')[6:, 6:], self.mass[6:, 6:])
        self.omega2 = omega2[:MODES]
        self.shapes = np.vstack((np.zeros((6, MODES)), shapes[:, :MODES]))
        mid = self.grid['offset_k']
        self.near = np.argmin(((mid[:, None] - self.nodes[None]) ** 2).sum(-1), axis=1)
        arm = self.grid['offset_j'] - self.nodes[self.near]
        # rotation and height of the three-quarter points in each mode
        u = [self.shapes[component::6][self.near] for component in range(6)]
        self.twist, self.height = u[4], u[2] + u[3] * arm[:, 1:2] - u[4] * arm[:, 0:1]
        axis = np.cross([0.0, 0.0, 1.0], TOWARDS_X - HINGE)
        axis /= np.linalg.norm(axis)
        self.slope, self.lever = np.zeros(len(mid)), np.zeros(len(mid))
        for box in (strip * ROWS + row for strip in range(16, 28) for row in (9, 10, 11)):
            self.slope[box] = axis[1]
            self.lever[box] = -np.cross(axis, self.grid['offset_j'][box] - HINGE)[2]

    def node_loads(self, cp):
        lift = 0.5 * RHO * V * V * self.grid['A'] * cp
        arm = self.grid['offset_k'] - self.nodes[self.near]
        moment = lift * (self.grid['offset_k'] - self.grid['offset_l'])[:, 0]
        loads = np.zeros((NODES, 6), complex)
        np.add.at(loads[:, 2], self.near, lift)
        np.add.at(loads[:, 3], self.near, arm[:, 1] * lift)
        np.add.at(loads[:, 4], self.near, moment - arm[:, 0] * lift)
        return loads.ravel()

    def response(self, q, omega, hinge_rate):
        """Fz, Mx, My, tip per rad; q gives pressures of incidences."""
        aileron = self.node_loads(q @ (self.slope + (1j * omega / V * self.lever if hinge_rate else 0.0)))
        by_mode = np.column_stack([self.node_loads(q @ (self.twist[:, m] - 1j * omega / V * self.height[:, m]))
                                   for m in range(MODES)])
        dynamic = np.diag(self.omega2 - omega ** 2 + 2j * DAMPING * np.sqrt(self.omega2) * omega)
        modes = np.linalg.solve(dynamic - self.shapes.T @ by_mode, self.shapes.T @ aileron)
        u = self.shapes @ modes
        loads = (aileron + by_mode @ modes + omega ** 2 * (self.mass @ u)).reshape(NODES, 6)
        arm = self.nodes - BALANCE
        return [loads[:, 2].sum(), (loads[:, 3] + arm[:, 1] * loads[:, 2]).sum(),
                (loads[:, 4] - arm[:, 0] * loads[:, 2]).sum(), u[-4]]


def lattice(grid, k):
    return DLM.calc_Qjj(grid, MACH, k / (C_REF / 2))


def fit(grid):
    """The function of k, as Loads Kernel makes it."""
    at_rest = VLM.calc_Qjj(grid, MACH)[0]
    n = len(at_rest)
    real = [np.ones(8), np.zeros(8)] + [K_FIT ** 2 / (K_FIT ** 2 + pole ** 2) for pole in POLES]
    imaginary = [np.zeros(8), K_FIT] + [K_FIT * pole / (K_FIT ** 2 + pole ** 2) for pole in POLES]
    q = np.array([lattice(grid, k) for k in K_FIT]).reshape(8, -1)
    functions = np.vstack((np.array(real).T, np.array(imaginary).T))
    parts = np.linalg.lstsq(functions, np.vstack((q.real, q.imag)), rcond=None)[0].reshape(-1, n, n)
    return lambda k: at_rest + 1j * k * parts[1] + sum(
        part * (1j * k / (1j * k + pole)) for part, pole in zip(parts[2:], POLES))


def main():
    wing = Wing()
    fitted = fit(wing.grid)
    channels = [f'{name}_{part}' for name in ('Fz_N', 'Mx_Nm', 'My_Nm', 'tip_m') for part in ('re', 'im')]
    print('# written by tests/peers/aileron_response.py: per rad of aileron, at 30 m/s')
    print('f_hz,air,hinge_rate,' + ','.join(channels))
    for f_hz in FREQUENCIES_HZ:
        omega = 2 * np.pi * f_hz
        k = omega * C_REF / (2 * V)
        exact, rational = lattice(wing.grid, k), fitted(k)
        for air, q, hinge_rate in (('lattice', exact, True), ('lattice', exact, False), ('fit', rational, False)):
            numbers = [f'{part:.10e}' for z in wing.response(q, omega, hinge_rate) for part in (z.real, z.imag)]
            print(f'{f_hz:g},{air},{"yes" if hinge_rate else "no"},' + ','.join(numbers))


main()
