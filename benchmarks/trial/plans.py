# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Floor plans that no made-up building has: bare corridors, empty round halls, and wings at a small
angle to each other. A plan is an SVG in metres with the way through it; the same seed gives the same
plan."""
import math
import random


def _svg(shapes, route):
    way = " ".join(f"{x:.3f},{y:.3f}" for x, y in route)
    return ("<svg xmlns='http://www.w3.org/2000/svg'>\n" + "\n".join(shapes) +
            f"\n<polyline id='route' points='{way}'/>\n</svg>\n")


def _polygon(corners):
    points = " ".join(f"{x:.3f},{y:.3f}" for x, y in corners)
    return f"<polygon points='{points}'/>"


def _box(x, y, width, height):
    return f"<rect class='furniture' x='{x:.3f}' y='{y:.3f}' width='{width:.3f}' height='{height:.3f}'/>"


def _doors(begin, end, y, spacing):
    """Corners of a wall at y with a recess of 0.12 m, 0.9 m wide, every `spacing`."""
    corners = []
    step = spacing if end > begin else -spacing
    outward = 0.12 if y > 0 else -0.12
    half = 0.45 if step > 0 else -0.45
    x = begin + step
    while (x - end) * step < 0:
        corners += [(x - half, y), (x - half, y + outward), (x + half, y + outward), (x + half, y)]
        x += step
    return corners


def corridor(seed, door_spacing_m=None, is_there_and_back=False):
    """A corridor of 35 to 60 m between two rooms, its walls bare but for the doors."""
    draw = random.Random(seed)
    length, half = draw.uniform(35, 60), draw.uniform(0.9, 1.4)
    first, last = draw.uniform(4, 7), draw.uniform(4, 7)
    low, high, low_end, high_end = (draw.uniform(2, 4) for _ in range(4))
    upper = _doors(0, length, half, door_spacing_m) if door_spacing_m else []
    lower = _doors(length, 0, -half, door_spacing_m) if door_spacing_m else []
    outline = [(-first, -low), (-first, high), (0, high), (0, half), *upper, (length, half),
               (length, high_end), (length + last, high_end), (length + last, -low_end),
               (length, -low_end), (length, -half), *lower, (0, -half), (0, -low)]
    boxes = [_box(-first + 0.3, high - 0.9, draw.uniform(0.5, 1.5), 0.6),
             _box(length + last - 1.0, -low_end + 0.2, 0.6, draw.uniform(0.5, 1.2))]
    route = [(-0.6 * first, 0.2), (0.0, 0.0), (length, 0.0), (length + 0.6 * last, 0.3)]
    if is_there_and_back:
        route += [(length, -0.2), (0.0, 0.1), (-0.5 * first, -0.3)]
    return _svg([_polygon(outline), *boxes], route)


def ring(seed):
    """A ring of four corridors, bare but for two boxes near the start; driven once around and past
    them again."""
    draw = random.Random(seed)
    length, depth, half = draw.uniform(25, 35), draw.uniform(18, 25), draw.uniform(0.9, 1.3)
    outer = [(-half, -half), (length + half, -half), (length + half, depth + half),
             (-half, depth + half)]
    inner = [(half, half), (length - half, half), (length - half, depth - half), (half, depth - half)]
    boxes = [_box(draw.uniform(5, 6), -half, draw.uniform(0.4, 0.9), 0.3),
             _box(draw.uniform(8, 10), half - 0.25, draw.uniform(0.4, 0.9), 0.25)]
    route = [(2.0, 0.0), (length, 0.0), (length, depth), (0.0, depth), (0.0, 0.0), (14.0, 0.1)]
    return _svg([_polygon(outer), _polygon(inner), *boxes], route)


def round_hall(seed):
    """An empty round hall of 5 to 8 m radius and a way that winds through it."""
    draw = random.Random(seed)
    radius = draw.uniform(5, 8)
    way = [(-0.6, 0.0), (-0.2, -0.6), (0.5, -0.4), (0.6, 0.3), (0.0, 0.6), (-0.5, 0.4), (0.1, 0.0),
           (0.6, -0.2)]
    turned = [(radius * (x + draw.uniform(-0.1, 0.1)), radius * (y + draw.uniform(-0.1, 0.1)))
              for x, y in way]
    return _svg([f"<circle cx='0' cy='0' r='{radius:.3f}'/>"], turned)


def _bays(draw, length, half):
    """Corners of a wall at y = half, along x from 0 to length: bays of rooms open to the corridor."""
    corners = [(0.0, half)]
    x = draw.uniform(0.5, 2.0)
    while True:
        width, depth, jamb = draw.uniform(2.0, 4.0), draw.uniform(1.5, 4.0), draw.uniform(0.0, 0.8)
        if x + width > length - 1.0:
            return [*corners, (length, half)]
        corners += [(x + jamb, half), (x + jamb, half + 0.2), (x, half + 0.2), (x, half + depth),
                    (x + width, half + depth), (x + width, half)]
        x += width + draw.uniform(0.3, 3.0)


def oblique_wings(seed, angle_deg):
    """Two wings, each a corridor with bays, the second turned by the angle either way; driven there
    and back."""
    draw = random.Random(seed)
    half = draw.uniform(0.9, 1.4)
    angle = math.radians(angle_deg) * draw.choice((-1, 1))
    first, second = draw.uniform(18, 26), draw.uniform(18, 26)
    c, s = math.cos(angle), math.sin(angle)

    def turned(x, y):
        return first + c * x - s * y, s * x + c * y
    upper = [*_bays(draw, first, half), *(turned(*p) for p in _bays(draw, second, half))]
    lower = [*((x, -y) for x, y in _bays(draw, first, half)),
             *(turned(x, -y) for x, y in _bays(draw, second, half))]
    ends = [(1.0, 0.0), (first, 0.0), turned(second - 1.0, 0.0)]
    return _svg([_polygon(upper + lower[::-1])], [*ends, turned(second - 1.0, 0.3), (first, 0.2),
                                                 (1.5, -0.2)])
