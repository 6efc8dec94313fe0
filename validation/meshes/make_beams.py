#!/usr/bin/env python3
"""Makes the points of the beams of Ren et al. (2020), sec. 6.1, 6.3 and 6.4. Needs Gmsh (made with 4.8.4) and nothing else.

beam_N.csv: nodes of an unstructured mesh of tetrahedra of the box [0, 8] x [-1.5, 1.5] x [0, 2], each with a quarter of the volumes of its tetrahedra. The mesh size is the one, in steps of 1 %, whose number of
nodes is nearest to the published 286, 695, 2609 and 14250; N is the number it gives.
strip_N.csv: the same in the plane, nodes of triangles of [0, 8] x [-1.5, 1.5].
quads_N.msh: the unit square in N irregular quadrilaterals, for sec. 6.2, whose number is not published; those of the same section are drawn, and are about as uneven. Gmsh format 2.2.
"""

import csv
import pathlib
import subprocess
import tempfile

from make_meshes import read_mesh

HERE = pathlib.Path(__file__).resolve().parent
LENGTH, HEIGHT, WIDTH = 8.0, 3.0, 2.0


def mesh(dimension, size):
    lines = [
        "Mesh.Algorithm = 5; Mesh.Algorithm3D = 1;  // Delaunay",
        f"Mesh.CharacteristicLengthMin = {size}; Mesh.CharacteristicLengthMax = {size};",
        "Mesh.Smoothing = 0; Mesh.Optimize = 1;",
        'SetFactory("OpenCASCADE");',
        f"Rectangle(1) = {{0, {-HEIGHT / 2}, 0, {LENGTH}, {HEIGHT}}};",
    ]
    if dimension == 3:
        lines.append(f"Extrude {{0, 0, {WIDTH}}} {{ Surface{{1}}; }}")
        lines.append('Physical Volume("beam") = {1};')
    else:
        lines.append('Physical Surface("strip") = {1};')
    with tempfile.TemporaryDirectory() as folder:
        geo, msh = pathlib.Path(folder) / "beam.geo", pathlib.Path(folder) / "beam.msh"
        geo.write_text("\n".join(lines) + "\n")
        subprocess.run(["gmsh", f"-{dimension}", str(geo), "-format", "msh22", "-o", str(msh), "-v", "2"], check=True,
                       capture_output=True)
        return read_mesh(msh, 4 if dimension == 3 else 2)[:2]


def size_of(corners):
    """Volume of a tetrahedron or area of a triangle."""
    origin, *others = corners
    edges = [[b - a for a, b in zip(origin, other)] for other in others]
    if len(edges) == 2:
        return abs(edges[0][0] * edges[1][1] - edges[0][1] * edges[1][0]) / 2
    (a, b, c) = edges
    return abs(
        a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
    ) / 6


def points_of(dimension, size):
    nodes, elements = mesh(dimension, size)
    place = {number: [float(word) for word in words] for number, words in nodes.items()}
    volume = {}
    for _, _, corners in elements:
        part = size_of([place[c] for c in corners]) / len(corners)
        for corner in corners:
            volume[corner] = volume.get(corner, 0.0) + part
    return [(*place[number][:dimension], volume[number]) for number in sorted(volume)]


def write(dimension, wanted):
    size = (LENGTH * HEIGHT * (WIDTH if dimension == 3 else 1.0) / wanted) ** (1 / dimension) * 1.5
    best = None
    for _ in range(90):
        points = points_of(dimension, size)
        if best is None or abs(len(points) - wanted) < abs(len(best) - wanted):
            best = points
        if len(points) > 1.05 * wanted:
            break
        size *= 0.99
    name = f"{'beam' if dimension == 3 else 'strip'}_{len(best)}.csv"
    with open(HERE / name, "w", newline="", encoding="utf-8") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["x", "y", "z", "volume"] if dimension == 3 else ["x", "y", "volume"])
        out.writerows([f"{value:.7g}" for value in point] for point in best)
    print(name, "volume", sum(point[-1] for point in best))


def make_quads(size):
    """Triangles of the frontal method, joined."""
    lines = [
        "Mesh.Algorithm = 6; Mesh.RecombinationAlgorithm = 2; Mesh.Smoothing = 1;",
        f"Mesh.CharacteristicLengthMin = {size}; Mesh.CharacteristicLengthMax = {size};",
        'SetFactory("OpenCASCADE");',
        "Rectangle(1) = {0, 0, 0, 1, 1};",
        "Recombine Surface {1};",
        'Physical Surface("plate") = {1};',
    ]
    with tempfile.TemporaryDirectory() as folder:
        geo, msh = pathlib.Path(folder) / "quads.geo", pathlib.Path(folder) / "quads.msh"
        geo.write_text("\n".join(lines) + "\n")
        subprocess.run(["gmsh", "-2", str(geo), "-format", "msh22", "-o", str(msh), "-v", "2"], check=True, capture_output=True)
        count = len(read_mesh(msh, 3)[1])
        (HERE / f"quads_{count}.msh").write_text(msh.read_text())
    print(f"quads_{count}.msh")


if __name__ == "__main__":
    make_quads(0.07)
    for count in (286, 695, 2609, 14250):
        write(3, count)
    write(2, 300)
