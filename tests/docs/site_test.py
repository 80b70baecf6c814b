# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""docs/build makes the whole site, of what is built, in the time that it may take.

    site_test.py SOURCE BUILD FOLDER

Exit code 77: skipped, for want of packages.
"""
import pathlib
import subprocess
import sys
import time

EXPECTED = [
    "index.html", "README.html", "docs/tutorials/map_a_bag.html", "docs/tutorials/nav2.html",
    "docs/tutorials/match_in_cpp.html", "docs/tutorials/match_in_python.html", "docs/tutorials/cheap_lidar.html",
    "docs/how_to/check_a_map.html", "docs/method.html", "docs/results.html", "docs/limits.html",
    "docs/formats.html", "docs/parameters.html", "docs/api/cpp/mapping.html", "docs/api/python.html"]
SAID = {"docs/api/cpp/mapping.html": "The map of all scans so far; more may follow.",
        "docs/api/python.html": "Relative pose of two scans of which nothing is known",
        "docs/parameters.html": "keyframe_distance_m", "docs/command.html": "--max-time-difference"}


def main():
    source, build, folder = (pathlib.Path(argument) for argument in sys.argv[1:4])
    began = time.monotonic()
    made = subprocess.run([sys.executable, "-B", source / "docs/build", "--as-built", "--build-dir", build,
                           "--output", folder], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    print(made.stdout, end="")
    if made.returncode == 2:
        print("skipped: no packages to make the site with (tools/install_packages docs)")
        return 77
    if made.returncode != 0:
        return 1
    faults = [f"no {page}" for page in EXPECTED if not (folder / "site" / page).is_file()]
    for page, words in SAID.items():
        if words not in (folder / "site" / page).read_text(encoding="utf-8"):
            faults.append(f"{page} does not say: {words}")
    for fault in faults:
        print(fault)
    print(f"{time.monotonic() - began:.0f} s")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
