#!/usr/bin/python3
"""Draws the errors of the swinging plate over the spacing, and the loss of angular momentum of the spinning plate, as the paper's figures 9 and 12.

    validation/plot_orders.py docs/images/orders.png [--program ./sinew]        # needs Matplotlib
"""
import argparse
import csv
import os
import subprocess
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

HERE = os.path.dirname(os.path.abspath(__file__))
PLATES = {"plate_bond": "bond, linear", "plate_bond_mixed": "bond, mixed", "plate_variational": "bond_variational, linear"}


def study(program, folder, path):
    out = os.path.join(folder, os.path.basename(path))
    subprocess.run([program, "run", os.path.join(HERE, "wiragunarsa2024_" + path), "-o", out], capture_output=True, check=False)
    with open(os.path.join(out, "study.csv"), encoding="utf-8") as file:
        return list(csv.DictReader(file)), out


def drift(out, run):
    with open(os.path.join(out, run, "history.csv"), encoding="utf-8") as file:
        spin = [float(next(v for k, v in row.items() if k.split(" ")[0] == "spin")) for row in csv.DictReader(file)]
    return max(abs(value / spin[0] - 1) for value in spin)


def guide(axes, x, y, order):
    axes.loglog(x, [y * (value / x[-1]) ** order for value in x], color="0.6", lw=1, ls="--")
    axes.annotate(f"order {order}", (x[-1], y), textcoords="offset points", xytext=(14, 0), color="0.4")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("picture")
    parser.add_argument("--program", default=os.path.join(HERE, "..", "sinew"))
    arguments = parser.parse_args()
    figure, (plate, gradient, spin) = plt.subplots(1, 3, figsize=(12, 4), constrained_layout=True)
    with tempfile.TemporaryDirectory() as folder:
        for name, label in PLATES.items():
            rows, _ = study(arguments.program, folder, f"swinging/{name}.toml")
            x = [2 / float(row["parameters.n"]) for row in rows]
            plate.loglog(x, [float(row["error"]) for row in rows], "o-", label=label)
            gradient.loglog(x, [float(row["gradient_error"]) for row in rows], "o-", label=label)
        guide(plate, x, 1.5e-3, 2)
        guide(gradient, x, 1e-2, 1)
        rows, out = study(arguments.program, folder, "spinning/plate.toml")
        x = [1 / float(row["parameters.n"]) for row in rows]
        spin.loglog(x, [drift(out, row["folder"]) for row in rows], "o-", color="tab:red", label="bond, linear, CFL 0.9")
        guide(spin, x, 2.5e-4, 3)
    for axes, title in ((plate, "swinging plate: displacement, L2"), (gradient, "swinging plate: gradient, H1"), (spin, "spinning plate: angular momentum lost")):
        axes.set_title(title, fontsize=10)
        axes.set_xlabel("spacing [m]")
        axes.set_ylabel("relative error" if axes is not spin else "part")
        axes.grid(True, which="both", alpha=0.3)
        axes.legend(fontsize=8)
    figure.savefig(arguments.picture, dpi=110)


if __name__ == "__main__":
    main()
