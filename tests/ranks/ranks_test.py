"""Several ranks give the bits of one, in every file, and fail together. SINEW and CASE_HASHES name the programs."""
import os
import re
import signal
import subprocess
import time

from support import CASE, PROGRAM, CommandTest

HASHES = os.environ.get("CASE_HASHES", "case_hashes")
LIMIT = 120  # seconds for one run
FREE = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}  # containers
BLOCKS = ("--set", "solver.block_size=16")  # the strip has 80 particles
LONG = CASE.replace("end_time = 0.01", "end_time = 100.0").replace('every = "end_time/5"', "every = 0.05\ncheckpoint_every = 0.01")


def mpiexec(ranks, *command):
    return ["mpiexec", "--quiet", "--oversubscribe", "--bind-to", "none", "-n", str(ranks), *map(str, command)]


class Hashes(CommandTest):
    def test_every_case_on_any_number_of_ranks_and_threads(self):
        marks = {}
        for ranks, threads in ((1, 1), (1, 2), (2, 1), (2, 2), (3, 1), (4, 2), (7, 1)):
            result = subprocess.run(mpiexec(ranks, HASHES, threads), env={**os.environ, **FREE, "OMP_WAIT_POLICY": "passive"}, capture_output=True, text=True,
                                    timeout=LIMIT)
            self.assertEqual(result.returncode, 0, result.stderr)
            marks[ranks, threads] = dict(line.split(" ", 1) for line in result.stdout.splitlines())
        first = marks[1, 1]
        self.assertGreater(len(first), 10)
        print("\nhash of the state after 5 steps, then of all sums and probes; the same on ranks x threads",
              ", ".join(f"{r} x {t}" for r, t in marks))
        for case, mark in first.items():
            print(f"  {case:60s} {mark}")
            for (ranks, threads), others in marks.items():
                self.assertEqual(others[case], mark, f"{case} on {ranks} ranks with {threads} threads")


class RanksTest(CommandTest):
    def on_ranks(self, ranks, *arguments):
        """The program under mpiexec, in the scratch folder."""
        return subprocess.run(mpiexec(ranks, PROGRAM, *arguments), cwd=self.folder, env={**os.environ, **FREE, "OMP_NUM_THREADS": "1"},
                              capture_output=True, text=True, timeout=LIMIT)

    def run_on(self, ranks, folder, *arguments):
        result = self.on_ranks(ranks, "run", self.case, "-o", folder, *BLOCKS, *arguments)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        return result.stdout

    def files(self, run):
        """What a run has written, but for its log, its times and its machine."""
        run = self.folder / run
        return {str(path.relative_to(run)): path.read_bytes() for path in sorted(run.rglob("*"))
                if path.is_file() and path.name not in ("run.log", "summary.json", "checkpoint.h5")}


class Runs(RanksTest):
    def test_same_files_on_any_number_of_ranks(self):
        text = self.run_on(1, "one")
        for ranks in (2, 3, 4):
            self.run_on(ranks, "many", "--force")
            summary = self.summary("many")
            self.assertEqual(summary["ranks"], ranks)
            for key in ("state_hash", "steps", "energy", "momentum", "probes"):
                self.assertEqual(summary[key], self.summary("one")[key], key)
            self.assertEqual(self.files("many"), self.files("one"))
        self.assertEqual(text.count("completed:"), 1)

    def test_the_option_n_starts_ranks(self):
        self.succeed("run", self.case, "-o", "out", "-n", "2", "-t", "1", *BLOCKS)
        self.assertEqual((self.summary("out")["ranks"], self.summary("out")["threads"]), (2, 1))
        message = self.on_ranks(2, "run", self.case, "-n", "3").stderr
        self.assertEqual(message.count("-n asks for 3 ranks, but 2 were started"), 1, message)

    def test_more_ranks_than_blocks(self):
        self.run_on(2, "many", "--set", "solver.block_size=100")
        self.assertIn("1 of 2 ranks have nothing to do", " ".join(self.summary("many")["warnings"]))
        self.assertEqual(self.summary("many")["state_hash"], self.hash_of())

    def test_restart_with_another_number_of_ranks(self):
        self.case = self.write("held.toml", CASE.replace("end_time = 0.01", "end_time = 0.01\ndamping = 20.0"))
        self.run_on(1, "undisturbed")
        for before, after in ((3, 2), (2, 1), (1, 4)):
            self.run_on(before, "cut", "--force", "--set", "solver.max_steps=60")
            result = self.on_ranks(after, "resume", "cut", "--set", "solver.max_steps=100000")
            self.assertEqual(result.returncode, 0, result.stderr)
            for key in ("state_hash", "steps", "energy", "probes"):
                self.assertEqual(self.summary("cut")[key], self.summary("undisturbed")[key], f"{key}, {before} then {after} ranks")
            self.assertEqual((self.folder / "cut/history.csv").read_text(), (self.folder / "undisturbed/history.csv").read_text())

    def test_check_plans_what_a_run_does(self):
        plan = self.succeed("check", self.case, "--ranks", "2,3", *BLOCKS).splitlines()
        for ranks in (2, 3):
            self.run_on(ranks, "out", "--force")
            row = next(line for line in plan if line.startswith(f"    {ranks} "))
            log = (self.folder / "out/run.log").read_text()
            said = re.search(r"([\d.]+) % copies; a step sends (.* k?B) in at most (\d+) messages", log)
            self.assertIn(f" {said[2]} ", row)
            self.assertEqual(round(float(said[1])), int(re.search(r"(\d+) %  +[\d.]+ k?B", row)[1]), row)
            self.assertRegex(row, rf"B +{said[3]} ")

    def test_studies(self):
        study = CASE + '\n[study]\nvary = { "parameters.n" = [4, 5] }\n'
        self.case = self.write("study.toml", study)
        self.run_on(2, "two")
        self.run_on(1, "one")
        self.assertEqual((self.folder / "two/study.csv").read_text(), (self.folder / "one/study.csv").read_text())


    def test_solved_equations_agree_to_the_tolerance(self):
        """Not to the last bit: solvers of equations add in another order on other ranks."""
        self.case = self.write("static.toml", """[case]
dimension = 3
[[body]]
name = "block"
geometry = { shape = "box", low = [0, 0, 0], high = [1, 1, 1], spacing = 0.125 }
material = { model = "neo_hookean", density = 1, youngs_modulus = 10, poissons_ratio = 0.3 }
[[boundary]]
region = { where = "Z < 0.125" }
displacement = [0, 0, 0]
[[boundary]]
region = { where = "Z > 0.875" }
pressure = -2
normal = [0, 0, 1]
follower = true
[solver]
mode = "static"
time_step = 0.5
[[probe]]
name = "top"
quantity = "displacement"
component = "z"
reduce = "max"
""")
        for solver in ("direct", "assembled", "matrix_free"):
            found = []
            for ranks in (1, 3):
                self.run_on(ranks, "out", "--force", "--set", "solver.block_size=64", "--set", f'solver.linear_solver="{solver}"')
                found.append(self.summary("out")["probes"]["top"]["final"])
            self.assertGreater(found[0], 0.05)
            self.assertLess(abs(found[1] / found[0] - 1.0), 1e-6, solver)


class Errors(RanksTest):
    def test_a_wrong_case_is_told_once(self):
        self.write("strip.toml", CASE.replace("support = 2.4", "suport = 2.4"))
        result = self.on_ranks(3, "run", self.case)
        self.assertEqual(result.returncode, 2)
        self.assertEqual(result.stderr.count('Did you mean "support"?'), 1)
        self.assertEqual(self.on_ranks(2, "rnu").stderr.count('Did you mean "run"?'), 1)
        self.assertEqual(self.on_ranks(3, "run", self.case, "-t", "5000").stderr.count("5000 threads are not possible"), 1)
        self.assertEqual(self.on_ranks(3, "run", "--help").stdout.count("Run a case"), 1)
        self.assertIn("leave out mpiexec", self.on_ranks(2, "verify", self.case).stderr)

    def test_what_only_one_rank_sees_ends_all(self):
        """A formula that is no number on the particles of one end."""
        wrong = CASE.replace('velocity = ["0", "speed*X/0.1"]', 'velocity = ["0", "log(X - 0.01)"]')
        result = self.on_ranks(4, "run", self.write("wrong.toml", wrong), *BLOCKS)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(result.stderr.count("not a finite"), 1)
        self.assertFalse((self.folder / "runs").exists())

    def test_a_formula_that_fails_later_on_one_end_ends_all(self):
        late = CASE.replace('region = "left"\nvelocity = [0, 0]', 'region = "left"\nvelocity = ["sqrt(0.005 - t)", 0]')
        result = self.on_ranks(3, "run", self.write("late.toml", late), "-o", "late", *BLOCKS)
        self.assertEqual(result.returncode, 3, result.stdout + result.stderr)
        self.assertEqual(result.stderr.count("not a finite number"), 1, result.stderr)
        self.assertEqual(self.summary("late")["status"], "unstable")

    def test_another_block_size_cannot_go_on(self):
        self.succeed("run", self.case, "-o", "out", *BLOCKS)
        result = self.on_ranks(2, "resume", "out", "--set", "solver.block_size=32", "--set", "solver.end_time=0.02")
        self.assertEqual(result.returncode, 2)
        self.assertEqual(result.stderr.count("another [solver] block_size"), 1, result.stderr)

    def test_an_unstable_state_is_told_once(self):
        bad = CASE.replace("end_time = 0.01", "end_time = 0.01\ntime_step = 2e-4")
        message = {}
        for ranks in (1, 3):
            result = self.on_ranks(ranks, "run", self.write("bad.toml", bad), "-o", f"bad{ranks}", *BLOCKS)
            self.assertEqual(result.returncode, 3, result.stderr)
            message[ranks] = self.summary(f"bad{ranks}")["message"]
        self.assertEqual(result.stderr.count("unstable at time"), 1)
        self.assertEqual(message[1], message[3])

    def test_a_file_that_cannot_be_written_ends_all(self):
        case = self.write("long.toml", LONG)
        self.assertEqual(self.on_ranks(3, "run", case, "-o", "full", *BLOCKS, "--set", "solver.max_steps=1").returncode, 0)
        (self.folder / "full/particles/frame_000003.vtu.part").mkdir()
        result = self.on_ranks(3, "resume", "full", "--set", "solver.max_steps=100000")
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertEqual(result.stderr.count("cannot write full/particles/frame_000003.vtu: Is a directory"), 1, result.stderr)

    def start(self, *command):
        return subprocess.Popen(list(map(str, command)), cwd=self.folder, env={**os.environ, **FREE, "OMP_NUM_THREADS": "1"},
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def wait_for_checkpoint(self, run):
        for _ in range(300):
            if (self.folder / run / "checkpoint.h5").is_file():
                return
            time.sleep(0.1)
        self.fail("no checkpoint")

    def assert_same_end(self, run, ranks):
        """Resumed on so many ranks, the run ends with the bits of one that nobody disturbed."""
        last = (self.folder / run / "history.csv").read_text().splitlines()[-2]
        end = ("--set", f"solver.end_time={1.2 * float(last.split(',')[0])}")
        result = self.on_ranks(ranks, "resume", run, *end)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("resuming at", result.stdout)
        self.succeed("run", self.folder / "long.toml", "-o", "undisturbed", *BLOCKS, *end)
        self.assertEqual(self.summary(run)["state_hash"], self.summary("undisturbed")["state_hash"])
        self.assertEqual((self.folder / run / "history.csv").read_text(), (self.folder / "undisturbed/history.csv").read_text())

    def test_a_killed_rank_ends_the_job_and_the_run_goes_on_from_its_checkpoint(self):
        job = self.start(*mpiexec(3, PROGRAM, "run", self.write("long.toml", LONG), "-o", "killed", *BLOCKS))
        self.wait_for_checkpoint("killed")
        ranks = subprocess.run(["pgrep", "-P", str(job.pid)], capture_output=True, text=True, check=True).stdout.split()
        self.assertGreaterEqual(len(ranks), 3)
        start = time.monotonic()
        os.kill(int(ranks[1]), signal.SIGKILL)
        job.communicate(timeout=10)
        self.assertNotEqual(job.returncode, 0)
        print(f"\n  a killed rank ended the job in {time.monotonic() - start:.1f} s")
        self.assert_same_end("killed", 2)

    def test_a_killed_rank_is_told(self):
        job = self.start(PROGRAM, "run", self.write("long.toml", LONG), "-o", "killed", "-n", "2", *BLOCKS)
        self.wait_for_checkpoint("killed")
        launcher = subprocess.run(["pgrep", "-P", str(job.pid)], capture_output=True, text=True, check=True).stdout.split()[0]
        ranks = subprocess.run(["pgrep", "-P", launcher], capture_output=True, text=True, check=True).stdout.split()
        os.kill(int(ranks[0]), signal.SIGKILL)
        _, message = job.communicate(timeout=10)
        self.assertEqual(job.returncode, 128 + signal.SIGKILL, message)
        self.assertIn("one of the 2 ranks was ended by signal 9 (Killed)", message)

    def test_interruption_writes_a_checkpoint_on_all_ranks(self):
        job = self.start(PROGRAM, "run", self.write("long.toml", LONG), "-o", "stopped", "-n", "3", *BLOCKS)
        self.wait_for_checkpoint("stopped")
        job.send_signal(signal.SIGINT)
        _, message = job.communicate(timeout=20)
        self.assertEqual(job.returncode, 130, message)
        self.assertEqual(self.summary("stopped")["status"], "interrupted")
        self.assert_same_end("stopped", 1)
