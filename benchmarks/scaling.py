#!/usr/bin/env python3
"""Strong and weak scaling over ranks and threads on this machine, as tables.

    benchmarks/scaling.py [--runs 1x1,1x2,2x1] [--size 64] [--repeats 5] [--lattice]

"2x1" is 2 ranks with 1 thread each. All runs take turns, `--repeats` times; medians are printed. Efficiency: speed over that of the first run times the cores used more than there.
"""
import argparse
import json
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def run(folder, ranks, threads, size, length, jitter):
    command = [str(ROOT / "sinew"), "run", str(ROOT / "benchmarks/scaling.toml"), "-o", str(folder), "--force", "--quiet", "-n", str(ranks),
               "-t", str(threads), "--set", f"parameters.n={size}", "--set", f"parameters.length={length}",
               "--set", f"parameters.jitter={jitter}"]
    result = subprocess.run(command, capture_output=True, text=True)
    if result.returncode != 0:
        sys.exit(result.stderr)
    return json.loads((folder / "summary.json").read_text())


def table(title, shapes, options, lengths):
    with tempfile.TemporaryDirectory() as holder:
        speeds, last = {shape: [] for shape in shapes}, {}
        for _ in range(options.repeats):
            for shape in shapes:
                ranks, threads = shape
                last[shape] = run(Path(holder) / "run", ranks, threads, options.size, lengths[shape], 0 if options.lattice else 0.2)
                speeds[shape].append(last[shape]["particle_steps_per_second"])
    print(f"\n{title}\n")
    print("| ranks x threads | particles a rank | copies | bytes a step | million particle-steps/s | over the first | efficiency | hash |")
    print("|---|---|---|---|---|---|---|---|")
    first = statistics.median(speeds[shapes[0]])
    for shape in shapes:
        summary, speed = last[shape], statistics.median(speeds[shape])
        exchange = summary["exchange"]
        cores = shape[0] * shape[1] / (shapes[0][0] * shapes[0][1])
        print(f"| {shape[0]} x {shape[1]} | {summary['particles'] // shape[0]} | {100 * exchange['copies_share']:.1f} % "
              f"| {exchange['bytes_per_step']:.3g} | {1e-6 * speed:.2f} | {speed / first:.3f} | {100 * speed / (first * cores):.0f} % "
              f"| {summary['state_hash']} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", default="1x1,1x2,2x1", help="ranks x threads, ...")
    parser.add_argument("--size", type=int, default=64, help="edge of the block in particles")
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--lattice", action="store_true", help="regular particles instead of disturbed ones")
    options = parser.parse_args()
    shapes = [tuple(map(int, shape.split("x"))) for shape in options.runs.split(",")]
    table(f"Strong scaling: {options.size}^3 particles", shapes, options, {shape: 1 for shape in shapes})
    table(f"Weak scaling: {options.size}^3 particles a core", shapes, options, {(r, t): r * t for r, t in shapes})


if __name__ == "__main__":
    main()
