# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Runs every command and program of the README and of the documents, page by page.

    snippets_test.py SOURCE BUILD PREFIX FOLDER [PAGE...]

By default all pages. BUILD has the command and the Python module, PREFIX the installed library. Exit code 77: skipped.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

import inputs
import snippets

# How many blocks may stay without a run; each says why.
MOST_NOT_RUN = 20
PYTHON_NAMES = """import setsquare
_scans = [record.scan for record in setsquare.read_log("log.clf")]
ranges_a, ranges_b = _scans[0].ranges_m, _scans[5].ranges_m
truth = setsquare.Trajectory.read_tum("truth.tum")
del _scans
"""
CPP_NAMES = "#include <iostream>\n#include <vector>\n"


def pages_of(source):
    return [source / "README.md", source / "python/README.md", *sorted((source / "docs").rglob("*.md"))]


class Runner:
    def __init__(self, source, build, prefix, folder):
        self.source, self.prefix, self.folder = source, prefix, folder
        shutil.rmtree(folder, ignore_errors=True)
        programs = folder / "programs"
        programs.mkdir(parents=True)
        self.command = build / "apps/setsquare/setsquare"
        (programs / "setsquare").symlink_to(self.command)
        package = folder / "python/setsquare"
        shutil.copytree(source / "python/setsquare", package)
        self.has_python = False
        for module in (build / "python").glob("_core*.so"):
            (package / module.name).symlink_to(module)
            self.has_python = True
        self.environment = {**os.environ, "PATH": f"{programs}:{os.environ['PATH']}", "MPLBACKEND": "Agg",
                            "PYTHONPATH": str(folder / "python"), "PYTHONDONTWRITEBYTECODE": "1",
                            "CMAKE_PREFIX_PATH": str(prefix), "CMAKE_GENERATOR": "Ninja"}
        inputs.make(self.command, folder / "made")

    def run(self, command, where):
        ended = subprocess.run(command, cwd=where, env=self.environment, text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        return None if ended.returncode == 0 else f"exit code {ended.returncode}\n{ended.stdout[-3000:]}"

    def page(self, blocks, name):
        """Runs the blocks of a page in their order; a list of what failed."""
        where = self.folder / "pages" / name.replace("/", "_")
        inputs.give(self.folder / "made", where)
        faults, told = [], ""
        for number, block in enumerate(blocks):
            fault = None
            if block.why_not_run and not block.only:
                continue
            if block.file:
                (where / block.file).write_text(block.text)
            elif block.language == "sh":
                fault = self.run(["bash", "-euo", "pipefail", "-c", snippets.runnable(block)], where)
            elif block.language == "python" and self.has_python:
                # Each sees what those before it made; only its own words may fail.
                told += block.text + "\n"
                fault = self.run([sys.executable, "-c", PYTHON_NAMES + told], where)
            elif block.language == "cpp":
                fault = self.program(block.text, "target_link_libraries(snippet PRIVATE setsquare::setsquare)",
                                     where / f"snippet{number}")
            elif block.language == "cmake":
                fault = self.program("", block.text.replace("my_program", "snippet"), where / f"snippet{number}")
            if fault:
                faults.append(f"{block.place}: {fault}")
        return faults

    def program(self, text, linking, where):
        """Builds and runs the statements of TEXT as a program."""
        includes = "".join(re.findall(r"^#include.*\n", text, re.M))
        body = re.sub(r"^#include.*\n", "", text, flags=re.M)
        where.mkdir()
        (where / "main.cpp").write_text(f"{CPP_NAMES}{includes}int main() {{\n{body}}}\n")
        finding = "" if "find_package" in linking else "find_package(setsquare REQUIRED)\n"
        (where / "CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.25)\nproject(snippet LANGUAGES CXX)\n"
            f"add_executable(snippet main.cpp)\n{finding}{linking}\n")
        return (self.run(["cmake", "-B", "build"], where) or self.run(["cmake", "--build", "build"], where)
                or self.run([where / "build/snippet"], where.parent))


def unknown_options(command, texts):
    """The options and subcommands in the pages' text that the command does not have."""
    helps, unknown = {}, []

    def help_of(path):
        if path not in helps:
            ended = subprocess.run([command, *path, "--help"], capture_output=True, text=True)
            # The experiments are a program of their own, which need not be built.
            is_told = ended.returncode == 0 and "it is not there" not in ended.stdout
            helps[path] = ended.stdout if is_told else None
        return helps[path]

    for page, text in texts.items():
        for words in snippets.named_commands(text):
            path = ()
            for word in words[1:3]:
                listed = re.search(r"^Subcommands:\n((?:  .*\n)+)", help_of(path) or "", re.M)
                if listed and re.search(rf"^  {re.escape(word)} ", listed.group(1), re.M):
                    path = (*path, word)
            if not path and words[1].isalpha() and words[1].islower():
                unknown.append(f"{page}: setsquare {words[1]}")
            for option in re.findall(r"(?<![\w-])--[a-z][\w-]*", " ".join(words)):
                if help_of(path) is not None and not re.search(rf"{option}(?![\w-])", help_of(path)):
                    unknown.append(f"{page}: setsquare {' '.join(path)} {option}")
    return unknown


def main():
    source, build, prefix, folder = (pathlib.Path(argument).resolve() for argument in sys.argv[1:5])
    runner = Runner(source, build, prefix, folder)
    if not runner.has_python:
        print("without the Python module (SETSQUARE_BUILD_PYTHON): no Python is run")
    texts = {str(path.relative_to(source)): path.read_text(encoding="utf-8") for path in pages_of(source)}
    texts = {page: text for page, text in texts.items() if page in (sys.argv[5:] or texts)}
    faults = unknown_options(runner.command, texts)
    not_run, num_run = [], 0
    for page, text in texts.items():
        began = time.monotonic()
        blocks = [block for block in snippets.blocks_of(page, text) if block.language in snippets.RUN]
        not_run += [block for block in blocks if block.why_not_run]
        num_run += sum(not block.why_not_run or bool(block.only) for block in blocks)
        if blocks:
            faults += runner.page(blocks, page)
            print(f"{page}: {len(blocks)} blocks, {time.monotonic() - began:.1f} s", flush=True)
    for block in not_run:
        print(f"not run: {block.place}: {block.only or 'the block'}: {block.why_not_run}")
    print(f"{num_run} blocks run, {len(not_run)} not, {len(faults)} faults")
    if len(not_run) > MOST_NOT_RUN:
        faults.append(f"{len(not_run)} blocks are not run, at most {MOST_NOT_RUN} may be")
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
