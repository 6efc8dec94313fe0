#!/usr/bin/env python3
"""Prints "PASSED FAILED": how many rows of a `sinew verify --json` file passed and failed.

    tools/count_rows.py FILE.json
"""
import json
import sys


def verdicts(value):
    """Every truth value stored under the key "pass", at any depth."""
    if isinstance(value, dict):
        if isinstance(value.get("pass"), bool):
            yield value["pass"]
        for inner in value.values():
            yield from verdicts(inner)
    elif isinstance(value, list):
        for inner in value:
            yield from verdicts(inner)


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as file:
        found = list(verdicts(json.load(file)))
    print(sum(found), len(found) - sum(found))
