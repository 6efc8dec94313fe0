"""What the tests of the command line share: a small case, a scratch folder, and a way to call the program."""
import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

PROGRAM = os.environ.get("SINEW", "sinew")

CASE = """
[case]
name = "strip"
dimension = 2

[parameters]
n = 4
speed = 1.0

[[body]]
name = "strip"
geometry = { shape = "box", low = [0, 0], high = [0.1, 0.02], spacing = "0.02/n" }
material = { model = "neo_hookean", density = 1000, youngs_modulus = 1e6, poissons_ratio = 0.3 }

[formulation]
kernel = "wendland_c2"
support = 2.4

[region]
left = { where = "X < 0.02/n" }
tip = { nearest = [0.1, 0.01] }

[[initial]]
region = "strip"
velocity = ["0", "speed*X/0.1"]

[[boundary]]
region = "left"
velocity = [0, 0]

[solver]
end_time = 0.01

[output]
every = "end_time/5"

[[probe]]
name = "tip"
quantity = "displacement"
region = "tip"
component = "y"
"""


class CommandTest(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="sinew_")
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)
        self.case = self.write("strip.toml", CASE)

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def call(self, *arguments, environment=None):
        """Runs the program in the scratch folder with two threads, unless told otherwise."""
        variables = {**os.environ, "OMP_NUM_THREADS": "2", **(environment or {})}
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, env=variables, capture_output=True, text=True)

    def succeed(self, *arguments):
        result = self.call(*arguments)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        return result.stdout

    def fail_with(self, code, *arguments, environment=None):
        """The message of a call that must fail; nothing of it may be on standard output."""
        result = self.call(*arguments, environment=environment)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result.stderr

    def summary(self, run):
        return json.loads((self.folder / run / "summary.json").read_text())

    def hash_of(self, *arguments):
        """The hash of the final state of a run with further arguments."""
        self.succeed("run", self.case, "-o", "hashed", "--force", *arguments)
        return self.summary("hashed")["state_hash"]
