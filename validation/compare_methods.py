#!/usr/bin/env python3
"""Runs the examples of Wiragunarsa et al. (2024) with every method and prints a table: how far each gets, what it keeps, what it costs.

    validation/compare_methods.py [-j 2] [--program ./sinew]

Each method runs with the integrator, time step and correction that suit it; the cases are those of the folders wiragunarsa2024_*.
"""
import argparse
import csv
import json
import os
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor

HERE = os.path.dirname(os.path.abspath(__file__))
STAGES = ['solver.integrator="rk3"', "solver.cfl=0.9", 'solver.wave_speed="reference"']
LEAPFROG = ['solver.integrator="velocity_verlet"', "solver.cfl=0.3", 'solver.wave_speed="bound"']
JST = 'formulation.stabilization=[{model="jst",eta2=0.1,eta4=0}]'
STIFF = 'formulation.stabilization=[{model="hourglass_stiffness"}]'
NONE = "formulation.stabilization=[]"


def form(gradient, momentum, correction):
    return [f'formulation.deformation_gradient="{gradient}"', f'formulation.momentum="{momentum}"', f'formulation.correction="{correction}"']


METHODS = {
    "direct, hourglass stiffness": form("direct", "adjoint", "gradient") + [STIFF] + LEAPFROG,
    "direct, symmetric, JST": form("direct", "symmetric", "mixed") + [JST] + STAGES,
    "direct, adjoint, JST": form("direct", "adjoint", "mixed") + [JST] + STAGES,
    "bond, symmetric, JST (published)": form("bond", "symmetric", "mixed") + [JST] + STAGES,
    "bond, adjoint, JST": form("bond", "adjoint", "mixed") + [JST] + STAGES,
    "bond, symmetric, hourglass stiffness": form("bond", "symmetric", "gradient") + [STIFF] + STAGES,
    "bond_variational": form("bond_variational", "adjoint", "mixed") + [NONE] + STAGES,
    "bond_variational, JST": form("bond_variational", "adjoint", "mixed") + [JST] + STAGES,
    "bond_variational, hourglass stiffness": form("bond_variational", "adjoint", "gradient") + [STIFF] + LEAPFROG,
}
SUPPORT = "formulation.support=3.0"
CASES = {
    "bending": ("bending/column_bond.toml", []),
    "pulling": ("pulling/column_bond.toml", ['study.vary={"parameters.nu"=[0.45]}']),
    "twisting": ("twisting/column_bond.toml", ['study.vary={"parameters.omega"=[400]}']),
    "spinning": ("spinning/plate_projected.toml", ["formulation.project_angular_momentum=false", SUPPORT]),
    "swinging": ("swinging/plate_bond.toml", ['study.vary={"parameters.n"=[20]}', SUPPORT]),
}


def column(rows, name):
    key = next(k for k in rows[0] if k.split(" ")[0] == name)
    return [float(row[key]) for row in rows]


def run_case(program, out, method, case, more=()):
    """(summary, rows of the history) of one run in the folder `out`."""
    path, settings = CASES[case]
    sets = [*settings, *more, *METHODS[method]]
    if case == "pulling":  # waves become three times as fast
        sets = [s.replace("solver.cfl=0.9", "solver.cfl=0.3") for s in sets]
    if case == "twisting":
        sets = [s.replace('"reference"', '"bound"') for s in sets]
    command = [program, "run", os.path.join(HERE, "wiragunarsa2024_" + path), "-o", out, "--force", "-t", "1"]
    for s in sets:
        command += ["--set", s]
    subprocess.run(command, capture_output=True, check=False)
    for found, _, files in os.walk(out):
        if "summary.json" in files and "history.csv" in files:
            with open(os.path.join(found, "history.csv"), encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
            with open(os.path.join(found, "summary.json"), encoding="utf-8") as file:
                return json.load(file), rows
    raise SystemExit(f"{method}, {case}: no results in {out}")


def describe(case, summary, rows):
    done, seconds = summary["status"] == "completed", summary["stepping_seconds"]
    energy, time = column(rows, "energy.total"), column(rows, "time")
    if case == "pulling":
        return f"{'' if done else 'fails at '}{1 + 20 * time[-1] / 6:.2f}, {seconds:.1f} s"
    if not done:
        return f"fails at {time[-1]:.3g} s"
    if case == "spinning":
        spin = column(rows, "spin")
        return f"{spin[-1] / spin[0] - 1:+.1e}, {energy[-1] / energy[0] - 1:+.1e}"
    if case == "swinging":
        return f"{100 * column(rows, 'error')[-1]:.2f} %"
    return f"{100 * (energy[-1] / energy[0] - 1):+.2g} %, {seconds:.1f} s"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-j", type=int, default=2, help="runs at a time")
    parser.add_argument("--program", default=os.path.join(HERE, "..", "sinew"))
    arguments = parser.parse_args()
    print("| method | bending: energy, time to solution | pulling: stretch, time | twisting at 400 rad/s: energy, time | spinning: angular momentum, energy | "
          "swinging: error at 20 cells |\n|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(arguments.j) as pool:
        work = {(m, c): pool.submit(run_case, arguments.program, os.path.join(folder, f"{list(METHODS).index(m)}_{c}"), m, c)
                for m in METHODS for c in CASES}
        for method in METHODS:
            print(f"| {method} | " + " | ".join(describe(c, *work[method, c].result()) for c in CASES) + " |", flush=True)


if __name__ == "__main__":
    main()
