# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""python map_a_log.py LOG FOLDER: maps a log, saves everything, and draws the map."""
import sys

import matplotlib.pyplot as plt

import setsquare
import setsquare.plot

log, folder = sys.argv[1:]
building = setsquare.map_log(log)
print(building.verdict, *building.doubts, *building.findings, sep="\n")
building.save(folder)
setsquare.plot.map(building)
plt.savefig(f"{folder}/plot.svg")
