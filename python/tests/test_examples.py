# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""The examples run as they stand, and do what they say."""
import os
import pathlib
import re
import subprocess
import sys

import pytest

EXAMPLES = pathlib.Path(__file__).resolve().parents[1] / "examples"


def run(name, *arguments):
    environment = {**os.environ, "MPLBACKEND": "Agg"}
    done = subprocess.run([sys.executable, "-B", str(EXAMPLES / name), *map(str, arguments)],
                          check=True, capture_output=True, text=True, env=environment)
    return done.stdout


def test_map_a_log(simulated_log, tmp_path):
    assert run("map_a_log.py", simulated_log / "scans.clf", tmp_path).startswith("consistent")
    assert (tmp_path / "map.png").exists() and (tmp_path / "plot.svg").exists()


def test_compare_matchers(simulated_log):
    lines = run("compare_matchers.py", simulated_log / "scans.clf", simulated_log / "truth.tum")
    errors_m = [float(text) for text in re.findall(r"error ([0-9.]+) m", lines)]
    assert len(errors_m) == 2
    assert errors_m[1] < 0.05 < errors_m[0]


def test_map_many_logs(simulated_log, tmp_path):
    pytest.importorskip("distributed")
    (tmp_path / "empty.clf").write_text("")
    lines = run("map_many_logs.py", tmp_path / "maps", simulated_log / "scans.clf", tmp_path / "empty.clf",
                "--workers", 2)
    assert "2 of 2" in lines
    header, mapped, empty = (tmp_path / "maps/logs.tsv").read_text().splitlines()
    assert header.startswith("log\tscans\tverdict")
    assert "consistent" in mapped and "error" in empty
    assert (tmp_path / "maps/scans/map.png").exists()
