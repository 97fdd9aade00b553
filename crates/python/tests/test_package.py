"""The package as such: import, threads, progress, figures."""

import subprocess
import sys
import threading
import time

import pytest

import wingroot


def test_it_is_imported_in_a_fifth_of_a_second_and_imports_neither_numpy_nor_pandas():
    code = (
        "import sys, time; start = time.perf_counter(); import wingroot; "
        "print(time.perf_counter() - start, 'numpy' in sys.modules, 'pandas' in sys.modules)"
    )
    runs = [subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True) for _ in range(3)]
    words = [run.stdout.split() for run in runs]
    assert min(float(seconds) for seconds, *_ in words) < 0.2
    assert words[0][1:] == ["False", "False"]


def test_another_thread_runs_meanwhile(data):
    counted, over = 0, threading.Event()

    def count():
        nonlocal counted
        while not over.is_set():
            counted += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    start = time.perf_counter()
    wingroot.Wing(data / "tuflex/wing.ron").modes(4)
    seconds = time.perf_counter() - start
    over.set()
    thread.join()
    # A thread that is let in only between calls counts to a handful.
    assert counted > 100 * seconds


def test_ctrl_c_raises_at_once(data):
    code = (
        "import _thread, threading, wingroot; threading.Timer(0.5, _thread.interrupt_main).start()\n"
        f"wingroot.calibrate({str(data / 'tuflex/wing.ron')!r}, {str(data / 'tuflex/measured')!r})"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert "KeyboardInterrupt" in run.stderr and run.returncode != 0, run.stderr


def test_progress_goes_to_tqdm(data, capfd):
    pytest.importorskip("tqdm")
    # A command that takes seconds on any machine: what is done within a tenth of a second needs no bar.
    wingroot.calibrate(data / "tuflex/wing.ron", data / "tuflex/measured", progress=True)
    assert "airspeeds" in capfd.readouterr().err


def test_a_notebook_shows_the_figures_and_the_table(own_wing, tmp_path):
    found = wingroot.modes(own_wing[0], count=2)
    html = found._repr_html_()
    assert html.count("<img") == len(found.figures) > 0 and "data:image/svg+xml" in html
    assert "<svg" in found.figure(found.figures[0])
    assert str(found) and found.report.is_file()
    kept = found.save(tmp_path / "kept")
    folder = found.folder
    del found
    assert (kept / "result.json").is_file() and not folder.exists()


def test_nothing_is_printed(own_wing, capfd):
    wingroot.modes(own_wing[0], count=2)
    said = capfd.readouterr()
    assert said.out == "" and said.err == ""
