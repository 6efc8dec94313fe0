#!/usr/bin/env python3
"""Checks who includes whom under src/sinew. Prints one line for each offense; exit code 1 if there is any.

    tools/check_layers.py [ROOT]

The tables below are the rule. A new folder or a new third-party library needs a line here, and a reason in docs/decisions.
"""
import fnmatch
import re
import sys
from pathlib import Path

PHYSICS = {"kernels", "corrections", "materials", "stabilization", "contact_laws", "damage"}
SOLVER = {"core", "particles", "neighbors", "parallel"} | PHYSICS

# Folder -> the folders it may include besides itself.
MAY_INCLUDE = {
    "core": set(),
    **{folder: {"core"} for folder in PHYSICS},
    "particles": {"core"},
    "neighbors": {"core", "particles"},
    "parallel": {"core", "particles", "neighbors"},
    "formulations": SOLVER,
    "contact": SOLVER,
    "time": SOLVER | {"formulations", "contact"},
    "implicit": SOLVER | {"formulations"},
    "model": SOLVER | {"formulations", "contact", "time", "implicit"},
    "io": {"core", "particles", "parallel"},
    "cli": SOLVER | {"formulations", "contact", "time", "implicit", "model", "io"},
}

# Third-party header -> the files (patterns under src/sinew) that may include it.
THIRD_PARTY = {
    "toml++/*": ["io/read_toml.cpp"],
    "mpi.h": ["parallel/*"],
    "petsc*.h": ["implicit/newton.cpp", "implicit/petsc_session.*"],
    "scotch.h": ["parallel/decomposition.cpp"],
    "hdf5.h": ["io/hdf5_handle.hpp"],
    "cairo*": ["io/picture*.cpp"],
    "muParser*": ["model/expression.cpp"],
    "CLI/*": ["cli/*"],
    "nlohmann/*": ["io/summary.cpp", "cli/verify_table.cpp"],
    "zlib.h": ["io/checksum.cpp"],
    "fmt/*": [f"{folder}/*" for folder in MAY_INCLUDE if folder != "core" and folder not in PHYSICS],
}

# The operating system and the compiler: not everywhere either.
SYSTEM = {
    "omp.h": ["neighbors/*", "formulations/*", "contact/*", "time/*", "model/*", "cli/*"],
    "immintrin.h": ["core/*"],
    "unistd.h": ["io/*", "cli/*", "model/bodies.cpp"],
    "fcntl.h": ["io/*"],
    "sys/mman.h": ["particles/aligned_array.*"],
    "sys/*": ["io/*", "cli/*"],
    "sched.h": ["cli/*"],
}

# Point-wise physics, which is all in headers, has no containers and no streams.
NOT_IN_PHYSICS = {
    "vector", "map", "set", "unordered_map", "unordered_set", "list", "deque", "queue", "stack", "memory",
    "iostream", "istream", "ostream", "fstream", "sstream", "thread", "mutex", "filesystem",
}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def allowed(table, header, file):
    """None if no pattern of the table matches the header, else whether the file may include it."""
    for pattern, files in table.items():
        if fnmatch.fnmatch(header, pattern):
            return any(fnmatch.fnmatch(file, place) for place in files)
    return None


def offense(file, bracket, header):
    """What is wrong with `header` in `file` (relative to src/sinew), or None."""
    folder = file.split("/")[0]
    if bracket == '"':
        return f'write <sinew/...> instead of "{header}"'
    if header.startswith("sinew/"):
        target = header.split("/")[1]
        if target == folder or target in MAY_INCLUDE[folder]:
            return None
        known = ", ".join(sorted(MAY_INCLUDE[folder])) or "nothing else of sinew"
        return f"{folder} must not include {target} (it may include: {known})"
    for table in (THIRD_PARTY, SYSTEM):
        verdict = allowed(table, header, file)
        if verdict is False:
            places = next(files for pattern, files in table.items() if fnmatch.fnmatch(header, pattern))
            return f"<{header}> belongs in {', '.join(places)} only"
        if verdict:
            return None
    if "/" in header or header.endswith((".h", ".hpp")):
        return f"<{header}> is not in the tables of tools/check_layers.py"
    if folder in PHYSICS and file.endswith(".hpp") and header in NOT_IN_PHYSICS:
        return f"{folder} is point-wise physics: no containers, streams or threads (<{header}>)"
    return None


def check(root):
    """All offenses under root/src/sinew as printable lines."""
    base = Path(root) / "src" / "sinew"
    lines = []
    for path in sorted(p for p in base.rglob("*") if p.suffix in {".hpp", ".cpp", ".in"}):
        file = path.relative_to(base).as_posix()
        where = path.relative_to(root).as_posix()
        if file.split("/")[0] not in MAY_INCLUDE:
            lines.append(f"{where}:1: folder {file.split('/')[0]} is not in the tables of tools/check_layers.py")
            continue
        for number, text in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            match = INCLUDE.match(text)
            wrong = match and offense(file, *match.groups())
            if wrong:
                lines.append(f"{where}:{number}: {wrong}")
    return lines


def main():
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent
    lines = check(root)
    print("\n".join(lines) if lines else "layers: every include follows the rules")
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main())
