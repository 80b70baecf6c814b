# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""python compare_matchers.py LOG TRUTH.tum: a matcher of one's own against Setsquare's.

Pairs of scans ten scans apart; the error of each answer against the true poses. No answer counts as
no motion.
"""
import sys

import numpy as np

import setsquare


def by_centroids(reference, current):
    """Your matcher here: this one lays the means of the points onto each other."""
    return setsquare.Pose2(*(reference.points().mean(axis=0) - current.points().mean(axis=0)), 0.0)


def by_setsquare(reference, current):
    return setsquare.match(reference, current).T_reference_current or setsquare.Pose2()


scans = [record.scan for record in setsquare.read_log(sys.argv[1])]
truth = setsquare.Trajectory.read_tum(sys.argv[2])
pose_at = dict(zip(truth.stamps_ns, (setsquare.Pose2(pose) for pose in truth.poses)))
for matcher in by_centroids, by_setsquare:
    errors = [
        (pose_at[a.stamp_ns].inverse() * pose_at[b.stamp_ns]).inverse() * matcher(a, b)
        for a, b in zip(scans, scans[10:])
    ]
    print(f"{matcher.__name__}: median error {np.median([np.hypot(e.x_m, e.y_m) for e in errors]):.3f} m,"
          f" {np.median([abs(e.theta_deg) for e in errors]):.2f} deg in {len(errors)} pairs")
