#!/usr/bin/env python3
"""Checks the words in all text files. Prints one line for each offense; exit code 1 if there is any.

    tools/check_words.py [ROOT]

Not wanted anywhere: paths and hosts of one machine, notes about unfinished work.
American spelling: outside of quotes ("...", `...`, raw strings), so that a test can hold a misspelled key.
"""
import os
import re
import subprocess
import sys
from pathlib import Path

TEXT = {".hpp", ".cpp", ".in", ".py", ".md", ".toml", ".txt", ".cmake", ".json", ".sh", ".yml", ""}
SKIPPED_FOLDERS = {".git", "build", "runs", "__pycache__"}
EXEMPT = {"LICENSE", "tools/check_words.py", "tests/tools/check_words_test.py"}

NOT_WANTED = [
    (re.compile(r"(?<![\w.$}~])/(home|root|work|Users|mnt|tmp)/"), "path of one machine"),
    (re.compile(r"\b(pypi\.org|files\.pythonhosted\.org|registry\.[a-z]+\.\w+|deb\.debian\.org|ghcr\.io|docker\.io|quay\.io"
                r"|proxy\.golang\.org|artifactory\b|localhost:\d+)"), "host of a package registry"),
    (re.compile(r"(?<![\w.])\d{1,3}\.\d{1,3}\.\d{1,3}\.\d{1,3}(?![\w.])"), "address of a host"),
    (re.compile(r"\b(TODO|FIXME|XXX|HACK)\b"), "note about unfinished work"),
]

# British beginning of a word -> American one.
BRITISH = {
    "colour": "color", "behaviour": "behavior", "neighbour": "neighbor", "favour": "favor",
    "stabilis": "stabiliz", "normalis": "normaliz", "initialis": "initializ", "discretis": "discretiz",
    "regularis": "regulariz", "symmetris": "symmetriz", "parametris": "parametriz", "visualis": "visualiz",
    "optimise": "optimize", "optimisa": "optimiza", "minimise": "minimize", "maximise": "maximize",
    "organise": "organize", "recognise": "recognize", "utilis": "utiliz", "summaris": "summariz",
    "centre": "center", "centring": "centering", "barycentre": "barycenter", "metre": "meter", "fibre": "fiber",
    "modell": "model", "labell": "label", "cancell": "cancel", "travell": "travel", "artefact": "artifact",
    "analyse": "analyze", "grey": "gray", "licence": "license",
}
AMERICAN_TOO = {"cancellation", "cancellations", "analyses"}
BRITISH_WORD = re.compile(r"(?<![a-z])(?:un|re|de|milli|kilo|centi|dis)?(" + "|".join(BRITISH) + r")[a-z]*", re.IGNORECASE)

QUOTED = re.compile(r'R"(\w*)\(.*?\)\1"|"""|```.*?```|"(?:\\.|[^"\\\n])*"|`[^`\n]*`', re.DOTALL)


def without_quotes(text):
    """The text with everything in quotes blanked, lines kept."""
    return QUOTED.sub(lambda match: "\n" * match.group().count("\n"), text)


def offenses(text):
    """(line number, message) for every unwanted word of one text."""
    found = []
    for number, line in enumerate(text.splitlines(), 1):
        for pattern, what in NOT_WANTED:
            for match in pattern.finditer(line):
                found.append((number, f'{what}: "{match.group()}"'))
    for number, line in enumerate(without_quotes(text).splitlines(), 1):
        for match in BRITISH_WORD.finditer(line):
            if match.group().lower() not in AMERICAN_TOO:
                beginning = match.group(1).lower()
                found.append((number, f'American spelling: "{match.group()}" -> "{BRITISH[beginning]}..."'))
    return sorted(found)


def text_files(root):
    """Files that git knows or would add; without git, all but build and run folders."""
    listing = subprocess.run(["git", "-C", str(root), "ls-files", "-co", "--exclude-standard", "-z"], capture_output=True)
    if listing.returncode == 0:
        names = listing.stdout.decode().split("\0")
    else:
        names = []
        for folder, subfolders, files in os.walk(root):
            subfolders[:] = [name for name in subfolders if name not in SKIPPED_FOLDERS]
            names += [(Path(folder) / name).relative_to(root).as_posix() for name in files]
    for name in sorted(filter(None, names)):
        path = Path(root) / name
        if name not in EXEMPT and path.suffix in TEXT and path.is_file() and not path.is_symlink():
            yield name, path


def check(root):
    """All offenses under root as printable lines."""
    return [f"{name}:{number}: {message}"
            for name, path in text_files(root)
            for number, message in offenses(path.read_text(encoding="utf-8"))]


def main():
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent
    lines = check(root)
    print("\n".join(lines) if lines else "words: nothing unwanted")
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main())
