# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Pages of the API in both languages, and of the command, from what is built."""
import importlib
import inspect
import re
import subprocess
import sys

from doxygen import Undocumented

LAYERS = {
    "setsquare": "The front door",
    "core": "Poses, stamps, errors", "scan": "Scans and the result of a match",
    "surfaces": "Scans as surfaces", "paper": "The paper's functions",
    "matching": "The matcher", "headings": "Parameters of headings", "graph": "The pose graph",
    "grid": "The occupancy grid", "map": "What a map is", "tracking": "Tracking",
    "mapping": "The mapper", "io": "Logs and tables", "eval": "Errors against ground truth",
    "report": "Files of a map", "pipeline": "From a log to a map"}


def cpp_pages(headers):
    """The pages' texts by their names: one a layer, and an index."""
    layers = {}
    for header in headers:
        parts = header.split("/")
        layers.setdefault(parts[1] if len(parts) > 2 else "setsquare", []).append(header)
    pages = {}
    for layer, files in layers.items():
        text = f"# {LAYERS.get(layer, layer)}\n"
        for header in files:
            text += f"\n## {header}\n\n```{{eval-rst}}\n.. doxygenfile:: {header}\n```\n"
        pages[layer] = text
    # Those that are named above in that order, then any other.
    listed = "\n".join([layer for layer in LAYERS if layer in layers] +
                       [layer for layer in layers if layer not in LAYERS])
    pages["index"] = ("# API: C++\n\n`#include \"setsquare/setsquare.hpp\"` and link `setsquare::setsquare`. "
                      "A page for each layer of the library, the first to use first: see the "
                      "[front door](../../../ARCHITECTURE.md).\n\n```{toctree}\n:maxdepth: 1\n\n" + listed +
                      "\n```\n")
    return pages


def _public(package):
    return [name for name in package.__all__ if not name.startswith("__")]


def undocumented_in(package):
    """Public names of a Python package that have no words: classes, functions, methods, properties."""
    missing = []
    for name in _public(package):
        item = getattr(package, name)
        if not _says_something(item):
            missing.append(name)
        if inspect.isclass(item) and not issubclass(item, Exception):
            missing += [f"{name}.{member}" for member, value in vars(item).items()
                        if not member.startswith("_") and not _says_something(value)]
    return missing


def _says_something(item):
    """Whether a docstring has more than pybind11's signatures."""
    lines = (getattr(item, "__doc__", None) or "").splitlines()
    words = [line for line in lines if not re.match(r"(\d+\. )?\w+\(.*\)( -> .*)?$", line)
             and line.strip() not in ("", "Overloaded function.")]
    return bool(words)


def python_page(folder):
    """The page of the package in FOLDER. Raises Undocumented with the names that have no words."""
    sys.path.insert(0, str(folder))
    package = importlib.import_module("setsquare")
    plot = importlib.import_module("setsquare.plot")
    missing = undocumented_in(package)
    drawing = [name for name, item in vars(plot).items()
               if inspect.isfunction(item) and item.__module__ == plot.__name__ and not name.startswith("_")]
    missing += [f"plot.{name}" for name in drawing if not _says_something(getattr(plot, name))]
    if missing:
        raise Undocumented("Python without words: " + ", ".join(missing))
    kinds = {"Functions": [], "Classes": [], "Errors": []}
    for name in _public(package):
        item = getattr(package, name)
        is_error = inspect.isclass(item) and issubclass(item, Exception)
        kinds["Errors" if is_error else "Classes" if inspect.isclass(item) else "Functions"].append(name)
    text = "# API: Python\n\nA pose `T_a_b` maps points of frame b into frame a. [How to use it](../python.md).\n"
    for kind, names in kinds.items():
        directive, options = {"Functions": ("autofunction", ""), "Classes": ("autoclass", "   :members:\n"),
                              "Errors": ("autoexception", "")}[kind]
        text += f"\n## {kind}\n\n```{{eval-rst}}\n.. currentmodule:: setsquare\n\n"
        text += "".join(f".. {directive}:: {name}\n{options}\n" for name in names) + "```\n"
    text += "\n## setsquare.plot\n\n```{eval-rst}\n.. automodule:: setsquare.plot\n   :members:\n```\n"
    return text


def command_page(command):
    """What --help says, of the command and of each subcommand below it."""
    text = "# The command\n\nWhat `--help` says. The same is in the manual pages (`man setsquare-map`).\n"
    waiting = [[]]
    while waiting:
        path = waiting.pop(0)
        said = subprocess.run([command, *path, "--help"], check=True, capture_output=True, text=True).stdout
        title = " ".join(["setsquare", *path])
        text += f"\n{'##' if len(path) < 2 else '###'} {title}\n\n```text\n{said.strip()}\n```\n"
        listed = re.search(r"^Subcommands:\n((?:  .*\n)+)", said, re.M)
        names = re.findall(r"^  ([\w-]+) ", listed.group(1), re.M) if listed else []
        waiting = [[*path, name] for name in names] + waiting
    return text
