#!/usr/bin/env python3
"""Runs three examples with every treatment of zero-energy modes and prints a table: survived, energy lost, noise of the pressure, cost.

    validation/compare_treatments.py [-j 2] [--program ./sinew]

The examples are those of zhang2024_plate (two periods), wiragunarsa2024_twisting (200 rad/s) and islam2019_column (3 s). Needs numpy and meshio. The noise is the root of the mean
square of what a linear fit to the nearest neighbors of a particle leaves of its pressure, over that of the pressure; at the end.
"""
import argparse
import csv
import glob
import json
import os
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor

import meshio
import numpy
from compare_methods import column

HERE = os.path.dirname(os.path.abspath(__file__))
TREATMENTS = {
    "reference: none": ("total_lagrangian", ""),
    "reference: hourglass_stiffness": ("total_lagrangian", '{model="hourglass_stiffness",alpha=%(alpha)s}'),
    "reference: non_nested_shear": ("total_lagrangian", '{model="non_nested_shear"}'),
    "reference: jst": ("total_lagrangian", '{model="jst",eta2=0.1,eta4=0}'),
    "current: none": ("updated_lagrangian", ""),
    "current: artificial_stress": ("updated_lagrangian", '{model="artificial_stress"}'),
    "current: artificial_pressure": ("updated_lagrangian", '{model="artificial_pressure"}'),
    "current: non_nested_shear, printed": ("updated_lagrangian", '{model="non_nested_shear",form="printed"}'),
    "current: non_nested_shear, objective": ("updated_lagrangian", '{model="non_nested_shear"}'),
}
FRAMES = ["output.every=1e9", 'output.fields=["pressure"]']
CASES = {
    "plate": ("zhang2024_plate/non_nested_objective.toml", {"alpha": 50, "viscosity": 0.1, "beta": 0}, ["solver.end_time=0.57", *FRAMES]),
    "twisting": ("wiragunarsa2024_twisting/column_stiffness.toml", {"alpha": 50, "viscosity": 0.1, "beta": 0},
                 ['study.vary={"parameters.omega"=[200]}', "body.0.geometry.on_faces=false", "boundary.0.region.where=\"Z < 1/n\"", *FRAMES]),
    "soil": ("islam2019_column/total_lagrangian.toml", {"alpha": 5, "viscosity": 2.5, "beta": 2.5}, ["solver.end_time=3", *FRAMES]),
}


def formulation(treatment, values):
    model, text = TREATMENTS[treatment]
    parts = [text % values] if "%" in text else [text] if text else []
    parts.append(f'{{model="artificial_viscosity",alpha={values["viscosity"]},beta={values["beta"]}}}')
    update = ",reference_update={threshold=2}" if model == "total_lagrangian" and values["alpha"] == 5 and "jst" not in text else ""
    return f'formulation={{model="{model}",kernel="wendland_c2",support=3.0,stabilization=[{",".join(parts)}]{update}}}'


def run_case(program, out, treatment, case):
    """(summary, rows of the history, last particle file) of one run in the folder `out`."""
    path, values, settings = CASES[case]
    command = [program, "run", os.path.join(HERE, path), "-o", out, "--force", "-t", "1"]
    for s in [*settings, formulation(treatment, values)]:
        command += ["--set", s]
    if case == "twisting":
        command += ["--set", 'solver={integrator="velocity_verlet",end_time=0.3}']
    done = subprocess.run(command, capture_output=True, check=False, text=True)
    for found, _, files in os.walk(out):
        if "summary.json" in files and "history.csv" in files:
            with open(os.path.join(found, "history.csv"), encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
            with open(os.path.join(found, "summary.json"), encoding="utf-8") as file:
                return json.load(file), rows, sorted(glob.glob(os.path.join(found, "particles", "*.vtu")))[-1]
    raise SystemExit(f"{treatment}, {case}: no results: {done.stderr}")


def noise(file):
    state = meshio.read(file)
    x, p = state.points, state.point_data["pressure"]
    flat = numpy.ptp(x[:, 2]) == 0.0
    count, dimensions = (8, 2) if flat else (18, 3)
    left = numpy.empty(len(p))
    for i in range(len(p)):
        near = numpy.argpartition(numpy.sum((x - x[i]) ** 2, axis=1), count + 1)[: count + 1]
        near = near[near != i]
        fit = numpy.column_stack([numpy.ones(len(near)), (x[near] - x[i])[:, :dimensions]])
        left[i] = p[i] - numpy.linalg.lstsq(fit, p[near], rcond=None)[0][0]
    return numpy.sqrt(numpy.mean(left**2) / numpy.mean(p**2))


def describe(case, summary, rows, file):
    time = column(rows, "time")
    if summary["status"] != "completed":
        return f"fails at {time[-1]:.3g} s"
    energy = column(rows, "energy.total")
    change = f"run-out {column(rows, 'runout')[-1] - 4:.2f} m" if case == "soil" else f"{100 * (energy[-1] / energy[0] - 1):+.2g} %"
    return f"{change}, {100 * noise(file):.0f} %, {summary['stepping_seconds']:.1f} s"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-j", type=int, default=2, help="runs at a time")
    parser.add_argument("--program", default=os.path.join(HERE, "..", "sinew"))
    arguments = parser.parse_args()
    print("| treatment | plate: energy, noise, time | twisting column: energy, noise, time | soil: run-out, noise, time |\n|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(arguments.j) as pool:
        work = {(t, c): pool.submit(run_case, arguments.program, os.path.join(folder, f"{list(TREATMENTS).index(t)}_{c}"), t, c)
                for t in TREATMENTS for c in CASES}
        for treatment in TREATMENTS:
            print(f"| {treatment} | " + " | ".join(describe(c, *work[treatment, c].result()) for c in CASES) + " |", flush=True)


if __name__ == "__main__":
    main()
