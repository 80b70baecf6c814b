# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
import copy
import math
import pickle

import numpy as np
import pytest

import setsquare


def test_ranges_are_the_scans_own_memory():
    scan = setsquare.Scan([1.0, 2.0, 3.0])
    view = scan.ranges_m
    assert np.shares_memory(view, scan.ranges_m)
    assert not view.flags.writeable
    del scan
    assert view.tolist() == [1.0, 2.0, 3.0]  # The view keeps the scan alive.


def test_any_array_of_numbers_will_do():
    for ranges in ([1, 2, 3], np.array([1, 2, 3], dtype=np.float32), np.arange(1, 7)[::2] // 2 + 1):
        assert len(setsquare.Scan(ranges)) == 3
    with pytest.raises(setsquare.ParameterError, match="shape"):
        setsquare.Scan(np.ones((2, 2)))


def test_the_field_of_view_gives_the_bearings():
    assert setsquare.Scan(np.ones(181), fov_deg=180).bearing_step_rad == pytest.approx(math.radians(1))
    assert setsquare.Scan(np.ones(360), fov_deg=360).bearing_step_rad == pytest.approx(math.radians(1))
    scan = setsquare.Scan(np.ones(3), first_bearing_rad=0.5, bearing_step_rad=-0.1)
    assert scan.bearings_rad == pytest.approx([0.5, 0.4, 0.3])
    for wrong in ({"fov_deg": -5}, {"fov_deg": 400}, {"first_bearing_rad": 0.0},
                  {"fov_deg": 180, "first_bearing_rad": 0.0, "bearing_step_rad": 0.1}):
        with pytest.raises(setsquare.ParameterError):
            setsquare.Scan(np.ones(3), **wrong)
    with pytest.raises(setsquare.ParameterError, match="fov_deg"):
        setsquare.match(np.ones(3), np.ones(3), fov_deg=361)


def test_points_are_the_returns_alone():
    scan = setsquare.Scan([1.0, np.nan, 0.0, 9.0, 2.0], fov_deg=180, max_range_m=5.0)
    assert scan.points() == pytest.approx(np.array([[0.0, -1.0], [0.0, 2.0]]), abs=1e-12)


def test_stamps_are_exact():
    assert setsquare.Scan([1.0], stamp_ns=976052857337530001).stamp_ns == 976052857337530001
    assert setsquare.Scan([1.0], stamp_s=1.5).stamp_ns == 1_500_000_000
    with pytest.raises(setsquare.ParameterError, match="stamp_s"):
        setsquare.Scan([1.0], stamp_s=math.nan)


def test_scans_and_poses_go_to_other_processes():
    scan = setsquare.Scan([1.0, math.nan, 3.0], fov_deg=90, stamp_ns=7, scanner=2, max_range_m=5.0,
                          T_base_sensor=(1, 2, 3), time_increment_s=0.1, scan_time_s=0.5)
    for again in (pickle.loads(pickle.dumps(scan)), copy.deepcopy(scan)):
        assert np.array_equal(again.ranges_m, scan.ranges_m, equal_nan=True)
        for name in ("first_bearing_rad", "bearing_step_rad", "min_range_m", "max_range_m", "scanner",
                     "T_base_sensor", "stamp_ns", "time_increment_s", "scan_time_s"):
            assert getattr(again, name) == getattr(scan, name)


def test_poses_chain_and_are_taken_as_three_numbers():
    a, b = setsquare.Pose2(1, 2, 0.5), setsquare.Pose2(-0.3, 0.1, 2.9)
    assert list((a * b) * (a * b).inverse()) == pytest.approx([0, 0, 0])
    points = np.array([[1.0, 0.0], [0.0, 2.0]])
    assert (a * b).transform(points) == pytest.approx(a.transform(b.transform(points)))
    assert setsquare.Scan([1.0], T_base_sensor=(1, 2, 3)).T_base_sensor == setsquare.Pose2(1, 2, 3)
    assert setsquare.Scan([1.0], T_base_sensor=np.array([1, 2, 3.0])).T_base_sensor.y_m == 2
    for wrong in ((1, 2), "abc"):
        with pytest.raises((TypeError, ValueError)):
            setsquare.Scan([1.0], T_base_sensor=wrong)


def test_a_scan_does_not_change_by_its_mounting():
    scan = setsquare.Scan([1.0], T_base_sensor=(1, 2, 3))
    with pytest.raises(AttributeError):
        scan.T_base_sensor.x_m = 5.0
    assert scan.T_base_sensor.x_m == 1.0


def test_trajectories_are_arrays_and_files(tmp_path):
    stamps = np.array([1_000_000_000, 2_000_000_000])
    poses = np.array([[0.0, 0.0, 0.0], [1.0, 2.0, 0.5]])
    trajectory = setsquare.Trajectory(stamps, poses)
    trajectory.save_tum(tmp_path / "t.tum")
    again = setsquare.Trajectory.read_tum(str(tmp_path / "t.tum"))
    assert np.array_equal(again.stamps_ns, stamps)
    assert again.poses == pytest.approx(poses, abs=1e-6)
    assert setsquare.evaluate_trajectory(again, trajectory).translation_m.rmse < 1e-6
    with pytest.raises(ValueError, match="shape"):
        setsquare.Trajectory(stamps, poses[:1])
