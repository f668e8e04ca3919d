#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the occupancy image of a map from its wall segments.

usage: draw_map.py WALLS.yaml MAP.yaml OUT.pgm

WALLS.yaml lists [x1, y1, x2, y2, loss_db] in metres; resolution and origin come from MAP.yaml.
What can be reached from (0, 0) without crossing a wall is free, walls are occupied, the rest is
unknown, in the grey levels of ROS's map_saver. Reads only the YAML that these two files use.
"""
import math
import re
import sys

FREE, UNKNOWN, OCCUPIED = 254, 205, 0
MARGIN_M = 1.0


def fail(text):
    sys.exit(f"draw_map.py: {text}")


def numbers(text, where):
    try:
        return [float(word) for word in text.split(",")]
    except ValueError:
        fail(f"{where}: '{text}' is not a list of numbers")


def read_walls(path):
    walls = []
    for number, line in enumerate(open(path, encoding="utf-8"), 1):
        match = re.match(r"\s*-\s*\[(.*)\]", line.split("#")[0])
        if match:
            wall = numbers(match.group(1), f"{path}:{number}")
            if len(wall) != 5:
                fail(f"{path}:{number}: a wall has 5 numbers, not {len(wall)}")
            walls.append(wall)
    return walls or fail(f"{path}: no walls")


def read_grid(path):
    text = open(path, encoding="utf-8").read()
    resolution = re.search(r"^resolution:\s*(\S+)", text, re.M)
    origin = re.search(r"^origin:\s*\[(.*)\]", text, re.M)
    if not resolution or not origin:
        fail(f"{path}: resolution or origin is missing")
    resolution_m = numbers(resolution.group(1), path)[0]
    if not resolution_m > 0:
        fail(f"{path}: resolution {resolution_m} is not positive")
    return resolution_m, numbers(origin.group(1), path)


class Image:
    def __init__(self, walls, resolution_m, origin):
        self.resolution_m, self.origin = resolution_m, origin
        self.width = self.cells_to(max(max(w[0], w[2]) for w in walls), 0)
        self.height = self.cells_to(max(max(w[1], w[3]) for w in walls), 1)
        if min(min(w[0], w[2]) for w in walls) < origin[0] or \
                min(min(w[1], w[3]) for w in walls) < origin[1]:
            fail(f"a wall lies left of or below the origin {origin[:2]}")
        self.rows = [bytearray([UNKNOWN]) * self.width for _ in range(self.height)]

    def cells_to(self, metres, axis):
        return math.ceil((metres + MARGIN_M - self.origin[axis]) / self.resolution_m)

    def cell(self, x, y):
        return (math.floor((x - self.origin[0]) / self.resolution_m),
                math.floor((y - self.origin[1]) / self.resolution_m))

    def draw(self, x1, y1, x2, y2):
        """Marks each cell on the segment; steps of a quarter cell leave no diagonal gap wider
        than the fill's 4-neighbourhood can pass."""
        steps = max(1, math.ceil(4 * math.hypot(x2 - x1, y2 - y1) / self.resolution_m))
        for i in range(steps + 1):
            column, row = self.cell(x1 + (x2 - x1) * i / steps, y1 + (y2 - y1) * i / steps)
            self.rows[row][column] = OCCUPIED

    def fill_free(self, x, y):
        open_cells = [self.cell(x, y)]
        while open_cells:
            column, row = open_cells.pop()
            inside = 0 <= column < self.width and 0 <= row < self.height
            if inside and self.rows[row][column] == UNKNOWN:
                self.rows[row][column] = FREE
                open_cells += [(column + 1, row), (column - 1, row),
                               (column, row + 1), (column, row - 1)]

    def write(self, path):
        with open(path, "wb") as file:
            file.write(f"P5\n{self.width} {self.height}\n255\n".encode())
            for row in reversed(self.rows):  # the first row of the file is the top of the map
                file.write(row)


def main():
    if len(sys.argv) != 4:
        fail("usage: draw_map.py WALLS.yaml MAP.yaml OUT.pgm")
    walls = read_walls(sys.argv[1])
    image = Image(walls, *read_grid(sys.argv[2]))
    for wall in walls:
        image.draw(*wall[:4])
    image.fill_free(0.0, 0.0)
    image.write(sys.argv[3])


if __name__ == "__main__":
    main()
