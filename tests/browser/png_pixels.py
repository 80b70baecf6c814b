# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Reads the PNG files that a browser's screenshots are: eight bits a channel, RGB or RGBA."""
import struct
import zlib


def _paeth(left, above, corner):
    estimate = left + above - corner
    by_left, by_above, by_corner = (abs(estimate - a) for a in (left, above, corner))
    if by_left <= by_above and by_left <= by_corner:
        return left
    return above if by_above <= by_corner else corner


def _unfiltered(kind, line, above, size):
    """A row of bytes from its filtered form; `size` bytes a pixel."""
    row = bytearray(line)
    if kind == 2:
        return bytearray((a + b) & 255 for a, b in zip(row, above))
    for k in range(len(row)) if kind else ():
        left = row[k - size] if k >= size else 0
        if kind == 1:
            guess = left
        elif kind == 3:
            guess = (left + above[k]) >> 1
        else:
            guess = _paeth(left, above[k], above[k - size] if k >= size else 0)
        row[k] = (row[k] + guess) & 255
    return row


class Picture:
    def __init__(self, png):
        assert png[:8] == b"\x89PNG\r\n\x1a\n"
        packed, place = b"", 8
        while place < len(png):
            length, kind = struct.unpack(">I4s", png[place:place + 8])
            content = png[place + 8:place + 8 + length]
            if kind == b"IHDR":
                self.width, self.height, depth, color, _, _, interlace = struct.unpack(">IIBBBBB", content)
                assert depth == 8 and color in (2, 6) and interlace == 0
                self.size = 3 if color == 2 else 4
            elif kind == b"IDAT":
                packed += content
            place += 12 + length
        raw = zlib.decompress(packed)
        stride = self.size * self.width
        self.rows, above = [], bytearray(stride)
        for row in range(self.height):
            first = row * (stride + 1)
            above = _unfiltered(raw[first], raw[first + 1:first + 1 + stride], above, self.size)
            self.rows.append(above)

    def at(self, column, row):
        """(red, green, blue) of the pixel that holds a place."""
        first = self.size * int(column)
        return tuple(self.rows[int(row)][first:first + 3])

    def places(self, color, tolerance=24):
        """The (column, row) of every pixel whose channels are all that near to a colour's."""
        is_near = [bytes(abs(value - a) <= tolerance for value in range(256)) for a in color]
        found = []
        for number, row in enumerate(self.rows):
            mask = -1  # A byte a pixel, 1 where all channels are near.
            for channel in range(3):
                mask &= int.from_bytes(row[channel::self.size].translate(is_near[channel]), "big")
            if mask:
                bits = mask.to_bytes(self.width, "big")
                found += [(column, number) for column, bit in enumerate(bits) if bit]
        return found


def distance(color, other):
    """The largest difference of a channel."""
    return max(abs(a - b) for a, b in zip(color, other))
