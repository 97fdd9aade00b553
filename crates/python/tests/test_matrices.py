"""Matrices agree with each other and with what the commands say."""

import numpy
import pytest

import wingroot


def test_stiffness_and_mass_are_symmetric_and_give_the_modes(own_wing):
    scipy = pytest.importorskip("scipy")
    wing, _ = own_wing
    stiffness, mass = wing.stiffness.toarray(), wing.mass.toarray()
    assert stiffness.shape == mass.shape == (len(wing.free), len(wing.free))
    for matrix in (stiffness, mass):
        numpy.testing.assert_array_equal(matrix, matrix.T)
    shapes = wing.modes(4)["modes"]
    place = {grid: 6 * row for row, grid in enumerate(wing.modes(4)["grid_id"])}
    free = shapes[[place[grid] + component - 1 for grid, component in wing.free]]
    numpy.testing.assert_allclose(free.T @ mass @ free, numpy.eye(4), atol=1e-9)
    omega = wing.modes(4)["omega_rad_s"]
    numpy.testing.assert_allclose(numpy.diag(free.T @ stiffness @ free), omega**2, rtol=1e-9)
    assert scipy.sparse.issparse(wing.stiffness)


def test_modes_are_those_of_the_command(own_wing):
    wing, _ = own_wing
    hertz = wingroot.modes(wing, count=4)["frequencies_hz"]
    assert hertz == pytest.approx(wing.modes(4)["omega_rad_s"] / (2 * numpy.pi), rel=1e-12)


def test_a_plate_of_boxes_lifts(own_wing):
    wing, _ = own_wing
    boxes = wing.boxes
    assert wing.aic.shape == (len(boxes["id"]), len(boxes["id"]))
    upward = boxes["normal"][:, 2]
    slope = (wing.aic @ upward * boxes["area_m2"] * upward).sum() / boxes["area_m2"].sum()
    assert 3.0 < slope < 2 * numpy.pi


def test_eigenvalues_of_the_state_space_are_those_of_flutter(own_wing):
    wing, corrections = own_wing
    campaign = wingroot.Campaign(wing.path.parent / "campaign")
    table = wingroot.flutter(wing, campaign, corrections=corrections, to_m_s=40).table("updated_state_matrix")
    (row,) = numpy.flatnonzero(numpy.asarray(table["V_m_s"]) == 20.0)
    roots = numpy.linalg.eigvals(wing.state_space(20.0, campaign.rho_kg_m3, corrections).A)
    for mode in range(1, 5):
        hertz, damping = (numpy.asarray(table[f"{name}_{mode}_{unit}"])[row] for name, unit in (("frequency", "hz"), ("damping", "g")))
        nearest = roots[numpy.abs(roots.imag / (2 * numpy.pi) - hertz).argmin()]
        assert nearest.imag / (2 * numpy.pi) == pytest.approx(hertz, rel=1e-7)
        assert 2 * nearest.real / nearest.imag == pytest.approx(damping, rel=1e-7)


def test_without_air_the_state_space_has_the_natural_frequencies(own_wing):
    wing, _ = own_wing
    system = wing.state_space(1e-3, 1e-9)
    hertz = numpy.abs(numpy.linalg.eigvals(system.A)) / (2 * numpy.pi)
    for frequency in wing.modes(4)["omega_rad_s"] / (2 * numpy.pi):
        assert numpy.abs(hertz / frequency - 1).min() < 1e-6


def test_names_and_shapes_of_a_state_space_agree(own_wing):
    wing, corrections = own_wing
    slow, fast = wing.state_space([20.0, 25.0], 1.2, corrections)
    for a, b, c, d, inputs, outputs in (slow, fast):
        assert a.shape == (len(b), len(b)) and c.shape[0] == len(outputs) == d.shape[0]
        assert b.shape[1] == len(inputs) == d.shape[1]
    assert slow.inputs[1] == "alpha_rad" and slow.outputs[:3] == ["Fz_N", "Mx_Nm", "My_Nm"]
    assert not numpy.array_equal(slow.A, fast.A)
