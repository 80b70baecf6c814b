# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
import xml.etree.ElementTree as ET

import matplotlib
import numpy as np
import pytest

import setsquare
import setsquare.plot

matplotlib.use("Agg")


@pytest.fixture
def answer(room_scan):
    return setsquare.match(room_scan((0, 0, 0)), room_scan((-1, -0.5, 0.4), seed=2))


def drawing(html):
    """The picture at the head of a notebook's cell, as XML."""
    return ET.fromstring(html[: html.index("</svg>") + len("</svg>")])


def test_a_scan_draws_its_points(room_scan):
    path = drawing(room_scan((0, 0, 0))._repr_html_()).find(".//{*}path")
    assert path.get("d").count("M") == 361


def test_a_match_draws_both_scans_and_the_verdict(answer):
    picture = drawing(answer._repr_html_())
    assert len(picture.findall(".//{*}path")) == 2
    assert "matched" in answer._repr_html_()


def test_a_match_without_an_answer_draws_what_there_is():
    nothing = setsquare.Scan([float("nan")] * 20)
    assert len(drawing(setsquare.match(nothing, nothing)._repr_html_()).findall(".//{*}path")) == 1


def test_plots_have_what_they_name(answer, room_scan):
    assert len(setsquare.plot.scan(room_scan((0, 0, 0))).lines[0].get_xdata()) == 361
    axes = setsquare.plot.match(answer)
    assert [line.get_label() for line in axes.lines] == ["reference", "current"]
    assert axes.get_title().startswith("matched")


def test_errors_are_drawn_where_stamps_are_rounded_either_way():
    poses = np.column_stack([np.arange(10.0), np.arange(10.0) ** 2, np.zeros(10)])
    stamps = 1_000_000_000 * np.arange(10)
    rounded = stamps + np.where(np.arange(10) % 2, 400, -400)
    truth = setsquare.Trajectory(rounded, poses)
    line = setsquare.plot.errors(setsquare.Trajectory(stamps, poses), truth).lines[0]
    assert len(line.get_ydata()) == 10 and line.get_ydata().max() < 1e-9


def test_a_map_draws_itself(simulated_log):
    mapped = setsquare.map_log(simulated_log / "scans.clf")
    assert mapped._repr_png_().startswith(b"\x89PNG")
    assert "data:image/png;base64," in mapped._repr_html_()
    axes = setsquare.plot.map(mapped)
    assert len(axes.images) == 1 and len(axes.lines) == 1
    truth = setsquare.Trajectory.read_tum(str(simulated_log / "truth.tum"))
    line = setsquare.plot.errors(mapped.trajectory(), truth).lines[0]
    assert 0.0 < line.get_ydata().max() < 0.3


def test_a_maps_title_stays_within_a_narrow_figure(simulated_log):
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(2.5, 3))
    setsquare.plot.map(setsquare.map_log(simulated_log / "scans.clf"), axes)
    figure.canvas.draw()
    pixels = np.asarray(figure.canvas.buffer_rgba())
    assert pixels.min() < 128, "something is drawn"
    assert (pixels[:, :2] == 255).all() and (pixels[:, -2:] == 255).all(), "nothing is cut off"
