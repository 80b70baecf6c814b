# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Gets the packages of npm that the tests need, of the versions in package-lock.json, into a folder
of the build that holds a copy of it: npm_packages.py FOLDER. Does nothing where they are there.
"""
import filecmp
import os
import shutil
import subprocess
import sys

SKIPPED = 77


def main():
    folder = sys.argv[1]
    lock = os.path.join(folder, "package-lock.json")
    got = os.path.join(folder, "node_modules", "got.json")  # the lock file that they were got by
    if os.path.exists(got) and filecmp.cmp(lock, got, shallow=False):
        return
    if shutil.which("npm") is None:
        print("skipped: no npm (tools/install_packages bags)")
        sys.exit(SKIPPED)
    command = ["npm", "ci", "--ignore-scripts", "--no-audit", "--no-fund"]
    ended = subprocess.run(command, cwd=folder, check=False)
    if ended.returncode != 0:
        print("skipped: npm could not get the packages")
        sys.exit(SKIPPED)
    shutil.copyfile(lock, got)


main()
