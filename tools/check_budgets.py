#!/usr/bin/env python3
"""Checks the length of files and functions and the number of arguments against tools/budgets.toml.

    tools/check_budgets.py [ROOT]

C++ is read by cpp_functions.py, which knows just enough of the language; Python by its own parser.
"""
import ast
import sys
import tomllib
from pathlib import Path

from cpp_functions import functions as cpp_functions

FOLDERS = ["src", "tests", "benchmarks", "tools", "scripts", ".ci"]
SOURCES = {".hpp", ".cpp", ".py", ""}
LIMITS = {"file_lines": "lines in the file", "function_lines": "lines in a function", "arguments": "arguments"}


def python_functions(text):
    """(name, first line, last line, number of arguments) of every function of a Python source."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            count = len(node.args.posonlyargs + node.args.args + node.args.kwonlyargs)
            yield node.name, node.lineno, node.end_lineno, count


def measures(path):
    """(limit, function or "", line, value) of everything that has a budget in one file."""
    text = path.read_text(encoding="utf-8")
    yield "file_lines", "", 1, len(text.splitlines())
    if path.suffix == ".py":
        found = python_functions(text)
    elif path.suffix in {".hpp", ".cpp"}:
        found = cpp_functions(text)
    else:
        return
    for name, first, last, arguments in found:
        yield "function_lines", name, first, last - first + 1
        yield "arguments", name, first, arguments


def read_exceptions(entries):
    """(file, function, limit) -> value; and what is wrong with the entries."""
    table, wrong = {}, []
    for entry in entries:
        name = entry.get("file", "?")
        if not entry.get("reason", "").strip():
            wrong.append(f"tools/budgets.toml: the exception for {name} gives no reason")
        if entry.get("limit") not in LIMITS or not isinstance(entry.get("value"), int):
            wrong.append(f"tools/budgets.toml: the exception for {name} needs a limit ({', '.join(LIMITS)}) and a value")
            continue
        table[name, entry.get("function", ""), entry["limit"]] = entry["value"]
    return table, wrong


def source_files(root):
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.is_file() and path.suffix in SOURCES and "__pycache__" not in path.parts:
                yield path


def check(root):
    """All offenses under root as printable lines."""
    root = Path(root)
    budgets = tomllib.loads((root / "tools" / "budgets.toml").read_text(encoding="utf-8"))
    exceptions, lines = read_exceptions(budgets.get("exception", []))
    needed = set()
    for path in source_files(root):
        name = path.relative_to(root).as_posix()
        for limit, function, line, value in measures(path):
            budget = budgets["limits"][limit]
            key = (name, function, limit)
            if value > budget and key in exceptions:
                needed.add(key)
                budget = exceptions[key]
            if value > budget:
                owner = f"{function}: " if function else ""
                lines.append(f"{name}:{line}: {owner}{value} {LIMITS[limit]}, the budget is {budget}")
    for key in exceptions.keys() - needed:
        lines.append(f"tools/budgets.toml: the exception for {' '.join(filter(None, key))} is no longer needed")
    return sorted(lines)


def main():
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent
    lines = check(root)
    print("\n".join(lines) if lines else "budgets: every file and function is short enough")
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main())
