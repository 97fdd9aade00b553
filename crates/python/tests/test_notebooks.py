"""The notebooks run, and are kept without outputs."""

import json
import os
from pathlib import Path

import pytest

NOTEBOOKS = sorted((Path(__file__).parents[1] / "notebooks").glob("*.ipynb"))
# Calibrates, searches for effects and flies all that the papers show: one and a half minutes.
LONG = {"paper"}


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs_and_is_kept_without_outputs(path, tmp_path):
    cells = json.loads(path.read_text())["cells"]
    assert not any(cell.get("outputs") or cell.get("execution_count") for cell in cells)
    nbformat, nbclient = pytest.importorskip("nbformat"), pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    if path.stem in LONG and "RUN_SLOW_TESTS" not in os.environ:
        pytest.skip("RUN_SLOW_TESTS=1 runs this notebook (a minute and a half)")
    notebook = nbformat.read(path, as_version=4)
    nbclient.NotebookClient(notebook, timeout=600, resources={"metadata": {"path": tmp_path}}).execute()
    assert not list(tmp_path.iterdir()), "a notebook leaves nothing where it was started"


def test_there_are_two():
    assert [path.stem for path in NOTEBOOKS] == ["own_wing", "paper"]
