# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Looks at what the map report draws, in a headless Chromium: map_report_test.py WRITE_MAP_REPORT

The argument is the program of write_map_report.cpp. Its room is testing::l_shaped_room(): corners
(0, 0), (8, 0), (8, 5), (3.5, 5), (3.5, 9), (0, 9) in m, with cabinets in two corners.
"""
import math
import subprocess
import sys
import tempfile
import unittest

import chromium
import page_looks as page
from page_looks import (MapReportTest, choose, color, in_window, mark_of, on_map, picture_of, place_of,
                        press, share_near, wall_runs)
from png_pixels import distance

RIGHT, ALONG_X, ALSO_RIGHT, OUTVOTED, WRONG = 0, 1, 2, 3, 4  # Closures, by write_map_report.cpp.


class RoomTest(MapReportTest):
    def assert_near_color(self, pixel, name, tolerance=30):
        self.assertLessEqual(distance(pixel, color(name)), tolerance, f"{pixel} is not {name}")

    def test_walls_stand_where_they_are(self):
        picture = picture_of("#map")
        for x, y in ((2, 0), (8, 3), (6, 5), (3.5, 5.5), (0, 3)):
            column, row = on_map(x, y)
            block = [picture.at(column + a, row + b) for a in range(-3, 4) for b in range(-3, 4)]
            nearest = min(block, key=lambda pixel: distance(pixel, color("wall")))
            self.assert_near_color(nearest, "wall")
        self.assert_near_color(picture.at(*on_map(1, 1)), "free", 4)
        self.assert_near_color(picture.at(*on_map(6, 7)), "unknown", 4)
        # The map's measure by its walls: 8 m from left to right, and a scale bar that agrees.
        runs = wall_runs(picture, on_map(4, 4.5)[1])
        pixels_per_m = (runs[-1] - runs[0]) / 8
        self.assertAlmostEqual(pixels_per_m / page.browser.evaluate("setsquare.map.view.scale"), 1, delta=0.02)
        bar = wall_runs(picture, picture.height - 16, 70)
        ink = [place for place in picture.places(color("ink"), 30) if place[1] > picture.height - 19
               and place[1] < picture.height - 13]
        length_m = (max(ink)[0] - min(ink)[0]) / pixels_per_m
        self.assertTrue(bar)
        self.assertAlmostEqual(length_m, 2, delta=0.08)

    def test_walls_show_however_small_the_map_is(self):
        page.browser.set_size(420, 620)
        page.browser.settle()
        page.browser.evaluate("setsquare.map.view.zoom(0.01)")
        picture = picture_of("#map")
        self.assertGreater(page.browser.evaluate("setsquare.map.image.levels.length"), 1)
        for x, y in ((2, 0), (8, 3), (6, 5), (0, 3)):
            column, row = on_map(x, y)
            block = [picture.at(column + a, row + b) for a in range(-1, 2) for b in range(-1, 2)]
            self.assertLess(min(distance(pixel, color("wall")) for pixel in block), 130, (x, y))

    def test_track_has_the_colours_of_time_or_of_confidence(self):
        places = [on_map(*page.browser.evaluate(f"[setsquare.report.poses.x[{k}], setsquare.report.poses.y[{k}]]"))
                  for k in (20, 60, 100, 228)]
        by_time = picture_of("#map")
        choose("confidence")
        by_confidence = picture_of("#map")
        for column, row in places:
            self.assertGreater(distance(by_time.at(column, row), by_confidence.at(column, row)), 40)
        self.assert_near_color(by_time.at(*places[0]), "time-0", 70)
        self.assert_near_color(by_time.at(*places[-1]), "time-3", 70)
        for place, name in zip(places, ("sigma-0", "sigma-0", "sigma-3", "sigma-0")):
            self.assert_near_color(by_confidence.at(*place), name, 70)
        choose("time")
        self.assertTrue(picture_of("#map").rows == by_time.rows)

    def test_degenerate_and_lost_stretches_are_marked(self):
        picture = picture_of("#map")
        for pose, name in ((45, "degenerate"), (162, "lost")):
            column, row = on_map(*page.browser.evaluate(
                f"[setsquare.report.poses.x[{pose}], setsquare.report.poses.y[{pose}]]"))
            # Beside the track itself: the band, of the colour over the free floor.
            pixel = picture.at(column, row - 5)
            blended = tuple(0.6 * a + 0.4 * b for a, b in zip(color(name), color("free")))
            self.assertLess(distance(pixel, blended), 12, name)

    def test_wheel_drag_and_keys_move_the_map(self):
        before = picture_of("#map")
        row = on_map(4, 4.5)[1]
        runs = wall_runs(before, row)
        middle = in_window((0.5 * (runs[0] + runs[-1]), row))
        left_wall = in_window((runs[0], row))
        page.browser.wheel(*left_wall, 100)  # Away: smaller; what is under the pointer stays.
        after = wall_runs(picture_of("#map"), row)
        self.assertAlmostEqual((after[-1] - after[0]) / (runs[-1] - runs[0]), math.exp(-0.18), delta=0.01)
        self.assertAlmostEqual(after[0], runs[0], delta=1.5)
        page.browser.wheel(*left_wall, -100)
        page.browser.drag(middle, (middle[0] + 30, middle[1] + 10))
        dragged = wall_runs(picture_of("#map"), row + 10)
        self.assertAlmostEqual(dragged[0] - runs[0], 30, delta=1.5)
        page.browser.evaluate("document.getElementById('map').focus()")
        page.browser.key("ArrowLeft")
        moved = wall_runs(picture_of("#map"), row + 10)
        self.assertAlmostEqual(moved[0] - dragged[0], 60, delta=1.5)
        page.browser.key("0")
        page.browser.mouse("mouseMoved", 5, 5)  # Takes the tip away.
        page.browser.evaluate("document.activeElement.blur()")
        self.assertTrue(picture_of("#map").rows == before.rows)

    def test_two_fingers_zoom(self):
        scale = page.browser.evaluate("setsquare.map.view.scale")
        column, row = in_window(on_map(4, 3))
        def touch(kind, spread):
            points = [{"x": column + side * spread, "y": row, "id": k}
                      for k, side in enumerate((-1, 1))] if spread else []
            page.browser.call("Input.dispatchTouchEvent", type=kind, touchPoints=points)
        touch("touchStart", 40)
        for spread in (50, 60, 70, 80):
            touch("touchMove", spread)
        touch("touchEnd", 0)
        page.browser.settle()
        self.assertAlmostEqual(page.browser.evaluate("setsquare.map.view.scale") / scale, 2, delta=0.05)

    def overlay_after_click(self, closure):
        """Clicks a mark on the map; places of the two scans' colours in the second panel."""
        page.browser.click(*in_window(mark_of(closure)))
        self.assertEqual(page.browser.evaluate("document.querySelector('[aria-selected=true]').id"),
                         f"closure-{closure}")
        page.browser.mouse("mouseMoved", 5, 5)
        picture = picture_of("#overlay")
        return picture.places(color("reference"), 40), picture.places(color("current"), 40)

    def test_a_click_on_a_closure_shows_its_two_scans(self):
        self.assert_near_color(picture_of("#map").at(*mark_of(ALSO_RIGHT)), "accepted")
        reference, current = self.overlay_after_click(ALSO_RIGHT)
        self.assertGreater(len(reference), 300)
        self.assertGreater(len(current), 300)
        self.assertGreater(share_near(current, reference, 4), 0.85)
        self.assertIn("verified <by> \"hand\" & eye",
                      page.browser.evaluate("document.getElementById('closure-facts').textContent"))
        # The wrong closure misaligns the scans; where the map has them they agree.
        reference, current = self.overlay_after_click(WRONG)
        self.assertGreater(len(current), 300)
        askew = share_near(current, reference, 4)
        self.assertLess(askew, 0.4)
        choose("map")
        picture = picture_of("#overlay")
        upright = share_near(picture.places(color("current"), 40), picture.places(color("reference"), 40), 4)
        self.assertGreater(upright, 0.85)

    def test_an_axis_that_is_left_open_is_told(self):
        self.overlay_after_click(ALONG_X)
        facts = page.browser.evaluate("document.getElementById('closure-facts').innerText")
        self.assertIn("binds x alone, y is left open", facts)
        # A bar along x: of its colour to the left and right of the middle, not above and below.
        column, row = mark_of(ALONG_X)
        page.browser.click(*in_window(mark_of(RIGHT)))
        page.browser.mouse("mouseMoved", 5, 5)
        picture = picture_of("#map")
        for side in (-5, 5):
            self.assert_near_color(picture.at(column + side, row), "one-axis", 60)
            self.assertGreater(distance(picture.at(column, row + side), color("one-axis")), 60)

    def test_filters_hide_closures_on_the_map_and_in_the_list(self):
        count = lambda: page.browser.evaluate("document.querySelectorAll('#closure-list .row').length")
        at = mark_of(WRONG)
        self.assertEqual(count(), 6)
        self.assert_near_color(picture_of("#map").at(*at), "refused", 60)
        press("filter-refused")
        self.assertEqual(count(), 4)
        self.assertGreater(distance(picture_of("#map").at(*at), color("refused")), 60)
        page.browser.click(*in_window(at))  # Nothing is there any more.
        self.assertNotEqual(page.browser.evaluate("setsquare.shared.selected"), WRONG)
        for kind in ("accepted", "one-axis", "outvoted"):
            press("filter-" + kind)
        self.assertEqual(count(), 0)

    def test_the_list_goes_by_keys(self):
        page.browser.evaluate("document.getElementById('closure-list').focus()")
        seen = []
        for key in ("Home", "ArrowDown", "End", "ArrowUp"):
            page.browser.key(key)
            seen.append(page.browser.evaluate("setsquare.shared.selected"))
        self.assertEqual(seen, [0, 1, 5, 4])

    def test_headings_are_drawn_measured_and_fused(self):
        def counts():
            picture = picture_of("#headings")
            is_inside = lambda place: place[0] > 66 and place[1] < picture.height - 32  # Not the axes.
            return {name: sum(map(is_inside, picture.places(color(name), 8)))
                    for name in ("fused", "tracked", "frame-0", "frame-1")}
        heading = counts()
        for name, number in heading.items():
            self.assertGreater(number, 25, name)
        # Frame 0 measured the first round, frame 1 the second: left and right of the plot.
        picture = picture_of("#headings")
        self.assertLess(max(picture.places(color("frame-0"), 30))[0],
                        min(picture.places(color("frame-1"), 30))[0] + 12)
        choose("drift")
        drift = counts()
        self.assertEqual(drift["frame-0"], 0)
        self.assertGreater(drift["tracked"], 200)
        choose("residual")
        residual = counts()
        self.assertEqual(residual["tracked"], 0)
        self.assertGreater(residual["frame-1"], 25)
        # Time zooms about the pointer.
        left, top, width, height = place_of("#headings")
        page.browser.evaluate("document.getElementById('headings').scrollIntoView()")
        scale = page.browser.evaluate("setsquare.headings.view.scale")
        page.browser.wheel(*in_window((width / 2, height / 2), "#headings"), -300)
        self.assertAlmostEqual(page.browser.evaluate("setsquare.headings.view.scale") / scale, math.exp(0.54), delta=0.01)

    def test_text_stays_text(self):
        title = 'Room </script><b id="injected">"1"</b> & <!-- more'
        self.assertEqual(page.browser.evaluate("document.title"), title)
        self.assertEqual(page.browser.evaluate("document.querySelector('h1').textContent"), title)
        self.assertFalse(page.browser.evaluate("!!document.getElementById('injected')"))
        self.assertIn("Sweeps <of> the laser.",
                      page.browser.evaluate("document.getElementById('figures').textContent"))

    def test_dark_where_the_reader_wants_it_dark(self):
        light = picture_of("#map").at(*on_map(1, 1))
        theme = [{"name": "prefers-color-scheme", "value": "dark"}]
        page.browser.call("Emulation.setEmulatedMedia", features=theme)
        try:
            page.browser.settle()
            dark = picture_of("#map").at(*on_map(1, 1))
            self.assert_near_color(dark, "free", 4)
        finally:
            page.browser.call("Emulation.setEmulatedMedia", features=[])
        self.assertGreater(min(light), 240)
        self.assertLess(max(dark), 80)


class AskewTest(MapReportTest):
    page = "askew.html"

    def test_the_page_stands_as_the_grid_does(self):
        turn = math.radians(20)
        upright = lambda x, y: on_map(math.cos(turn) * x + math.sin(turn) * y,
                                      math.cos(turn) * y - math.sin(turn) * x)
        picture = picture_of("#map")
        for x, y in ((2, 0), (8, 3), (6, 5)):
            column, row = upright(x, y)
            block = [picture.at(column + a, row + b) for a in range(-4, 5) for b in range(-4, 5)]
            self.assertLess(min(distance(pixel, color("wall")) for pixel in block), 40, (x, y))
        # A pose of the second round, at its end.
        pose = page.browser.evaluate("[setsquare.report.poses.x[239], setsquare.report.poses.y[239]]")
        self.assertLess(distance(picture.at(*upright(*pose)), color("end")), 40)


class BareTest(MapReportTest):
    page = "bare.html"

    def test_nothing_is_told_as_nothing(self):
        text = page.browser.evaluate("document.body.innerText")
        for words in ("No scan was mapped.", "This run closed no loop", "This run has no headings"):
            self.assertIn(words, text)
        picture = picture_of("#map")
        self.assertEqual(distance(picture.at(picture.width // 2, picture.height // 2), color("unknown")), 0)


class SingleTest(MapReportTest):
    page = "single.html"

    def test_one_pose_in_an_unknown_map(self):
        picture = picture_of("#map")
        self.assertLess(distance(picture.at(*on_map(5.9, 2.9)), color("end")), 20)
        self.assertTrue(page.browser.evaluate("document.querySelector('input[value=confidence]').disabled"))


def main():
    path = chromium.find()
    if path is None:
        print("skipped: no Chromium here (tools/install_packages browser)")
        return 77
    with tempfile.TemporaryDirectory() as page.folder:
        subprocess.run([sys.argv.pop(1), page.folder], check=True)
        with chromium.Chromium(path) as page.browser:
            return 0 if unittest.main(exit=False, verbosity=2).result.wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
