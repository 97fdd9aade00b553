"""Bad input says where and what to do; failed computations are another exception."""

import pytest

import wingroot


def test_a_misspelt_field_has_file_line_column_and_hint(data, tmp_path):
    text = (data / "own_wing/wing.ron").read_text()
    line = next(number for number, words in enumerate(text.splitlines(), 1) if "damping_ratio:" in words)
    (tmp_path / "wing.ron").write_text(text.replace("damping_ratio:", "damping_ration:"))
    with pytest.raises(wingroot.InputError) as raised:
        wingroot.Wing(tmp_path / "wing.ron")
    error = raised.value
    assert (error.file, error.line) == (str(tmp_path / "wing.ron"), line)
    assert error.column == text.splitlines()[line - 1].index("damping_ratio") + 1
    assert "damping_ration" in error.message and "damping_ratio" in error.hint
    assert str(error).startswith(f"{error.file}:{error.line}:{error.column}: ")


def test_a_command_says_the_same(data, tmp_path):
    with pytest.raises(wingroot.InputError) as raised:
        wingroot.calibrate(data / "own_wing/wing.ron", tmp_path / "no_such")
    assert "no_such" in raised.value.file and raised.value.hint
    with pytest.raises(wingroot.InputError, match="--loud"):
        wingroot.command("modes", wing=data / "own_wing/wing.ron", loud=True)


def test_corrections_of_another_wing_are_refused(data, own_wing):
    with pytest.raises(wingroot.InputError, match="another wing"):
        wingroot.flutter(data / "tuflex/wing.ron", data / "tuflex/measured", corrections=own_wing[1])


def test_what_cannot_be_completed_is_a_computation_error(data):
    # by linear theory the wing diverges at 107 m/s, and without lift it does not bend away from it
    with pytest.raises(wingroot.ComputationError, match="no stable equilibrium") as raised:
        wingroot.command("statics", wing=data / "pazy/wing.ron", nonlinear=True, airspeeds="90,130", alpha=0)
    assert raised.value.result is None


def test_a_wing_has_no_more_modes_than_motions_with_mass(own_wing):
    wing, _ = own_wing
    assert 0 < len(wingroot.modes(wing, count=10_000)["frequencies_hz"]) < 10_000


def test_a_result_that_was_not_there_names_those_that_are(own_wing):
    found = wingroot.modes(own_wing[0], count=2)
    with pytest.raises(KeyError, match="shapes"):
        found.figure("shape")
