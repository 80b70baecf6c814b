# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Pictures of what the command makes: map.png, and report.html as Chromium shows it.

A page names them as images below drawn/. Where there is no Chromium its lines with screenshots are left out.
"""
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests/browser"))

import chromium  # noqa: E402

_IMAGE = re.compile(r"!\[[^\]]*\]\(([^)]*drawn/[\w.-]+)\)")


def _make(command, folder):
    """The files that a reader of the tutorials has: a log of an office and its map."""
    subprocess.run([command, "simulate", "--building", "office", "--seed", "7", "--every", "0.2", "-o",
                    folder / "sim"], check=True, capture_output=True)
    subprocess.run([command, "map", folder / "sim/scans.clf", "-o", folder / "map"], check=True,
                   capture_output=True)
    subprocess.run([command, "explain", folder / "sim/scans.clf", "0", "20", "-o", folder / "match.html"],
                   check=True, capture_output=True)
    return {"map.png": (folder / "map/map.png").read_bytes()}


def _screenshots(folder):
    browser = chromium.find()
    if browser is None:
        print("docs/build: no Chromium, so the pages show no screenshots (tools/install_packages browser)")
        return {}
    with chromium.Chromium(browser, width=1280, height=860) as page:
        page.open(folder / "map/report.html")
        shots = {"report.png": page.screenshot()}
        page.call("Page.navigate", url=(folder / "match.html").resolve().as_uri())
        page.wait_for("document.readyState === 'complete'")
        shots["match.png"] = page.screenshot()
        return shots


def draw(command, pages, folder):
    """Draws, and puts the pictures where the pages among PAGES name them."""
    folder.mkdir(parents=True, exist_ok=True)
    pictures = {**_make(command, folder), **_screenshots(folder)}
    for path in sorted(pages.rglob("*.md")):
        text = path.read_text(encoding="utf-8")
        kept = []
        for line in text.split("\n"):
            match = _IMAGE.search(line)
            if match:
                name = pathlib.PurePosixPath(match.group(1)).name
                if name not in pictures:
                    continue
                target = path.parent / match.group(1)
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_bytes(pictures[name])
            kept.append(line)
        path.write_text("\n".join(kept), encoding="utf-8")
