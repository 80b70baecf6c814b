# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""What tests of a map report look at: colours, pictures and places of the page in the browser."""
import math
import unittest

from png_pixels import Picture, distance

browser = None  # The chromium.Chromium that all tests share, and ...
folder = None   # ... where the pages are: the test program sets both.


def color(name):
    """A colour of the style sheet, as (red, green, blue)."""
    text = browser.evaluate(
        f"getComputedStyle(document.documentElement).getPropertyValue('--{name}').trim()")
    return tuple(int(text[k:k + 2], 16) for k in (1, 3, 5))


def place_of(selector):
    """(left, top, width, height) of an element on the page, in whole pixels inside it."""
    left, top, width, height = browser.evaluate(
        f"(() => {{ const r = document.querySelector('{selector}').getBoundingClientRect();"
        " return [r.left + scrollX, r.top + scrollY, r.width, r.height]; })()")
    return math.ceil(left), math.ceil(top), math.floor(width) - 1, math.floor(height) - 1


def picture_of(selector):
    browser.settle()
    return Picture(browser.screenshot(place_of(selector)))


def on_map(x, y):
    """The pixel of the map's canvas where a place of the map frame is, in m."""
    return browser.evaluate(f"[setsquare.map.view.column({x}), setsquare.map.view.row({y})]")


def mark_of(closure):
    return browser.evaluate("[setsquare.map.view.column(setsquare.map.marks.u[%d]),"
                            " setsquare.map.view.row(setsquare.map.marks.v[%d])]" % (closure, closure))


def in_window(pixel, selector="#map"):
    left, top, _, _ = place_of(selector)
    scroll = browser.evaluate("scrollY")
    return left + pixel[0], top + pixel[1] - scroll


def choose(value):
    browser.evaluate(f"document.querySelector('input[value={value}]').click()")
    browser.settle()


def press(identifier):
    browser.evaluate(f"document.getElementById('{identifier}').click()")
    browser.settle()


def wall_runs(picture, row, tolerance=40):
    """Middles of the dark runs of a row: walls that cross it."""
    wall = color("wall")
    middles, start = [], None
    for column in range(picture.width + 1):
        is_dark = column < picture.width and distance(picture.at(column, row), wall) < tolerance
        if is_dark and start is None:
            start = column
        elif not is_dark and start is not None:
            middles.append(0.5 * (start + column - 1))
            start = None
    return middles


def share_near(places, others, reach):
    """Share of the places that have one of the others within a few pixels."""
    taken = set(others)
    near = [(a, b) for a in range(-reach, reach + 1) for b in range(-reach, reach + 1)]
    hits = sum(any((column + a, row + b) in taken for a, b in near) for column, row in places)
    return hits / max(len(places), 1)


class MapReportTest(unittest.TestCase):
    page = "room.html"

    def setUp(self):
        browser.set_size(1100, 760)
        browser.open(f"{folder}/{self.page}")
        browser.evaluate("scrollTo(0, 0)")

    def tearDown(self):
        for event in browser.events:
            method, params = event["method"], event["params"]
            self.assertNotIn(method, ("Runtime.exceptionThrown", "Runtime.consoleAPICalled"), params)
            self.assertNotEqual(method, "Log.entryAdded", params)
            if method == "Network.requestWillBeSent":
                self.assertRegex(params["request"]["url"], "^(file|data):")
