# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Tables in Markdown."""


def table(header, rows):
    """A table in Markdown; `header` and each row are lists of cells."""
    lines = ["| " + " | ".join(map(str, line)) + " |" for line in (header, *rows)]
    return "\n".join([lines[0], "|" + "---|" * len(header), *lines[1:]]).replace("|  |", "| |")


def cells(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def kept_row(old, label):
    """The row of the old block whose first cell is `label`, for figures that are not rerun."""
    for line in old.splitlines():
        if line.startswith("|") and cells(line)[0] == label:
            return cells(line)
    return None


def kept_cell(old, label, column):
    """A cell of the old table, by its row's first cell and its column's header, or "-"."""
    lines = [line for line in old.splitlines() if line.startswith("|")]
    if not lines or column not in cells(lines[0]):
        return "-"
    row = kept_row(old, label)
    return row[cells(lines[0]).index(column)] if row else "-"
