"""Reads a series of particle files with VTK and with meshio, as users do, and compares every number.

Usage: vtk_readers_test.py WRITER vtk|meshio     (WRITER FOLDER writes the series; exit code 77: the reader is not installed)
"""

import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

SKIPPED = 77
FIELDS = {"pressure": 1, "velocity": 3, "cauchy_stress": 6, "deformation_gradient": 9}


def known_values(numpy, frame, count, components):
    particle, component = numpy.arange(count)[:, None], numpy.arange(components)[None, :]
    return 1000.0 * frame + particle + 0.125 * component + 1.0 / 3.0


def read_with_vtk(numpy, path):
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy

    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    failures = []
    reader.AddObserver("ErrorEvent", lambda *event: failures.append(event))
    reader.Update()
    assert not failures, f"VTK reports errors in {path}"
    grid = reader.GetOutput()
    count = grid.GetNumberOfPoints()
    assert grid.GetNumberOfCells() == count
    assert all(grid.GetCellType(i) == vtk.VTK_VERTEX and grid.GetCell(i).GetPointId(0) == i for i in range(min(count, 100)))
    data = grid.GetPointData()
    fields = {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())}
    points = vtk_to_numpy(grid.GetPoints().GetData()) if count else numpy.zeros((0, 3))
    return points, fields, grid.GetFieldData().GetArray("TimeValue").GetValue(0)


def read_with_meshio(numpy, path):
    import meshio

    mesh = meshio.read(path)
    assert [block.type for block in mesh.cells] == ["vertex"]
    assert numpy.array_equal(mesh.cells[0].data[:, 0], numpy.arange(len(mesh.points)))
    return mesh.points, mesh.point_data, float(numpy.ravel(mesh.field_data["TimeValue"])[0])


def check_frame(numpy, read, path, frame, count, real="float64"):
    """`real`: numbers are the known ones, rounded to that type."""
    points, fields, time_in_file = read(numpy, path)
    assert time_in_file == 0.1 * frame, (time_in_file, frame)
    assert points.shape == (count, 3)
    if count:
        assert points.dtype == real, points.dtype
    assert numpy.array_equal(points, known_values(numpy, frame, count, 3).astype(real))
    for name, components in FIELDS.items():
        values = numpy.asarray(fields[name]).reshape(count, -1) if count else numpy.zeros((0, components))
        assert numpy.asarray(fields[name]).ndim == (1 if components == 1 else 2), name
        assert count == 0 or values.dtype == real, (name, values.dtype)
        assert numpy.array_equal(values, known_values(numpy, frame, count, components).astype(real)), name
    assert fields["body"].dtype == numpy.int32 and numpy.array_equal(fields["body"], numpy.arange(count) % 2)
    assert fields["particle_id"].dtype == numpy.int32 and numpy.array_equal(fields["particle_id"], numpy.arange(count))


def main():
    writer, reader_name = sys.argv[1:]
    try:
        import numpy

        __import__(reader_name)
    except ImportError as error:
        print(f"skipped: {error}")
        return SKIPPED
    read = {"vtk": read_with_vtk, "meshio": read_with_meshio}[reader_name]
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([writer, folder], check=True)
        frames = xml.etree.ElementTree.parse(os.path.join(folder, "particles.pvd")).getroot().findall("./Collection/DataSet")
        assert len(frames) == 3
        for index, frame in enumerate(frames):
            time = float(frame.attrib["timestep"])
            assert time == 0.1 * index
            check_frame(numpy, read, os.path.join(folder, frame.attrib["file"]), index, 70000 if index == 1 else 5)
        check_frame(numpy, read, os.path.join(folder, "particles/frame_000098.vtu"), 98, 70000, "float32")
        if reader_name == "vtk":
            check_frame(numpy, read, os.path.join(folder, "particles/frame_000099.vtu"), 99, 0)
    return 0


sys.exit(main())
