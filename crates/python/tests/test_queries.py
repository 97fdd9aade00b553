"""The queries of docs/scale.md, answered by DuckDB from the table of station loads, beside the same cases as CSV."""

import csv
import os
import re
import time
from pathlib import Path

import pytest

duckdb = pytest.importorskip("duckdb", reason="DuckDB's Python package is not here: queries are not run")

ROOT = Path(__file__).resolve().parents[3]
SLOW = "RUN_SLOW_TESTS" in os.environ
# 2 models, 16 airspeeds, (2 + RATES x 2) trims; with RUN_SLOW_TESTS a hundred thousand
RATES = 1562 if SLOW else 20
CASES = """Cases(
    name: "rolls",
    airspeeds_V_m_s: [{airspeeds}],
    load_factors: [0.0, 3.0],
    maneuvers: [Pull, Roll(control: "outer", rates_deg_s: [{rates}])],
    stations: [(name: "half", y_m: 0.9)],
)
"""
TABLE = "out/sweep/station_loads"


@pytest.fixture(scope="module")
def loads(tmp_path_factory, program) -> Path:
    """A folder with the results in out/sweep, as the queries name them."""
    folder = tmp_path_factory.mktemp("queries")
    airspeeds = ", ".join(f"{25 + 0.75 * i}" for i in range(16))
    rates = ", ".join(f"{1 + i * 60 / RATES:.6f}" for i in range(RATES))
    (folder / "cases.ron").write_text(CASES.format(airspeeds=airspeeds, rates=rates))
    aircraft, wing = ROOT / "data/tuflex/aircraft.ron", ROOT / "data/tuflex/wing_beam.ron"
    words = ["--aircraft", aircraft, "--wing", wing, "--campaign", ROOT / "data/tuflex/measured"]
    program("fullaircraft", *words, "--cases", folder / "cases.ron", "--out", folder / "out/sweep")
    return folder


@pytest.fixture(scope="module")
def rows(loads) -> list[dict]:
    """All cases as CSV has them: a row a case, a column a station, load and end."""
    with (loads / "out/sweep/cases.csv").open() as text:
        return list(csv.DictReader(text))


def ask(number: int, loads, monkeypatch) -> list[dict]:
    """The answer of a query of the document."""
    queries = re.findall(r"```sql\n(.*?)```", (ROOT / "docs/scale.md").read_text(), re.DOTALL)
    assert len(queries) == 4
    monkeypatch.chdir(loads)
    found = duckdb.sql(queries[number])
    return [dict(zip(found.columns, row)) for row in found.fetchall()]


def test_worst_root_bending_by_mass_and_station_is_that_of_the_cases(loads, rows, monkeypatch):
    start = time.perf_counter()
    found = ask(0, loads, monkeypatch)
    seconds = time.perf_counter() - start
    print(f"{len(rows)} cases: {seconds:.3f} s")
    assert seconds < 1.0
    worst = {}
    for station in ["right root", "left root", "half", "left half"]:
        column = f"{station.replace(' ', '_')}_Mx_Nm_max"
        if column in rows[0]:
            values = [float(row[column]) for row in rows if row["model"] == "updated" and row[column]]
            worst[station] = max(values)
    assert {row["station"]: row["largest_Mx_Nm"] for row in found}.items() >= worst.items() and len(worst) >= 3
    assert len({row["mass_kg"] for row in found}) == 1 and isinstance(found[0]["mass_kg"], float)


def test_the_ten_worst_of_a_kind_are_those_of_the_cases(loads, rows, monkeypatch):
    found = ask(1, loads, monkeypatch)
    of_kind = [row for row in rows if row["maneuver"].startswith("roll") and row["model"] == "updated"]
    values = sorted((float(row["right_root_Mx_Nm_max"]) for row in of_kind), reverse=True)
    assert [row["Mx_max_Nm"] for row in found] == values[:10]
    for row in found:
        case = rows[row["case_number"]]
        assert (case["maneuver"], float(case["V_m_s"])) == (row["maneuver"], row["V_m_s"])


def test_updated_over_initial_by_kind_and_station_is_that_of_the_cases(loads, rows, monkeypatch):
    found = {(row["kind"], row["station"]): row["ratio"] for row in ask(2, loads, monkeypatch)}
    for kind in ["roll", "pull_up", "push_down"]:
        def largest(model: str) -> float:
            own = [row for row in rows if row["maneuver"].startswith(kind) and row["model"] == model]
            return max(float(row["right_root_Mx_Nm_max"]) for row in own)

        assert found[kind, "right root"] == pytest.approx(largest("updated") / largest("initial"), rel=1e-14)


def test_every_load_says_its_unit(loads, monkeypatch):
    units = {row["name"]: row["unit"] for row in ask(3, loads, monkeypatch)}
    assert units["unit:Fz_max_N"] == "N" and units["unit:Mx_max_Nm"] == "N m" and units["unit:V_m_s"] == "m/s"
