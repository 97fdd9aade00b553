"""What Python computes is what the command line computes, to the last digit."""

import json

import numpy
import pytest

import wingroot


def without_time(result: dict) -> dict:
    return {key: value for key, value in result.items() if key != "seconds"}


@pytest.mark.parametrize("wing, campaign", [("own_wing", "own_wing/campaign"), ("tuflex", "tuflex/measured")])
def test_a_calibration_has_the_bits_of_the_command_line(data, program, tmp_path, wing, campaign):
    found = wingroot.calibrate(wingroot.Wing(data / wing / "wing.ron"), wingroot.Campaign(data / campaign))
    program("calibrate", "--wing", data / wing / "wing.ron", "--campaign", data / campaign, "--out", tmp_path / "out")
    expected = json.loads((tmp_path / "out/result.json").read_text())
    assert without_time(found.data) == without_time(expected)
    assert found.corrections.path.read_bytes() == (tmp_path / "out/corrections.ron").read_bytes()


def test_simulation_flutter_and_trim_have_the_bits_of_the_command_line(data, program, tmp_path, own_wing):
    wing, corrections = own_wing
    given = ["--wing", wing.path, "--corrections", corrections.path]
    aircraft = data / "own_wing/aircraft.ron"
    for command, function, words in [
        ("simulate", lambda: wingroot.simulate(wing, corrections=corrections), given),
        ("flutter", lambda: wingroot.flutter(wing, corrections=corrections, to_m_s=60), [*given, "--to", 60]),
        ("fullaircraft", lambda: wingroot.trim(aircraft, corrections=corrections), [*given, "--aircraft", aircraft]),
    ]:
        here = function()
        program(command, *words, "--out", tmp_path / command)
        there = json.loads((tmp_path / command / "result.json").read_text())
        assert without_time(here.data) == without_time(there), command
        for name in here.tables:
            assert (here.folder / f"{name}.csv").read_bytes() == (tmp_path / command / f"{name}.csv").read_bytes()


def test_arrays_are_the_numbers_of_the_file(own_wing):
    _, corrections = own_wing
    text = corrections.path.read_text()
    first = text.split("force: [")[1].split("]")[0]
    assert [float(word) for word in first.split(",")] == corrections.force[0].tolist()


def test_a_table_is_the_file(data):
    campaign = wingroot.Campaign(data / "own_wing/campaign")
    table = campaign.static
    lines = (campaign.path / "static.csv").read_text().splitlines()
    assert list(table) == lines[0].split(",")
    assert [float(line.split(",")[2]) for line in lines[1:]] == list(table["Fz_N"])
    assert numpy.asarray(table["block"])[0] == "morning"
