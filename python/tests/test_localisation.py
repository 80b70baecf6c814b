# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
import numpy as np
import pytest

import setsquare


@pytest.fixture(scope="module")
def mapped(simulated_log):
    return setsquare.map_log(simulated_log / "scans.clf")


def test_a_log_is_followed_in_its_own_map(mapped, simulated_log):
    localizer = setsquare.Localizer(setsquare.KnownMap(mapped))
    poses = [
        localizer.add(record.scan, record.T_odom_base)
        for record in setsquare.read_log(simulated_log / "scans.clf")
        if record.kind == "scan"
    ]
    localised = [i for i, pose in enumerate(poses) if pose.status == "localised"]
    assert len(localised) > 0.9 * len(poses)
    truth = mapped.trajectory().poses
    errors = [np.hypot(poses[i].T_map_base.x_m - truth[i][0], poses[i].T_map_base.y_m - truth[i][1])
              for i in localised]
    assert np.mean(errors) < 0.03
    assert poses[-1].covariance.shape == (3, 3)


def test_one_scan_is_located(mapped, simulated_log):
    known = setsquare.KnownMap(mapped.grid())
    assert not known.is_empty
    scan = next(r.scan for r in setsquare.read_log(simulated_log / "scans.clf") if r.kind == "scan")
    located = setsquare.locate(known, scan)
    assert located.status in ("localised", "ambiguous")
    assert located.places and 0.0 < located.places[0].probability <= 1.0
    assert "PossiblePlace" in repr(located.places[0])


def test_errors_have_the_words_of_the_library(tmp_path):
    with pytest.raises(setsquare.FileError):
        setsquare.KnownMap(str(tmp_path / "nothing.yaml"))
