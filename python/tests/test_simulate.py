# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
import types

import numpy as np
import pytest

import setsquare


def test_gives_the_scans_of_the_command(simulated_log):
    drive = setsquare.simulate("office", 11, every_m=0.3)
    written = list(setsquare.read_log(simulated_log / "scans.clf"))
    assert len(drive) == len(written)
    for scan, record in zip(drive.scans, written):
        # What meets nothing is written as the reach of the scanner.
        assert np.minimum(scan.ranges_m, 30.0) == pytest.approx(record.scan.ranges_m, abs=0.002)
    truth = setsquare.Trajectory.read_tum(str(simulated_log / "truth.tum"))
    assert drive.truth.poses == pytest.approx(truth.poses, abs=1e-5)


def test_scans_see_the_walls():
    drive = setsquare.simulate("hall", 3, people=False, every_m=2.0, sweep_time_s=0.0)
    low, high = drive.walls_m.min(axis=(0, 1)), drive.walls_m.max(axis=(0, 1))
    for scan, pose in zip(drive.scans, drive.truth.poses):
        points = setsquare.Pose2(pose).transform(scan.points())
        assert (points > low - 0.3).all() and (points < high + 0.3).all()


def test_the_odometry_is_the_truth_without_drift():
    drive = setsquare.simulate("hallway", 2, every_m=0.5, odometry_drift=False)
    error = setsquare.evaluate_trajectory(drive.odometry, drive.truth)
    assert error.translation_m.max < 1e-6
    drifting = setsquare.simulate("hallway", 2, every_m=0.5)
    assert setsquare.evaluate_trajectory(drifting.odometry, drifting.truth).translation_m.max > 0.01


def test_bounds_lie_about_the_figures():
    drive = setsquare.simulate("hallway", 2, every_m=0.5)
    plain = setsquare.evaluate_trajectory(drive.odometry, drive.truth)
    assert plain.translation_m.bounds is None
    told = setsquare.evaluate_trajectory(drive.odometry, drive.truth, num_resamples=200).translation_m
    assert told.mean == plain.translation_m.mean
    low, high = told.bounds.mean
    assert low < told.mean < high
    assert told.bounds.block_length > 1  # Odometry drifts: neighbouring errors are alike.
    with pytest.raises(setsquare.ParameterError):
        setsquare.evaluate_trajectory(drive.odometry, drive.truth, num_resamples=3)


def test_says_what_it_does_not_know():
    for wrong in ({"building": "castle"}, {"scanner": "sonar"}, {"rate_hz": 0.0}, {"rate_hz": 1e9},
                  {"sweep_time_s": float("nan")}, {"sweep_time_s": -0.1},
                  {"mountings": [(float("nan"), 0, 0)]}):
        with pytest.raises(setsquare.ParameterError):
            setsquare.simulate(**wrong)


def test_maps_what_it_simulates():
    drive = setsquare.simulate("office", 5, every_m=0.3)
    mapper = setsquare.Mapper()
    for scan, odometry in zip(drive.scans, drive.odometry.poses):
        mapper.add(scan, odometry)
    error = setsquare.evaluate_trajectory(mapper.finish().trajectory(), drive.truth)
    assert error.translation_m.rmse < 0.1
    assert np.degrees(error.rotation_rad.rmse) < 0.5


def test_what_only_functions_make_cannot_be_made_empty():
    made = [kind for name in setsquare.__all__ if isinstance(kind := getattr(setsquare, name), type)
            and not issubclass(kind, Exception)
            and isinstance(vars(kind).get("__init__"), types.WrapperDescriptorType)]
    assert setsquare.Map in made and setsquare.ErrorStatistics in made and len(made) > 10
    for kind in made:
        for make in (lambda: kind.__new__(kind), lambda: kind(), lambda: object.__new__(kind)):
            with pytest.raises(TypeError):
                make()
