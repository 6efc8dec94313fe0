#!/usr/bin/env python3
"""Writes disk.csv and upper_disk.csv: disks of radius 1 about (0, 0) and (0, 2) in rings of equal width with six more particles in each than in the one
before, so that their edges are round."""
import math

RINGS = 40

rows = []
for ring in range(RINGS + 1):
    count = max(1, 6 * ring)
    width = 1.0 / (RINGS + 0.5)
    inner, outer = max(0.0, (ring - 0.5) * width), (ring + 0.5) * width
    for k in range(count):
        angle = 2.0 * math.pi * (k + 0.5) / count
        rows.append((ring * width * math.cos(angle), ring * width * math.sin(angle), math.pi * (outer**2 - inner**2) / count))
for name, height in (("disk.csv", 0.0), ("upper_disk.csv", 2.0)):
    with open(name, "w", encoding="utf-8") as file:
        file.write("x,y,volume\n")
        for x, y, volume in rows:
            file.write(f"{x:.8g},{y + height:.8g},{volume:.8g}\n")
