"""The shipped data, and the program to compare with."""

import os
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture(scope="session")
def data() -> Path:
    return ROOT / "data"


@pytest.fixture(scope="session")
def program():
    """Runs the command line; its binary is WINGROOT, else the one that cargo built here."""
    binary = Path(os.environ.get("WINGROOT", ROOT / "target/debug/wingroot"))
    if not binary.is_file():
        pytest.skip(f"no program {binary} to compare with: cargo build --package wingroot makes it")

    def run(*words: object) -> None:
        subprocess.run([binary, *map(str, words), "--quiet"], check=True)

    return run


@pytest.fixture(scope="session")
def own_wing(data):
    """The shipped wing of one's own, with its corrections."""
    import wingroot

    wing = wingroot.Wing(data / "own_wing/wing.ron")
    return wing, wingroot.calibrate(wing).corrections
