#!/usr/bin/env python3
"""Runs clang-tidy on every source under src, those of a folder together, since most of its time goes into headers.

    tools/check_tidy.py BUILD [WORKERS]

BUILD holds compile_commands.json. Where the sources of a group cannot stand in one unit (two helpers of one name), it is
halved until they can. Exit code 1 if there is anything to say, which is printed.
"""
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MEMBERS = re.compile(r"SINEW_INSTANTIATE|^template (?!<|class|struct)", re.MULTILINE)  # instantiated one by one
LARGEST = 8  # sources in a group: enough to share headers, small enough for even work


def flags_of(entry):
    """The command of an entry without its source and its output, as a tuple."""
    words = shlex.split(entry["command"])
    ends = words.index("-o")
    return tuple(words[:ends])


def groups(entries, root=ROOT, largest=LARGEST):
    """Lists of (sources, flags): of one folder under root/src, with the same flags, at most `largest` each.

    Sources that instantiate single members stand apart: after them, their class cannot be instantiated as a whole."""
    alike = {}
    for entry in entries:
        source = Path(entry["file"])
        if root / "src" in source.parents:
            members = MEMBERS.search(source.read_text()) is not None
            alike.setdefault((source.parent, flags_of(entry), members), []).append(source)
    found = []
    for (_, flags, _), sources in alike.items():
        pieces = -(-len(sources) // largest)
        found += [(sorted(sources)[piece::pieces], flags) for piece in range(pieces)]
    return sorted(found, key=lambda group: -len(group[0]))


def run(sources, flags, folder):
    """(exit code, text) of clang-tidy on one unit that includes the sources."""
    unit = Path(tempfile.mkdtemp(dir=folder)) / "unit.cpp"
    unit.write_text("".join(f'#include "{source}"\n#undef SINEW_INSTANTIATE\n' for source in sources))
    command = shlex.join([*flags, "-o", "unit.o", "-c", str(unit)])
    database = [{"directory": str(unit.parent), "file": str(unit), "command": command}]
    (unit.parent / "compile_commands.json").write_text(json.dumps(database))
    done = subprocess.run(["clang-tidy", "-p", str(unit.parent), f"--config-file={ROOT / '.clang-tidy'}", "--quiet",
                           "--checks=-bugprone-suspicious-include", "--extra-arg=-Wno-shadow", str(unit)], capture_output=True, text=True)
    return done.returncode, done.stdout


def check(group, folder):
    """What there is to say about a group; empty for nothing."""
    sources, flags = group
    code, text = run(sources, flags, folder)
    if code == 0:
        return ""
    if len(sources) == 1:
        return text or f"{sources[0]}: clang-tidy failed with code {code}\n"
    half = len(sources) // 2
    return check((sources[:half], flags), folder) + check((sources[half:], flags), folder)


def main():
    build = Path(sys.argv[1])
    workers = int(sys.argv[2]) if len(sys.argv) > 2 else os.cpu_count()
    entries = json.loads((build / "compile_commands.json").read_text())
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(workers) as pool:
        said = [text for text in pool.map(lambda group: check(group, folder), groups(entries)) if text]
    print("".join(said), end="")
    return 1 if said else 0


if __name__ == "__main__":
    sys.exit(main())
