# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""How Sphinx makes the site: docs/build runs it over a copy of the sources."""
import os
import pathlib
import re

_cmake = pathlib.Path(os.environ["SETSQUARE_SOURCE"], "CMakeLists.txt").read_text()

project = "Setsquare"
author = "The Setsquare authors"
copyright = "2026, The Setsquare authors"
release = version = re.search(r"^project\(setsquare VERSION ([0-9.]+)", _cmake, re.M).group(1)

extensions = ["breathe", "myst_parser", "sphinx.ext.autodoc"]
root_doc = "index"
exclude_patterns = ["include/**"]
suppress_warnings = ["myst.header"]  # README.md has its picture before its first section.
nitpicky = False

myst_heading_anchors = 4
myst_enable_extensions = ["colon_fence"]

breathe_projects = {"setsquare": os.environ["SETSQUARE_DOXYGEN"]}
breathe_default_project = "setsquare"
breathe_show_include = False
cpp_id_attributes = ["nodiscard"]

autodoc_typehints = "none"  # pybind11 has them in the docstrings' first line.
autodoc_member_order = "bysource"
add_module_names = False

default_role = "literal"  # As docstrings quote code.

html_theme = "furo"
html_title = f"Setsquare {version}"
html_show_sphinx = False
html_copy_source = False
html_static_path = []
highlight_language = "text"


def _as_rest(app, what, name, item, options, lines):
    """Docstrings are for `help()`; here their lines "name: words" become a list, indented code code."""
    made, state = [], "text"
    for line in lines:
        named = re.match(r"(\w+(?:, \w+)*): (.*)", line)
        indented = line.startswith("    ")
        if named:
            made += ["", f"- **{named.group(1)}**: {named.group(2)}"]
            state = "list"
        elif indented and state == "list":
            made.append("  " + line.strip())
        elif indented:
            if state != "code":
                made += ["", ".. code-block:: python", ""]
            made.append(line)
            state = "code"
        else:
            if line.strip() and state != "text":
                made.append("")
                state = "text"
            made.append(line)
    lines[:] = made


def _by_public_names(app, what, name, item, options, signature, returned):
    """Classes are those of `setsquare`, wherever they are made."""
    def public(text):
        return text and text.replace("setsquare._core.", "").replace("numpy.ndarray[numpy.float64]", "array")
    return public(signature), public(returned)


def setup(app):
    app.connect("autodoc-process-docstring", _as_rest)
    app.connect("autodoc-process-signature", _by_public_names)
