#!/usr/bin/env python3
"""Writes the table of README.md from what `sinew verify --json FILE` wrote: make_table.py FILE.

One line a case: how many rows passed, and the row that is nearest to its tolerance. Rows on the status of a run are counted only.
"""

import json
import os
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
BEGIN, END = "<!-- table: begin -->\n", "<!-- table: end -->\n"


def difference(row):
    """Distance to the published value, and what is allowed, in the unit of the quantity."""
    if row["computed"] is None:
        return float("inf"), 1.0
    allowed = row["absolute"] if "absolute" in row else row["tolerance"] * abs(row["published"])
    return abs(row["computed"] - row["published"]), allowed


def share(row):
    distance, allowed = difference(row)
    return distance / allowed


def lines(rows):
    cases = {}
    for row in rows:
        folder = pathlib.Path(os.path.abspath(row["file"])).parent.name
        cases.setdefault((folder, row["case"]), []).append(row)
    yield "| folder | case | rows passed | nearest to its tolerance | published or exact | computed | of the tolerance |"
    yield "|---|---|---|---|---|---|---|"
    for (folder, case), found in cases.items():
        passed = sum(row["pass"] for row in found)
        numbers = [row for row in found if "published" in row and row["quantity"].split()[0] not in ("status", "end_time")]
        if not numbers:
            yield f"| {folder} | {case} | {passed} of {len(found)} | | | | |"
            continue
        worst = max(numbers, key=share)
        computed = "none" if worst["computed"] is None else f"{worst['computed']:.4g}"
        quantity = worst["quantity"].replace("probe.", "").replace("parameters.", "")
        yield (f"| {folder} | {case} | {passed} of {len(found)} | {quantity} | {worst['published']:.4g} | {computed} "
               f"| {100 * share(worst):.0f} % |")


def main():
    result = json.loads(pathlib.Path(sys.argv[1]).read_text())
    readme = HERE / "README.md"
    text = readme.read_text()
    head, tail = text.split(BEGIN)[0], text.split(END)[1]
    table = "\n".join(lines(result["rows"]))
    readme.write_text(f"{head}{BEGIN}{table}\n\n{result['passed']} rows passed, {result['failed']} failed.\n{END}{tail}")


if __name__ == "__main__":
    main()
