#!/usr/bin/env python3
"""Quasi-static reference of the dog-bone tensile specimen with CalculiX: writes the deck, runs ccx and writes the curve.

    gmsh -3 specimen.geo -format msh22 -o specimen.msh
    ./make_reference.py                                    # specimen.inp, force_displacement.csv
    ./make_reference.py --element C3D8I --out other   # another element
    gmsh -3 specimen.geo -setnumber n 2 -format msh22 -o fine.msh
    ./make_reference.py --mesh fine.msh --out fine

Needs ccx (made with 2.20) and nothing else. Units: mm, kg, ms, so GPa and kN. With NLGEOM, *ELASTIC in CalculiX is linear between
Green-Lagrange strain and second Piola-Kirchhoff stress (St. Venant-Kirchhoff). The strain of an element is the Green-Lagrange
strain at its center, computed here from the nodal displacements; the force is the sum of the reactions in x of the right grip.
"""
import argparse
import math
import os
import pathlib
import shutil
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
HELD = 45.0         # nodes with |x| >= HELD are held, mm
LENGTH = 6.0        # distance by which the grips move apart, mm
INCREMENTS = 40
YOUNG, POISSON, DENSITY = 10.0, 0.3, 2.7e-6
STRAIN = 0.08       # where the summary reads displacement and force
CORNERS = [(-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)]


def read_mesh(path):
    """Nodes {number: (x, y, z)} and 8-node hexahedra {number: nodes} of a Gmsh MSH 2.2 file."""
    lines = pathlib.Path(path).read_text().split("\n")
    at = lines.index("$Nodes")
    nodes = {int(f[0]): tuple(map(float, f[1:4])) for f in (s.split() for s in lines[at + 2:at + 2 + int(lines[at + 1])])}
    at = lines.index("$Elements")
    elements = {}
    for line in lines[at + 2:at + 2 + int(lines[at + 1])]:
        f = list(map(int, line.split()))
        if f[1] != 5:
            raise SystemExit(f"{path}: element {f[0]} is not an 8-node hexahedron")
        elements[len(elements) + 1] = f[3 + f[2]:]
    return nodes, elements


def write_deck(path, nodes, elements, element_type):
    left = [n for n in nodes if nodes[n][0] <= -HELD + 1e-6]
    right = [n for n in nodes if nodes[n][0] >= HELD - 1e-6]
    rows = lambda numbers: [", ".join(map(str, numbers[i:i + 12])) for i in range(0, len(numbers), 12)]
    text = ["*HEADING", "Dog-bone tensile specimen; mm, kg, ms, GPa, kN. Written by make_reference.py.", "*NODE, NSET=all"]
    text += ["%d, %.10g, %.10g, %.10g" % (n, *nodes[n]) for n in sorted(nodes)]
    text += [f"*ELEMENT, TYPE={element_type}, ELSET=specimen"]
    text += [f"{e}, " + ", ".join(map(str, elements[e])) for e in sorted(elements)]
    text += ["*NSET, NSET=left", *rows(left), "*NSET, NSET=right", *rows(right)]
    text += ["*MATERIAL, NAME=elastic", "*ELASTIC", f"{YOUNG}, {POISSON}", "*DENSITY", f"{DENSITY}",
             "*SOLID SECTION, ELSET=specimen, MATERIAL=elastic",
             f"*STEP, NLGEOM, INC={INCREMENTS + 1}", "*STATIC, DIRECT", f"{1 / INCREMENTS}, 1.",
             "*BOUNDARY", "left, 2, 3, 0.", "right, 2, 3, 0.", f"left, 1, 1, {-LENGTH / 2}", f"right, 1, 1, {LENGTH / 2}",
             "*NODE PRINT, NSET=left, TOTALS=ONLY", "RF", "*NODE PRINT, NSET=right, TOTALS=ONLY", "RF", "*NODE PRINT, NSET=all", "U",
             "*END STEP"]
    path.write_text("\n".join(text) + "\n")


def read_results(path):
    """Time, reaction in x of both grips and nodal displacements, increment by increment."""
    step, kind = None, None
    with open(path) as file:
        for line in file:
            f = line.split()
            if not f:
                continue
            if "time" in f:
                time = float(f[-1])
                if step is None or time != step["time"]:
                    if step:
                        yield step
                    step = {"time": time, "u": {}}
                kind = "u" if f[0] == "displacements" else next(w.lower() for w in f if w in ("LEFT", "RIGHT"))
            elif kind == "u":
                step["u"][int(f[0])] = tuple(map(float, f[1:4]))
            else:
                step[kind] = float(f[0])
    if step:
        yield step


def inverse(m):
    (a, b, c), (d, e, f), (g, h, i) = m
    det = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    return [[(e * i - f * h) / det, (c * h - b * i) / det, (b * f - c * e) / det],
            [(f * g - d * i) / det, (a * i - c * g) / det, (c * d - a * f) / det],
            [(d * h - e * g) / det, (b * g - a * h) / det, (a * e - b * d) / det]], det


def jacobian(x, at=(0, 0, 0)):
    """dX/dxi of the trilinear element with corners x."""
    r = [[0.0] * 3 for _ in range(3)]
    for corner, p in zip(CORNERS, x):
        q = [1 + c * s for c, s in zip(corner, at)]
        slope = (corner[0] * q[1] * q[2] / 8, corner[1] * q[0] * q[2] / 8, corner[2] * q[0] * q[1] / 8)
        for i in range(3):
            for j in range(3):
                r[i][j] += p[i] * slope[j]
    return r


def center_slopes(x):
    """dN_a/dX at the center of an element."""
    inv, _ = inverse(jacobian(x))
    return [tuple(sum(c[k] / 8 * inv[k][j] for k in range(3)) for j in range(3)) for c in CORNERS]


def volume(x):
    g = 1 / math.sqrt(3)
    return sum(inverse(jacobian(x, tuple(g * s for s in c)))[1] for c in CORNERS)


def largest_principal(e):
    """Largest eigenvalue of a symmetric 3 x 3 matrix."""
    mean = (e[0][0] + e[1][1] + e[2][2]) / 3
    a, b, c = e[0][0] - mean, e[1][1] - mean, e[2][2] - mean
    f, g, h = e[0][1], e[0][2], e[1][2]
    p = math.sqrt((a * a + b * b + c * c + 2 * (f * f + g * g + h * h)) / 6)
    if p == 0:
        return mean
    half_det = (a * (b * c - h * h) - f * (f * c - h * g) + g * (f * h - b * g)) / (2 * p ** 3)
    return mean + 2 * p * math.cos(math.acos(max(-1.0, min(1.0, half_det))) / 3)


def strain(slopes, u):
    """Largest principal value of E = (F^T F - I)/2."""
    h = [[sum(ua[i] * s[j] for ua, s in zip(u, slopes)) for j in range(3)] for i in range(3)]
    return largest_principal([[(h[i][j] + h[j][i] + sum(h[k][i] * h[k][j] for k in range(3))) / 2 for j in range(3)] for i in range(3)])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--mesh", default=HERE / "specimen.msh")
    parser.add_argument("--element", default="C3D8R")
    parser.add_argument("--out", type=pathlib.Path, default=HERE, help="folder of specimen.inp and force_displacement.csv")
    args = parser.parse_args()

    nodes, elements = read_mesh(args.mesh)
    args.out.mkdir(parents=True, exist_ok=True)
    write_deck(args.out / "specimen.inp", nodes, elements, args.element)
    corners = {e: [nodes[n] for n in elements[e]] for e in elements}
    slopes = {e: center_slopes(corners[e]) for e in elements}
    center = {e: tuple(sum(p[i] for p in corners[e]) / 8 for i in range(3)) for e in elements}
    volumes = [volume(corners[e]) for e in elements]
    print(f"{len(nodes)} nodes, {len(elements)} {args.element}, volume {sum(volumes):.6g} mm^3, "
          f"of an element {min(volumes):.6g} to {max(volumes):.6g} mm^3")

    rows = [(0.0, 0.0, 0.0)]
    with tempfile.TemporaryDirectory() as work:
        shutil.copy(args.out / "specimen.inp", work)
        with open(os.path.join(work, "log"), "w") as log:
            environment = dict(os.environ, OMP_NUM_THREADS="1", CCX_NPROC_STIFFNESS="1")
            done = subprocess.run(["ccx", "specimen"], cwd=work, stdout=log, stderr=log, env=environment)
        if done.returncode:
            raise SystemExit(pathlib.Path(work, "log").read_text()[-2000:])
        for step in read_results(os.path.join(work, "specimen.dat")):
            value = {e: strain(slopes[e], [step["u"][n] for n in elements[e]]) for e in elements}
            largest = max(value.values())
            places = [e for e in value if value[e] > largest * (1 - 1e-4)]
            d, force = step["time"] * LENGTH, step["right"]
            rows.append((d, force, largest))
            print("d %.3f  F %.6f (left %.6f)  strain %.6f in element %d at (%.3f, %.3f, %.3f), within 1e-4 also in %d others"
                  % (d, force, step["left"], largest, places[0], *center[places[0]], len(places) - 1))
    with open(args.out / "force_displacement.csv", "w") as file:
        file.write("displacement_mm,force_kN,max_principal_strain\n")
        file.writelines("%.6g,%.6g,%.6g\n" % row for row in rows)

    # Stiffness at d = 0: parabola of F/d through the first three increments. Crossing: linear between increments.
    (d1, f1, _), (d2, f2, _), (d3, f3, _) = rows[1:4]
    print("initial stiffness %.5f kN/mm; F/d in the first increment %.5f" % (3 * f1 / d1 - 3 * f2 / d2 + f3 / d3, f1 / d1))
    for a, b in zip(rows, rows[1:]):
        if a[2] < STRAIN <= b[2]:
            t = (STRAIN - a[2]) / (b[2] - a[2])
            print("strain %g at d = %.4f mm, F = %.4f kN" % (STRAIN, a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])))


if __name__ == "__main__":
    main()
