# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""How scans, matches and maps show themselves in a notebook."""

import base64
import html
import math

import numpy as np

from setsquare import _core

_REFERENCE = "#1f6feb"
_CURRENT = "#d1580b"
_WIDTH_PX = 480
_MAX_HEIGHT_PX = 480


def _svg(layers, robots):
    """Points (N, 2) in m, each layer in its colour; a triangle where each robot is."""
    points = [layer for layer, _ in layers if len(layer)] + [np.array([[p[0], p[1]] for p, _ in robots])]
    everything = np.vstack(points)
    low, high = everything.min(axis=0) - 0.5, everything.max(axis=0) + 0.5
    size = high - low
    scale = min(_WIDTH_PX / size[0], _MAX_HEIGHT_PX / size[1])
    to_px = lambda xy: ((xy[:, 0] - low[0]) * scale, (high[1] - xy[:, 1]) * scale)  # noqa: E731
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{size[0] * scale:.0f}"'
        f' height="{size[1] * scale:.0f}" style="background:#fff">'
    ]
    for xy, colour in layers:
        path = "".join(f"M{x:.1f} {y:.1f}h0" for x, y in zip(*to_px(np.asarray(xy).reshape(-1, 2))))
        parts.append(
            f'<path d="{path}" stroke="{colour}" stroke-width="2.5" stroke-linecap="round"/>'
        )
    for (x, y, theta), colour in robots:
        nose = [(x + 0.3 * math.cos(theta + a), y + 0.3 * math.sin(theta + a)) for a in (0.0, 2.5, -2.5)]
        corners = " ".join(f"{u:.1f},{v:.1f}" for u, v in zip(*to_px(np.array(nose))))
        parts.append(f'<polygon points="{corners}" fill="{colour}"/>')
    return "".join(parts) + "</svg>"


def _scan_html(self):
    return _svg([(self.points(), _REFERENCE)], [((0.0, 0.0, 0.0), _REFERENCE)]) + (
        f"<br><code>{html.escape(repr(self))}</code>"
    )


def _match_html(self):
    layers = [(self.reference.points(), _REFERENCE)]
    robots = [((0.0, 0.0, 0.0), _REFERENCE)]
    pose = self.T_reference_current
    if pose is not None:
        layers.append((pose.transform(self.current.points()), _CURRENT))
        robots.append((tuple(pose), _CURRENT))
    return _svg(layers, robots) + f"<br><code>{html.escape(repr(self))}</code>"


def _map_html(self):
    image = base64.b64encode(self.to_png()).decode()
    doubts = "".join(f"<li>{html.escape(doubt.reason)}</li>" for doubt in self.doubts)
    return (
        f'<img src="data:image/png;base64,{image}" style="max-width:100%">'
        f"<br><code>{html.escape(repr(self))}</code>" + (f"<ol>{doubts}</ol>" if doubts else "")
    )


def _map_png(self):
    return self.to_png()


def install():
    """Gives the classes their notebook pictures."""
    _core.Scan._repr_html_ = _scan_html
    _core.MatchResult._repr_html_ = _match_html
    _core.Map._repr_html_ = _map_html
    _core.Map._repr_png_ = _map_png
