# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""What makes the site sees what it is to see: each of its checks is shown a fault.

    checks_test.py SOURCE
"""
import pathlib
import shutil
import sys
import tempfile
import types
import unittest

SOURCE = pathlib.Path(sys.argv.pop(1)).resolve()
sys.path[:0] = [str(SOURCE / "docs/site"), str(SOURCE / "tests/docs")]

import doxygen  # noqa: E402
import links  # noqa: E402
import parameters  # noqa: E402
import reference  # noqa: E402
import snippets  # noqa: E402


class InAFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name).resolve()


class Links(InAFolder):
    def dead(self, link):
        (self.folder / "there.html").write_text('<h1 id="place">There</h1>')
        (self.folder / "index.html").write_text(f'<a href="{link}">a</a>')
        return links.dead_links(self.folder)

    def test_those_that_lead_somewhere(self):
        for link in ("there.html", "there.html#place", "#", "https://example.org/a?b#c", "mailto:a@example.org"):
            self.assertEqual(self.dead(link), [], link)

    def test_those_that_do_not(self):
        for link in ("nowhere.html", "there.html#elsewhere", "#elsewhere", "../outside.html", "https://", "htp://a.b",
                     "http://[::1"):
            self.assertEqual(len(self.dead(link)), 1, link)


@unittest.skipUnless(shutil.which("doxygen"), "no doxygen (tools/install_packages docs)")
class Words(InAFolder):
    HEADER = """/// Words.
namespace setsquare {
/// Parameters of something.
struct SomeParams {
  double length_m = 1.0;  ///< Of something.
%s};
}  // namespace setsquare
"""

    def make(self, more):
        (self.folder / "some.hpp").write_text(self.HEADER % more)
        doxygen.run(self.folder, ["some.hpp"], self.folder / "out")
        return doxygen.structs(self.folder / "out")

    def test_a_field_with_words_is_on_the_page(self):
        self.assertIn("| `length_m` | `1.0` | Of something. |", parameters.page(self.make("")))

    def test_a_field_without_words_is_an_error(self):
        with self.assertRaisesRegex(doxygen.Undocumented, "width_m"):
            self.make("  double width_m = 1.0;\n")

    def test_and_one_that_doxygen_let_pass(self):
        structs = self.make("")
        structs["SomeParams"].fields[0].words = ""
        with self.assertRaisesRegex(doxygen.Undocumented, "SomeParams::length_m"):
            parameters.page(structs)

    def test_a_function_without_words_is_an_error(self):
        with self.assertRaisesRegex(doxygen.Undocumented, "longer"):
            self.make("  double longer() const;\n")


class PublicHeaders(unittest.TestCase):
    def test_they_are_those_that_are_installed(self):
        headers = doxygen.public_headers(SOURCE)
        self.assertGreater(len(headers), 60)
        self.assertEqual([header for header in headers if not (SOURCE / header).is_file()], [])


class PythonWords(unittest.TestCase):
    def test_a_signature_alone_says_nothing(self):
        package = types.ModuleType("some")
        package.__all__ = ["told", "untold", "Kind"]
        package.told, package.untold = (lambda: 0), (lambda: 0)
        package.told.__doc__ = "told(a: int) -> int\n\nWords.\n"
        package.untold.__doc__ = "untold(a: int) -> int\n"
        package.Kind = type("Kind", (), {"__doc__": "Words.", "size": property(lambda self: 0)})
        self.assertEqual(reference.undocumented_in(package), ["untold", "Kind.size"])


class Snippets(unittest.TestCase):
    def test_their_order_language_and_marks(self):
        text = ("```sh\nls\n```\n\n<!-- not run: needs ROS -->\n```sh\nros2 run\n```\n\n"
                "<!-- file: a.cpp -->\n```cpp\nint a;\n```\n")
        blocks = snippets.blocks_of("page.md", text)
        self.assertEqual([(block.language, block.why_not_run, block.file, block.line) for block in blocks],
                         [("sh", "", "", 1), ("sh", "needs ROS", "", 6), ("cpp", "", "a.cpp", 11)])

    def test_what_does_not_say_what_it_is(self):
        for text in ("```\nls\n```\n", "```sh\nls\n", "```fortran\nstop\n```\n"):
            with self.assertRaises(snippets.Unclear):
                snippets.blocks_of("page.md", text)

    def test_a_synopsis_is_made_concrete(self):
        block = snippets.Block("p", 1, "sh", "setsquare match LOG I J [--json]  # a pose\nsetsquare slow LOG\n",
                               why_not_run="slow", only="setsquare slow")
        self.assertEqual(snippets.runnable(block).split("#")[0].strip(), "setsquare match log.clf 0 5")

    def test_commands_in_sentences_are_seen(self):
        self.assertEqual(snippets.named_commands("Try `setsquare map a -o b`.\nzcat a | setsquare info -\n"),
                         [["setsquare", "map", "a", "-o", "b"], ["setsquare", "info", "-"]])


if __name__ == "__main__":
    unittest.main(verbosity=0)
