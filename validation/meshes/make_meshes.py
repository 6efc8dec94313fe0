#!/usr/bin/env python3
"""Makes the meshes in this folder and the small ones of tests/unit/geometry/data. Needs Gmsh (made with 4.8.4) and nothing else.

square_444: the unit square in exactly 444 strongly irregular quadrilaterals. Random points with a least distance are triangulated
(Delaunay), the triangles joined to quadrilaterals and what is left cut so that only quadrilaterals remain. The script takes the
first seed that gives 444 of them with no angle too near to 0 or 180 degrees. The same seed always gives the same mesh.

    square_444.geo     what Gmsh reads        square_444.msh     Gmsh format 2.2
    square_444_41.msh  Gmsh format 4.1        square_444.inp     Abaqus
"""

import math
import pathlib
import random
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
TEST_DATA = HERE.parent.parent / "tests" / "unit" / "geometry" / "data"
WANTED = 444
EDGE_DIVISIONS = 10
LEAST_DISTANCE = 0.075  # between two random points
LEAST_SINE = 0.35  # of the angles of a quadrilateral


def run_gmsh(geo, out, mesh_format, dimension=2, options=()):
    command = ["gmsh", f"-{dimension}", str(geo), "-format", mesh_format, "-o", str(out), "-v", "2", *options]
    subprocess.run(command, check=True, capture_output=True)


def random_points(seed):
    """Points in the square, none nearer than LEAST_DISTANCE to another."""
    source = random.Random(seed)
    margin = 0.06
    points = []
    for _ in range(4000):
        candidate = (round(source.uniform(margin, 1 - margin), 6), round(source.uniform(margin, 1 - margin), 6))
        if all(math.dist(candidate, p) > LEAST_DISTANCE for p in points):
            points.append(candidate)
    return points


def square_geo(seed):
    points = random_points(seed)
    lines = [
        f"// The unit square in irregular quadrilaterals; random points from seed {seed}. Written by make_meshes.py.",
        "Mesh.Algorithm = 5;  // Delaunay",
        "Mesh.RecombinationAlgorithm = 2;  // only quadrilaterals",
        "Mesh.Smoothing = 0;  // keep it irregular",
        "Mesh.CharacteristicLengthExtendFromBoundary = 0;",
        "Mesh.CharacteristicLengthMax = 10;",
    ]
    lines += [f"Point({i + 1}) = {{{x}, {y}, 0, 10}};" for i, (x, y) in enumerate([(0, 0), (1, 0), (1, 1), (0, 1)])]
    lines += [f"Line({i + 1}) = {{{i + 1}, {(i + 1) % 4 + 1}}};" for i in range(4)]
    lines += [f"Transfinite Curve {{1:4}} = {EDGE_DIVISIONS + 1};", "Curve Loop(1) = {1, 2, 3, 4};", "Plane Surface(1) = {1};"]
    lines += [f"Point({100 + i}) = {{{x}, {y}, 0, 10}};" for i, (x, y) in enumerate(points)]
    lines += [f"Point {{100:{99 + len(points)}}} In Surface {{1}};", "Recombine Surface {1};", 'Physical Surface("square") = {1};']
    return "\n".join(lines) + "\n"


def read_mesh(path, element_type):
    """Nodes {number: three texts}, elements [(number, group, nodes)] of one Gmsh type, and group names, of a file of format 2.2."""
    lines = path.read_text().split("\n")

    def section(name):
        begin = lines.index(f"${name}")
        return [line.split() for line in lines[begin + 2 : begin + 2 + int(lines[begin + 1])]]

    names = {int(words[1]): words[2].strip('"') for words in section("PhysicalNames")}
    nodes = {int(words[0]): words[1:4] for words in section("Nodes")}
    elements = []
    for words in section("Elements"):
        numbers = [int(word) for word in words]
        if numbers[1] == element_type:
            elements.append((numbers[0], numbers[3], numbers[3 + numbers[2] :]))
    return nodes, elements, names


def quality(nodes, elements):
    """Smallest sine of an angle, and the areas."""
    least_sine, areas = 1.0, []
    for _, _, corners in elements:
        p = [(float(nodes[c][0]), float(nodes[c][1])) for c in corners]
        area = 0.0
        for i in range(4):
            here, after, before = p[i], p[(i + 1) % 4], p[i - 1]
            u = (after[0] - here[0], after[1] - here[1])
            v = (before[0] - here[0], before[1] - here[1])
            least_sine = min(least_sine, (u[0] * v[1] - u[1] * v[0]) / (math.hypot(*u) * math.hypot(*v)))
            area += 0.5 * (here[0] * after[1] - after[0] * here[1])
        areas.append(area)
    return least_sine, areas


def write_abaqus(path, msh, element_type, abaqus_name):
    """The same mesh as an Abaqus file; the coordinates are copied digit by digit."""
    nodes, elements, names = read_mesh(msh, element_type)
    lines = ["*HEADING", msh.stem, "*NODE"]
    lines += [f"{number}, {', '.join(place)}" for number, place in nodes.items()]
    lines.append(f"*ELEMENT, TYPE={abaqus_name}")
    for number, _, corners in elements:
        lines.append(f"{number}, {', '.join(str(c) for c in corners)}")
    for group in sorted({group for _, group, _ in elements}):
        members = [str(number) for number, g, _ in elements if g == group]
        lines.append(f"*ELSET, ELSET={names[group]}")
        lines += [", ".join(members[i : i + 12]) for i in range(0, len(members), 12)]
    path.write_text("\n".join(lines) + "\n")


def make_square():
    for seed in range(1, 1000):
        with tempfile.TemporaryDirectory() as folder:
            geo, msh = pathlib.Path(folder) / "square.geo", pathlib.Path(folder) / "square.msh"
            geo.write_text(square_geo(seed))
            run_gmsh(geo, msh, "msh22")
            nodes, elements, _ = read_mesh(msh, 3)
            triangles = read_mesh(msh, 2)[1]
        if len(elements) != WANTED or triangles:
            continue
        least_sine, areas = quality(nodes, elements)
        if least_sine >= LEAST_SINE:
            break
    else:
        raise SystemExit("no seed gives the wanted mesh")
    geo = HERE / "square_444.geo"
    geo.write_text(square_geo(seed))
    run_gmsh(geo, HERE / "square_444.msh", "msh22")
    run_gmsh(geo, HERE / "square_444_41.msh", "msh41")
    write_abaqus(HERE / "square_444.inp", HERE / "square_444.msh", 3, "CPS4")
    print(f"square_444: seed {seed}, {len(elements)} quadrilaterals, smallest sine of an angle {least_sine:.3f}, ", end="")
    print(f"areas {min(areas):.2e} to {max(areas):.2e}, sum {sum(areas):.15f}")


def make_test_data():
    geo = TEST_DATA / "two_blocks.geo"
    for name, element_type, abaqus_name, switch in (("tetrahedra", 4, "C3D4", "0"), ("hexahedra", 5, "C3D8R", "1")):
        options = ("-setnumber", "hexahedra", switch)
        run_gmsh(geo, TEST_DATA / f"{name}_22.msh", "msh22", 3, options)
        run_gmsh(geo, TEST_DATA / f"{name}_41.msh", "msh41", 3, options)
        write_abaqus(TEST_DATA / f"{name}.inp", TEST_DATA / f"{name}_22.msh", element_type, abaqus_name)
        print(f"{name}: {len(read_mesh(TEST_DATA / f'{name}_22.msh', element_type)[1])} elements")


if __name__ == "__main__":
    make_square()
    make_test_data()
