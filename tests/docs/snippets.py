# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""The fenced blocks of a page, and what each of them is to a machine.

A block says its language: sh, cpp, python, cmake, text (which is not run), or a directive in braces. A
comment on the line before may say more:

    <!-- not run: needs ROS -->                      the reader sees a command that the test cannot run
    <!-- not run (`setsquare experiment`): long -->  only the lines that begin so, or so:
    <!-- not run (`setsquare live`, `setsquare replay`): endless -->
    <!-- file: main.cpp -->                          it is a file, which later blocks use
"""
import re
from dataclasses import dataclass

RUN = ("sh", "cpp", "python", "cmake")
_FENCE = re.compile(r"^( *)(`{3,}|:{3,})(\S*)")
_NOT_RUN = re.compile(r"<!-- not run(?: \(`(.+)`\))?: (.+) -->")
_FILE = re.compile(r"<!-- file: (\S+) -->")
_SPAN = re.compile(r"`(setsquare [^`\n]+)`")

# What a synopsis names in capitals, by the names that the test provides.
_MEANT = [(r"--continue DIR -o DIR2\b", "--continue out -o out2"), (r"\bDIR DIR2\.\.\. -o DIR3\b", "out out2 -o out3"),
          (r"\bMAP\.setsquare -o DIR\b", "out/map.setsquare -o rendered"), (r"\bMAP LOG -o DIR\b", "out log.clf -o found"),
          (r"\bOUT\.mcap\b", "made.mcap"), (r"DIR\|TRAJECTORY\.tum", "out"), (r"\bREFERENCE\.tum\b", "truth.tum"),
          (r"\bFILE\.relations\b", "truth.relations"), (r"\bTRAJECTORY FILE\b", "out/trajectory.tum truth.relations"),
          (r"\bLOG I J\b", "log.clf 0 5"), (r"\bLOG(\.\.\.)?(?=\s)", "log.clf"), (r"-o DIR\b", "-o out")]


class Unclear(Exception):
    """A block that does not say what it is."""


@dataclass
class Block:
    page: str
    line: int
    language: str
    text: str
    file: str = ""
    why_not_run: str = ""
    only: str = ""  # What is not run begins so; empty: the whole block.

    @property
    def place(self):
        return f"{self.page}:{self.line}"


def blocks_of(page, text):
    """The blocks in their order. Raises Unclear where one has no language, or has no end."""
    blocks, fence, before = [], None, ""
    for number, line in enumerate(text.split("\n"), start=1):
        match = _FENCE.match(line)
        if fence is None and match:
            fence, block = match.group(2), Block(page, number, match.group(3), "")
            not_run, file = _NOT_RUN.search(before), _FILE.search(before)
            if not_run:
                block.only, block.why_not_run = not_run.group(1) or "", not_run.group(2)
            if file:
                block.file = file.group(1)
            if not block.language:
                raise Unclear(f"{block.place}: a block without a language")
            if block.language not in RUN and block.language != "text" and block.language[0] != "{":
                raise Unclear(f"{block.place}: a block in {block.language}, which nothing runs")
        elif fence is not None and match and match.group(2).startswith(fence) and not match.group(3):
            blocks.append(block)
            fence = None
        elif fence is not None:
            block.text += line + "\n"
        if line.strip():
            before = line
    if fence is not None:
        raise Unclear(f"{block.place}: a block without an end")
    return blocks


def runnable(block):
    """What of a shell block is run: without the lines that are not, and a synopsis made concrete."""
    lines = []
    for line in block.text.splitlines():
        if block.only and line.startswith(tuple(block.only.split("`, `"))):
            continue
        if line.startswith("setsquare "):
            line = re.sub(r"\s\[-[^\]]*\]", "", line)
            for written, meant in _MEANT:
                line = re.sub(written, meant, line)
        lines.append(line)
    return "\n".join(lines) + "\n"


def named_commands(text):
    """Every `setsquare ...` of a page, in its sentences and in its blocks: as words."""
    found = _SPAN.findall(text)
    found += re.findall(r"^(?:.*\| )?(setsquare [^\n#|&]+)", text, re.M)
    return [command.split() for command in found]
