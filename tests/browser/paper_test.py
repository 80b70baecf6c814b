# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Looks at the page of the paper's experiments in a headless Chromium: paper_test.py SETSQUARE_EXPERIMENT

The argument is the program setsquare-experiment, which makes the page from a quick run.
"""
import json
import os
import subprocess
import sys
import tempfile
import unittest

import chromium

SECTIONS = ("section_5_1", "buildings", "section_5_2", "honesty")


class PaperTest(unittest.TestCase):
    """Class attributes `browser`, `folder` and `paper` are set by main()."""

    def open(self, width):
        self.browser.set_size(width, 900)
        self.browser.open(os.path.join(self.folder, "paper.html"), "true")

    def tearDown(self):
        for event in self.browser.events:
            method, params = event["method"], event["params"]
            self.assertNotIn(method, ("Runtime.exceptionThrown", "Runtime.consoleAPICalled"), params)
            self.assertNotEqual(method, "Log.entryAdded", params)
            if method == "Network.requestWillBeSent":
                self.assertRegex(params["request"]["url"], "^(file|data):")

    def texts(self, selector):
        return self.browser.evaluate(
            f"[...document.querySelectorAll({json.dumps(selector)})].map(one => one.innerText)")

    def test_the_statements_of_the_paper_come_first(self):
        self.open(1200)
        rows = self.texts(".statements tbody tr")
        self.assertEqual(len(rows), 7)
        first_table = self.browser.evaluate("document.querySelector('table').className")
        self.assertEqual(first_table, "statements")
        closure = self.paper["section_5_2"]["median_closure_errors"]
        for row, stated, place in ((rows[4], "0.85", 0), (rows[5], "1.30", 1)):
            self.assertEqual(row.split("\t")[1], stated)
            for method, column in (("paper", 2), ("default", 3), ("full_mapper", 4)):
                self.assertEqual(row.split("\t")[column], f"{closure[method]['norm_m'][place]:.3f}")
        page = self.browser.evaluate("document.body.innerText")
        self.assertNotIn("must", page.split())
        for unknown in ("NaN", "undefined", "[object"):
            self.assertNotIn(unknown, page)

    def test_every_section_that_was_run_is_drawn(self):
        self.open(1200)
        self.assertEqual(self.browser.evaluate("[...document.querySelectorAll('section')].map(one => one.id)"),
                         list(SECTIONS))
        classes = self.texts("#buildings tbody")[0].strip().split("\n")
        summary = self.paper["buildings"]["by_class"][-1]
        self.assertEqual(classes[-1].split("\t")[:3],
                         ["all", str(summary["num_pairs"]),
                          str(summary["default"]["determined_overlap_45_and_more"]["num_pairs"])])
        self.assertEqual(len(self.texts("#honesty tbody tr")), 7)
        cells = self.texts("#section_5_1 table.matrix td")
        self.assertIn("S", cells)
        self.assertEqual(self.browser.evaluate(
            "[...document.images].every(image => image.complete && image.naturalWidth > 300)"), True)
        self.assertEqual(self.browser.evaluate("document.images.length"), 3)
        self.assertEqual(self.browser.evaluate("document.querySelectorAll('.chart svg .curve').length"), 7 + 6)

    def test_says_how_to_get_a_column_that_is_left_out(self):
        self.open(1200)
        is_there = isinstance(self.paper["section_5_1"]["all_hallways"]["mrpt_icp"], dict)
        self.assertEqual("install libmrpt-dev" in "".join(self.texts("#no-icp")), not is_there)

    def test_fits_a_phone(self):
        self.open(390)
        self.assertLessEqual(self.browser.evaluate("document.documentElement.scrollWidth"), 390)
        # Tables scroll within their boxes, and what is drawn is not shrunk to crumbs.
        self.assertTrue(self.browser.evaluate(
            "[...document.querySelectorAll('.scroll')].some(box => box.scrollWidth > box.clientWidth)"))
        heights = self.browser.evaluate(
            "[...document.querySelectorAll('.chart svg text')].map(one => one.getBoundingClientRect().height)")
        self.assertGreater(min(height for height in heights if height > 0), 10)


def main():
    path = chromium.find()
    if path is None:
        print("skipped: no Chromium here (tools/install_packages browser)")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        PaperTest.folder = folder
        subprocess.run([sys.argv.pop(1), "paper", "--quick", "--only", ",".join(SECTIONS), "-o", folder],
                       check=True, stdout=subprocess.DEVNULL)
        with open(os.path.join(folder, "paper.json"), encoding="utf-8") as file:
            PaperTest.paper = json.load(file)
        with chromium.Chromium(path) as PaperTest.browser:
            return 0 if unittest.main(exit=False, verbosity=2).result.wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
