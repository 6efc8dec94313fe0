#!/usr/bin/env python3
"""Bends the column of Wiragunarsa et al. (2024), section 5.3, with several methods and resolutions, and prints what an error of its tip costs.

    validation/time_to_solution.py [--program ./sinew] [--cells 3 4 6 8] [--reference 12] [--goal 0.25]

Error: root mean square over 1 s of the difference of the displacement of the tip from that of the reference, over the root mean square of the latter.
The reference has the direct gradient with hourglass stiffness. Seconds: of the steps, one thread, one run after the other. The cost of the goal is
interpolated in logarithms between resolutions. A run that fails has no error.
"""
import argparse
import math
import os
import tempfile

from compare_methods import HERE, METHODS, column, run_case

REFERENCE = "direct, hourglass stiffness"
COMPARED = [REFERENCE, "direct, symmetric, JST", "bond, symmetric, JST (published)", "bond_variational, hourglass stiffness"]
SAMPLES = 500


def tip(rows, samples=SAMPLES):
    """Displacement of the tip at equal times."""
    time, value = column(rows, "time"), column(rows, "tip")
    found, k = [], 0
    for s in range(samples + 1):
        t = s / samples * time[-1]
        while time[k + 1] < t:
            k += 1
        found.append(value[k] + (value[k + 1] - value[k]) * (t - time[k]) / (time[k + 1] - time[k]))
    return found


def error(values, exact):
    return math.sqrt(sum((a - b) ** 2 for a, b in zip(values, exact)) / sum(b * b for b in exact))


def cost(points, goal):
    """Seconds for the goal, from (error, seconds) of growing resolution; None where no two resolutions enclose it."""
    for (e1, s1), (e2, s2) in zip(points, points[1:]):
        if e1 >= goal >= e2:
            share = math.log(e1 / goal) / math.log(e1 / e2)
            return math.exp(math.log(s1) + share * math.log(s2 / s1))
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=os.path.join(HERE, "..", "sinew"))
    parser.add_argument("--cells", type=int, nargs="+", default=[3, 4, 6, 8])
    parser.add_argument("--reference", type=int, default=12)
    parser.add_argument("--goal", type=float, default=0.25)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        def bend(method, cells):
            return run_case(arguments.program, os.path.join(folder, f"{method}_{cells}"), method, "bending", [f"parameters.n={cells}"])

        exact = tip(bend(REFERENCE, arguments.reference)[1])
        head = " | ".join(f"{n} cells" for n in arguments.cells)
        print(f"| method | {head} | error of {100 * arguments.goal:g} % |\n|---|{'---|' * len(arguments.cells)}---|")
        for method in COMPARED:
            points, cells = [], []
            for n in arguments.cells:
                summary, rows = bend(method, n)
                if summary["status"] != "completed":
                    cells.append(f"fails at {column(rows, 'time')[-1]:.3g} s")
                    continue
                points.append((error(tip(rows), exact), summary["stepping_seconds"]))
                cells.append(f"{100 * points[-1][0]:.2g} %, {points[-1][1]:.1f} s")
            needed = cost(points, arguments.goal)
            print(f"| {method} | " + " | ".join(cells) + f" | {'not enclosed' if needed is None else f'{needed:.1f} s'} |", flush=True)


if __name__ == "__main__":
    main()
