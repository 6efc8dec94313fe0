#!/usr/bin/env python3
"""Compiles the point-wise physics for a device with nvcc (nothing is run, no device is needed). Exit code 1 if that fails.

    tools/check_device.py [ROOT]

Without nvcc (on PATH, in $CUDA_HOME or in /usr/local/cuda) it says that it was skipped; exit code 0.
"""
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SOURCE = "tests/device/point_physics.cu"


def find_nvcc(environment):
    """Path of nvcc, or None."""
    homes = [environment.get("CUDA_HOME"), "/usr/local/cuda"]
    folders = [environment.get("PATH", "")] + [str(Path(home) / "bin") for home in homes if home]
    return shutil.which("nvcc", path=os.pathsep.join(folders))


def check(root, nvcc):
    """(exit code, text)."""
    if nvcc is None:
        return 0, "device: skipped, since there is no nvcc"
    with tempfile.TemporaryDirectory() as folder:
        # as errors: a function of the host alone that is called on the device is only a warning inside of templates
        command = [nvcc, "-std=c++20", "-Werror", "all-warnings", "-I", str(Path(root) / "src"),
                   "-c", str(Path(root) / SOURCE), "-o", str(Path(folder) / "point_physics.o")]
        done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        return 1, f"{done.stdout}{done.stderr}device: the point-wise physics does not compile with {nvcc}"
    return 0, f"device: the point-wise physics compiles with {nvcc}"


def main():
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent
    code, text = check(root, find_nvcc(os.environ))
    print(text)
    return code


if __name__ == "__main__":
    sys.exit(main())
