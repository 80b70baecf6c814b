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


def _walls(spaces):
    """Lines along the boundary of the union of spaces (x0, y0, x1, y1)."""
    def free_of(fixed, low, high, is_beside):
        """The parts of an edge that no other space covers."""
        parts = [(low, high)]
        for begin, end in sorted(filter(None, (is_beside(space, fixed) for space in spaces))):
            parts = [piece for a, b in parts for piece in ((a, min(b, begin)), (max(a, end), b))
                     if piece[1] - piece[0] > 1e-9]
        return parts

    def over_row(sign):  # Spaces that lie just beyond a horizontal edge.
        return lambda s, y: (s[0], s[2]) if s[1] < y + sign * 1e-6 < s[3] else None

    def over_column(sign):
        return lambda s, x: (s[1], s[3]) if s[0] < x + sign * 1e-6 < s[2] else None
    lines = []
    for x0, y0, x1, y1 in spaces:
        lines += [(a, y, b, y) for y, sign in ((y0, -1), (y1, 1))
                  for a, b in free_of(y, x0, x1, over_row(sign))]
        lines += [(x, a, x, b) for x, sign in ((x0, -1), (x1, 1))
                  for a, b in free_of(x, y0, y1, over_column(sign))]
    return [f"<line x1='{a:.3f}' y1='{b:.3f}' x2='{c:.3f}' y2='{d:.3f}'/>" for a, b, c, d in lines]


def _passage(a, b, half):
    """A corridor between two points with the same x or y."""
    (x0, y0), (x1, y1) = a, b
    return (min(x0, x1) - half, min(y0, y1) - half, max(x0, x1) + half, max(y0, y1) + half)


def _room(draw):
    """A room about (0, 0), with an alcove and two cupboards, that no other draw has: spaces and
    boxes (x0, y0, x1, y1)."""
    left, right, low, high = (draw.uniform(2.2, 3.8) for _ in range(4))
    alcove, depth = draw.uniform(1.0, 1.8), draw.uniform(0.6, 1.5)
    side = draw.choice((-1, 1))
    beyond = (right, -low, right + depth, alcove - low)
    if side < 0:
        beyond = (-left - depth, -low, -left, alcove - low)
    wide, deep = draw.uniform(0.4, 0.9), draw.uniform(0.3, 0.7)
    boxes = [(-left, high - deep, wide - left, high),
             (right - deep, high - draw.uniform(0.5, 1.0), right, high)]
    return [(-left, -low, right, high), beyond], boxes


def _moved(boxes, at):
    return [(x0 + at[0], y0 + at[1], x1 + at[0], y1 + at[1]) for x0, y0, x1, y1 in boxes]


def _rooms_and_corridors(rooms, places, half, route):
    """A plan of rooms at places, each joined to the next place by a bare corridor."""
    spaces, boxes = [], []
    for (of_room, cupboards), at in zip(rooms, places):
        spaces += _moved(of_room, at)
        boxes += _moved(cupboards, at)
    spaces += [_passage(a, b, half) for a, b in zip(places, places[1:])]
    return _svg([*_walls(spaces), *(_box(x0, y0, x1 - x0, y1 - y0) for x0, y0, x1, y1 in boxes)],
                route)


def ring_of_rooms(seed, longest_m=60.0):
    """Four rooms, no two alike, at the corners of a ring of bare corridors of 30 m and more; driven
    once around and on to the third room again."""
    draw = random.Random(seed)
    length, depth, half = draw.uniform(30, longest_m), draw.uniform(30, longest_m), draw.uniform(0.9, 1.3)
    corners = [(0.0, 0.0), (length, 0.0), (length, depth), (0.0, depth)]
    ring = [*corners, corners[0]]
    rooms = [_room(draw) for _ in corners]
    return _rooms_and_corridors([*rooms, rooms[0]], ring, half, [*ring, *corners[1:3]])


def spiral_of_twins(seed, num_twins=1):
    """Rooms along a spiral of bare corridors that never comes back: after the fourth room follow
    exact twins of the first, as many as asked for, the corridor between them of the same length."""
    draw = random.Random(seed)
    length, depth, half = draw.uniform(20, 40), draw.uniform(20, 40), draw.uniform(0.9, 1.3)
    off_x, off_y = draw.uniform(9, 14), draw.uniform(9, 14)
    places = [(0.0, 0.0), (length, 0.0), (length, depth), (-off_x, depth), (-off_x, -off_y)]
    rooms = [_room(draw) for _ in range(4)]
    rooms += rooms[:1]
    if num_twins > 1:
        places.append((length - off_x, -off_y))
        rooms.append(rooms[1])
    else:
        places.append((12.0 - off_x, -off_y))
        rooms.append(_room(draw))
    return _rooms_and_corridors(rooms, places, half, places)


def row_of_twins(seed):
    """Exact twins of one room along a bare corridor, 15 to 40 m from each to the next."""
    draw = random.Random(seed)
    room, half, spacing = _room(draw), draw.uniform(0.9, 1.3), draw.uniform(15, 40)
    places = [(k * spacing, 0.0) for k in range(4)]
    return _rooms_and_corridors([room] * 4, places, half, [*places, *places[2::-1]])


def twin_corridors(seed):
    """Two corridors side by side, exact twins with the rooms at their ends, and one across; driven
    through the first, across and through the second the same way."""
    draw = random.Random(seed)
    length, apart, half = draw.uniform(20, 40), draw.uniform(15, 25), draw.uniform(0.9, 1.3)
    first, last = _room(draw), _room(draw)
    places = [(0.0, 0.0), (length, 0.0), (0.0, 0.0), (0.0, apart), (length, apart)]
    return _rooms_and_corridors([first, last, first, first, last], places, half, places)


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
