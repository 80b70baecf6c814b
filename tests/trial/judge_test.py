# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""The judge of benchmarks/trial_ground: bent, squashed and mirrored maps are wrong and silent, those
that say so are not; and what the faults do to a log."""
import dataclasses
import json
import math
import pathlib
import random
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "benchmarks"))

from trial import faults  # noqa: E402 (after the path is set)
from trial.judge import MappedPose, judge  # noqa: E402
from trial.outputs import _largest_sigma, _mapped_pose, mapped_poses  # noqa: E402

# 30 m along x, then 10 m along y, a pose every 0.1 m.
TRUTH = ([(0.1 * k, 0.0, 0.0) for k in range(300)] +
         [(30.0, 0.1 * k, math.pi / 2) for k in range(100)])


def moved(pose, x, y, turn):
    c, s = math.cos(turn), math.sin(turn)
    return (x + c * pose[0] - s * pose[1], y + s * pose[0] + c * pose[1], pose[2] + turn)


def right_map(sigma_m=0.01):
    return [MappedPose(moved(pose, 3.0, -2.0, 0.7), sigma_m) for pose in TRUTH]


def bent_map(angle_deg=20.0, **of_the_bent_half):
    """All from the corner on turned about it by a wrong angle."""
    bend = math.radians(angle_deg)
    bent = [(30.0 - 0.1 * k * math.sin(bend), 0.1 * k * math.cos(bend), math.pi / 2 + bend)
            for k in range(100)]
    return right_map()[:300] + [dataclasses.replace(MappedPose(moved(pose, 3.0, -2.0, 0.7), 0.01),
                                                    **of_the_bent_half) for pose in bent]


def squashed_map(sigma_at_end_m):
    """The first 30 m are 20 m long; the spread grows along them."""
    squashed = [(min(x, 20.0) if x < 29.99 else 20.0, y, h) for x, y, h in TRUTH]
    return [MappedPose(pose, 0.01 + sigma_at_end_m * min(k, 300) / 300)
            for k, pose in enumerate(squashed)]


class Judge(unittest.TestCase):
    def test_a_right_map_in_another_frame_is_right(self):
        verdict = judge(TRUTH, right_map())
        self.assertEqual((verdict.num_wrong, verdict.num_beyond, verdict.num_placed), (0, 0, 400))
        self.assertLess(max(verdict.errors_m), 1e-9)

    def test_a_bent_map_is_wrong_and_silent(self):
        verdict = judge(TRUTH, bent_map())
        self.assertTrue(verdict.is_wrong_and_silent)
        self.assertGreater(verdict.num_silent, 50)

    def test_a_bend_of_a_degree_is_no_wrong_map(self):
        self.assertEqual(judge(TRUTH, bent_map(1.0)).num_wrong, 0)

    def test_a_doubt_in_its_place_ends_the_silence(self):
        verdict = judge(TRUTH, bent_map(doubts=("few_beams",)))
        self.assertFalse(verdict.is_wrong_and_silent)
        self.assertGreater(verdict.num_wrong, 50)
        self.assertEqual(verdict.doubts, ("few_beams",))

    def test_what_is_doubted_does_not_turn_what_is_not(self):
        verdict = judge(TRUTH, bent_map(60.0, doubts=("contradicting pairs",)))
        self.assertLess(max(verdict.errors_deg[:300]), 1e-6)
        self.assertEqual((verdict.num_silent, verdict.num_wrong), (0, 100))
        self.assertGreater(min(judge(TRUTH, bent_map(60.0)).errors_deg[:300]), 1.0)

    def test_a_doubt_elsewhere_does_not(self):
        mapped = bent_map()
        mapped[10].doubts = ("few_beams",)
        self.assertTrue(judge(TRUTH, mapped).is_wrong_and_silent)

    def test_what_has_no_place_is_not_wrong(self):
        verdict = judge(TRUTH, bent_map(is_placed=False))
        self.assertEqual((verdict.num_wrong, verdict.num_placed), (0, 300))
        missing = right_map()[:300] + [None] * 100
        self.assertEqual(judge(TRUTH, missing).num_placed, 300)

    def test_a_spread_of_positions_does_not_excuse_a_heading(self):
        self.assertTrue(judge(TRUTH, bent_map(sigma_m=50.0)).is_wrong_and_silent)

    def test_a_heading_is_silent_unless_its_own_spread_is_honest(self):
        self.assertTrue(judge(TRUTH, bent_map(sigma_m=50.0, sigma_deg=2.0)).is_wrong_and_silent)
        honest = judge(TRUTH, bent_map(sigma_m=50.0, sigma_deg=10.0))
        self.assertEqual((honest.num_wrong, honest.num_turned), (0, 0))
        self.assertTrue(judge(TRUTH, bent_map(sigma_deg=10.0)).is_wrong_and_silent)  # Far off, too.

    def test_headings_are_judged_by_their_own_spreads(self):
        turned = [dataclasses.replace(pose, pose=(*pose.pose[:2], pose.pose[2] + math.radians(off)),
                                      sigma_deg=0.5)
                  for pose, off in zip(right_map(), [1.0, -1.0] * 200)]
        told = judge(TRUTH, turned).as_json()
        self.assertAlmostEqual(told["heading_squares"] / told["placed"], 4.0, delta=0.1)
        self.assertAlmostEqual(told["heading_median_deg"], 1.0, delta=0.02)
        self.assertEqual(told["heading_sigma_deg"], 0.5)
        self.assertEqual(told["turned"], 0)

    def test_a_squashed_corridor_is_silent_unless_its_spread_is_honest(self):
        self.assertTrue(judge(TRUTH, squashed_map(0.7)).is_wrong_and_silent)
        honest = judge(TRUTH, squashed_map(9.0))
        self.assertEqual(honest.num_wrong, 0)
        self.assertGreater(max(honest.errors_m), 5.0)

    def test_a_mirrored_map_is_wrong_and_silent(self):
        mirrored = [MappedPose((x, -y, -h), 0.01) for x, y, h in TRUTH]
        self.assertTrue(judge(TRUTH, mirrored).is_wrong_and_silent)

    def test_errors_below_half_a_metre_count_only_against_the_spread(self):
        mapped = [MappedPose((x * 1.01, y, h), 0.01) for x, y, h in TRUTH]
        verdict = judge(TRUTH, mapped)
        self.assertEqual(verdict.num_wrong, 0)
        self.assertGreater(verdict.num_beyond, 100)

    def test_a_map_without_poses(self):
        verdict = judge(TRUTH, [None] * len(TRUTH))
        self.assertEqual((verdict.num_placed, verdict.num_silent), (0, 0))


def log():
    """A robot that drives a circle; its odometry is exact."""
    scans = []
    for k in range(100):
        heading = 0.02 * k
        pose = (5 * math.sin(heading), 5 - 5 * math.cos(heading), heading)
        scans.append({"stamp": 0.1 * k, "truth": pose, "odometry": list(pose), "angle_min": -1.0,
                      "angle_step": 0.1, "range_max": 30, "ranges": [2.0 + 0.1 * j for j in range(20)] + ["inf"]})
    return scans


class Faults(unittest.TestCase):
    def spoilt(self, fault):
        return fault(log(), random.Random(1))

    def test_what_is_kept_keeps_its_truth_and_the_log_is_not_changed(self):
        clean = log()
        for fault in (faults.odometry_frozen(0.3), faults.dust(0.2), faults.posts(2, 9.0),
                      faults.stuck(1.0), faults.carried(1.0, True), faults.short_sight(3.0),
                      faults.noisy(0.05), faults.missing(0.5), faults.every_beam(2), faults.glass(0.5),
                      faults.field_of_view(60.0), faults.people(3)):
            for before, after in zip(clean, fault(clean, random.Random(1)), strict=True):
                self.assertEqual(before["truth"], after["truth"])
        self.assertEqual(clean, log())

    def test_a_carried_robot_moves_and_its_wheels_rest(self):
        for is_seen in (True, False):
            scans = self.spoilt(faults.carried(1.0, is_seen))
            jump = [math.dist(s["truth"][:2], s["odometry"][:2]) for s in scans]
            self.assertAlmostEqual(max(jump[:50]), 0.0, places=6)
            self.assertGreater(jump[-1], 0.5)
        self.assertLess(len(scans), 100)

    def test_odometry(self):
        scaled = self.spoilt(faults.odometry_scaled(1.5))
        way = sum(math.dist(a["odometry"][:2], b["odometry"][:2]) for a, b in zip(scaled, scaled[1:]))
        self.assertAlmostEqual(way, 1.5 * 99 * 10 * math.sin(0.01), places=6)
        self.assertEqual(self.spoilt(faults.odometry_delayed(1.0))[50]["odometry"], log()[40]["odometry"])
        self.assertEqual(max(s["odometry"][0] for s in self.spoilt(faults.odometry_jump(1e22))), 1e22)

    def test_stops_and_gaps(self):
        stopped = self.spoilt(faults.stops(2, 3.0))
        self.assertEqual(len(stopped), 160)
        steps = [b["stamp"] - a["stamp"] for a, b in zip(stopped, stopped[1:])]
        self.assertLess(max(abs(step - 0.1) for step in steps), 1e-9)
        self.assertEqual(len({tuple(s["ranges"]) for s in stopped[33:60]}), 27)  # Fresh noise.
        self.assertEqual(len(self.spoilt(faults.paused(2.05))), 80)

    def test_scans(self):
        self.assertEqual(self.spoilt(faults.stuck(1.0))[55]["ranges"], log()[50]["ranges"])
        again = self.spoilt(faults.sent_again(5))
        self.assertEqual((again[13]["ranges"], again[13]["truth"]), (log()[10]["ranges"], log()[10]["truth"]))
        self.assertEqual((again[13]["stamp"], again[13]["odometry"]), (log()[13]["stamp"], log()[13]["odometry"]))
        dusty = sum(r != s for r, s in zip(self.spoilt(faults.dust(0.5))[0]["ranges"], log()[0]["ranges"]))
        self.assertIn(dusty, range(4, 17))
        self.assertEqual(self.spoilt(faults.short_sight(3.0))[0]["ranges"][-5:], ["inf"] * 5)
        self.assertIn(self.spoilt(faults.missing(0.5))[0]["ranges"].count("inf"), range(5, 19))

    def test_fewer_beams_see_the_same_in_the_same_directions(self):
        def seen(scan):
            return {round(scan["angle_min"] + k * scan["angle_step"], 9): r for k, r in enumerate(scan["ranges"])}
        whole = seen(log()[0])
        for fault, num in ((faults.every_beam(2), 11), (faults.field_of_view(math.degrees(1.0)), 11)):
            few = seen(self.spoilt(fault)[0])
            self.assertEqual(len(few), num)
            self.assertLessEqual(few.items(), whole.items())

    def test_fewer_scans(self):
        self.assertEqual(self.spoilt(faults.every_scan(8)), log()[::8])
        kept = self.spoilt(faults.key_frames(1.0, 30.0))
        ways = [math.dist(a["truth"][:2], b["truth"][:2]) for a, b in zip(kept, kept[1:])]
        self.assertTrue(all(1.0 <= way < 1.2 for way in ways), ways)

    def test_glass_is_where_it_is_and_people_walk(self):
        once, again = self.spoilt(faults.glass(0.5)), faults.glass(0.5)(log(), random.Random(1))
        self.assertEqual(once, again)
        self.assertIn(sum(s["ranges"].count("inf") for s in once) - 100, range(500, 1501))
        walked = self.spoilt(faults.people(8))
        nearer = [sum(a != b for a, b in zip(s["ranges"], t["ranges"])) for s, t in zip(walked, log())]
        self.assertGreater(sum(nearer), 50)
        for spoilt, clean in zip(walked, log()):
            self.assertTrue(all(b == "inf" or a <= b for a, b in zip(spoilt["ranges"], clean["ranges"])))


class Outputs(unittest.TestCase):
    def test_doubts_of_the_map_count_where_they_are(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder)
            doubts = [{"kind": "crossed walls", "first_scan": 1, "num_scans": 2},
                      {"kind": "unknown length", "first_scan": 0, "num_scans": 4}]
            (path / "run.json").write_text(json.dumps(
                {"findings": [], "open_stretches": [], "doubts": doubts}))
            rows = ["\t".join(("stamp", *self.ROW))]
            rows += ["\t".join((str(k), *self.ROW.values())) for k in range(4)]
            (path / "poses.tsv").write_text("\n".join(rows) + "\n")
            mapped, _ = mapped_poses(path)
        self.assertEqual([pose.doubts for pose in mapped.values()],
                         [(), ("crossed walls",), ("crossed walls",), ()])

    ROW = {"x_m": "1", "y_m": "2", "heading_deg": "90", "sigma_x_m": "0.3", "sigma_y_m": "0.4",
           "correlation_xy": "0", "sigma_heading_deg": "7", "placed": "1", "doubts": "heading_open"}

    def test_the_largest_sigma_of_a_position(self):
        self.assertAlmostEqual(_largest_sigma(0.3, 0.4, 0.0), 0.4)
        self.assertAlmostEqual(_largest_sigma(0.3, 0.4, 1.0), 0.5)

    def test_a_wide_spread_is_no_doubt_of_its_own(self):
        pose = _mapped_pose(self.ROW, ("few_beams",))
        self.assertEqual((pose.sigma_m, pose.sigma_deg, pose.is_placed), (0.4, 7.0, True))
        self.assertEqual(pose.doubts, ("few_beams",))

    def test_lost_scans_and_pieces_have_no_place(self):
        lost = _mapped_pose({**self.ROW, "doubts": "lost,heading_open"}, ())
        self.assertEqual((lost.is_placed, lost.doubts), (False, ("lost",)))
        apart = _mapped_pose({**self.ROW, "placed": "0", "sigma_x_m": "inf", "doubts": "not_joined"}, ())
        self.assertEqual((apart.is_placed, apart.doubts), (False, ("not_joined",)))


if __name__ == "__main__":
    unittest.main()
