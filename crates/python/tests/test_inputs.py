"""Wings, campaigns and corrections made in Python are those that files describe."""

import numpy
import pytest

import wingroot


@pytest.mark.parametrize("name", ["own_wing/wing.ron", "tuflex/wing.ron", "pazy/wing.ron", "weber_brebner/wing.ron"])
def test_a_wing_goes_to_a_dictionary_and_back(data, name):
    wing = wingroot.Wing(data / name)
    again = wingroot.Wing.from_dict(wing.to_dict(), base=wing.path.parent)
    assert again.to_dict() == wing.to_dict()
    third = wingroot.Wing.from_dict(again.to_dict(), base=again.path.parent)
    assert third.hash == again.hash


def test_the_wing_of_a_dictionary_calibrates_as_the_file_does(data, own_wing):
    wing, corrections = own_wing
    again = wingroot.Wing.from_dict(wing.to_dict(), base=wing.path.parent)
    found = wingroot.calibrate(again, data / "own_wing/campaign").corrections
    numpy.testing.assert_array_equal(found.force, corrections.force)


def test_a_changed_field_changes_the_wing(own_wing, tmp_path):
    wing, _ = own_wing
    fields = wing.to_dict()
    fields["damping_ratio"] = numpy.float64(0.03)
    changed = wingroot.Wing.from_dict(fields, tmp_path / "changed", base=wing.path.parent)
    assert changed.to_dict()["damping_ratio"] == 0.03
    assert sorted(path.name for path in (tmp_path / "changed").iterdir()) == ["beam.csv", "section.dat", "wing.ron"]
    assert wingroot.Wing(tmp_path / "changed/wing.ron").hash == changed.hash


def test_a_misspelt_key_is_refused(own_wing):
    wing, _ = own_wing
    with pytest.raises(wingroot.InputError, match="damping"):
        wingroot.Wing.from_dict(wing.to_dict() | {"damping": 0.1}, base=wing.path.parent)
    with pytest.raises(wingroot.InputError, match="damping_ratio"):
        wingroot.Wing.from_dict(wing.to_dict() | {"damping_ratio": 0.9}, base=wing.path.parent)


def test_a_campaign_of_tables_calibrates_as_the_folder_does(data, own_wing):
    wing, corrections = own_wing
    campaign = wingroot.Campaign(data / "own_wing/campaign")
    again = wingroot.Campaign.from_dict(campaign.to_dict() | {"runs": []}, campaign.static)
    found = wingroot.calibrate(wing, again).corrections
    numpy.testing.assert_array_equal(found.moment, corrections.moment)
    assert again.rho_kg_m3 == 1.2 and again.runs == []


def test_corrections_of_arrays_are_the_same_corrections(own_wing):
    wing, corrections = own_wing
    again = wingroot.Corrections.from_arrays(
        wing, corrections.V_m_s, corrections.force, corrections.moment, corrections.pressure_offset
    )
    assert again.path.read_bytes() == corrections.path.read_bytes()
    with pytest.raises(ValueError, match="shape"):
        wingroot.Corrections.from_arrays(wing, [20.0], [[1.0]], [[1.0]], [[0.0]])


def test_effects_are_listed_and_put_into_a_wing(own_wing):
    wing, _ = own_wing
    table = wingroot.Effects.library(["aileron"])
    assert {"alpha_offset", "backlash"} <= set(table["name"])
    changed = wing.with_effects([{"name": "alpha_offset", "parameters": {"alpha_deg": 0.5}}])
    assert len(wing.effects) == 0 and changed.effects[0]["parameters"] == {"alpha_deg": 0.5}
