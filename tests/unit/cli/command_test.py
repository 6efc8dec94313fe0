"""The program as a user meets it. SINEW names the program to test."""
import csv
import json
import signal
import subprocess
import time

from support import CASE, PROGRAM, CommandTest

LONG = CASE.replace("end_time = 0.01", "end_time = 100.0").replace('every = "end_time/5"', "every = 0.01\nhistory_every = 0.001")
BLOW_UP = CASE.replace("end_time = 0.01", "end_time = 0.01\ntime_step = 2e-4")
EXPECT = """
[[expect]]
quantity = "probe.tip.max"
value = {value}
tolerance = {tolerance}
"""


class Runs(CommandTest):
    def test_writes_a_complete_folder(self):
        text = self.succeed("run", self.case, "--picture", "strip.png")
        run = self.folder / "runs/strip"
        for name in ("case.resolved.toml", "run.log", "summary.json", "history.csv", "particles.pvd", "checkpoint.h5"):
            self.assertTrue((run / name).is_file(), name)
        self.assertTrue((self.folder / "strip.png").is_file())
        summary = self.summary("runs/strip")
        self.assertEqual(summary["status"], "completed")
        self.assertAlmostEqual(summary["end_time"], 0.01, delta=1e-15)
        self.assertEqual(summary["particles"], 80)
        self.assertLess(abs(summary["energy"]["drift"]), 0.2)
        self.assertIn("80 particles", text)
        self.assertIn("energy", text)
        frames = (run / "particles.pvd").read_text().count("<DataSet")
        self.assertEqual(frames, len(list((run / "particles").iterdir())))
        self.assertEqual(frames, 6)

    def test_the_picture_may_go_into_the_run_folder(self):
        self.succeed("run", self.case, "-o", "new/run", "--picture", "new/run/last.png")
        self.assertTrue((self.folder / "new/run/last.png").is_file())
        message = self.fail_with(2, "run", self.case, "-o", "other", "--picture", "nowhere/last.png")
        self.assertIn("--picture: there is no folder", message)
        self.assertFalse((self.folder / "other").exists())

    def test_max_steps_alone_ends_a_run(self):
        text = CASE.replace("end_time = 0.01", "max_steps = 7").replace('every = "end_time/5"', "every = 0")
        self.succeed("run", self.write("steps.toml", text), "-o", "steps")
        self.assertEqual(self.summary("steps")["steps"], 7)

    def test_probe_extremes_are_those_of_the_history(self):
        self.succeed("run", self.case, "-o", "out")
        with open(self.folder / "out/history.csv", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        values = [float(row["tip [m]"]) for row in rows]
        probe = self.summary("out")["probes"]["tip"]
        self.assertEqual(len(rows), self.summary("out")["steps"] + 1)
        self.assertEqual([probe["final"], probe["min"], probe["max"]], [values[-1], min(values), max(values)])

    def test_same_bits_whatever_is_written_and_on_any_number_of_threads(self):
        hashes = {self.hash_of("-t", threads) for threads in (1, 2, 3)}
        hashes.add(self.hash_of("--set", "output.every=0.0003", "--set", "output.history_every=0.0001",
                                "--set", "output.checkpoint_every=0.001"))
        self.assertEqual(len(hashes), 1)

    def test_resolved_case_gives_the_same_bits(self):
        first = self.hash_of()
        (self.folder / "again.toml").write_text((self.folder / "hashed/case.resolved.toml").read_text())
        self.case = self.folder / "again.toml"
        self.assertEqual(self.hash_of(), first)

    def test_set_replaces_a_value(self):
        self.succeed("run", self.case, "-o", "out", "--set", "parameters.n=6", "--set", "formulation.kernel=spiky")
        self.assertEqual(self.summary("out")["particles"], 180)
        self.assertIn("spiky", (self.folder / "out/case.resolved.toml").read_text())

    def test_max_steps_ends_a_run(self):
        self.succeed("run", self.case, "-o", "out", "--set", "solver.max_steps=7")
        self.assertEqual(self.summary("out")["steps"], 7)

    def test_quiet_prints_nothing(self):
        self.assertEqual(self.succeed("run", self.case, "--quiet"), "")

    def test_blow_up_says_when_and_which_particle_and_keeps_what_there_is(self):
        message = self.fail_with(3, "run", self.write("bad.toml", BLOW_UP), "-o", "bad")
        for word in ("time", "particle", "cfl", "bad"):
            self.assertIn(word, message)
        self.assertEqual(self.summary("bad")["status"], "unstable")
        self.assertGreater(len((self.folder / "bad/history.csv").read_text().splitlines()), 2)
        self.assertGreaterEqual((self.folder / "bad/particles.pvd").read_text().count("<DataSet"), 2)


class Errors(CommandTest):
    def test_unknown_key_names_place_and_nearest(self):
        self.write("strip.toml", CASE.replace("support = 2.4", "suport = 2.4"))
        message = self.fail_with(2, "run", self.case)
        self.assertRegex(message, r"strip\.toml:\d+:\d+: ")
        self.assertIn('Did you mean "support"?', message)
        self.assertFalse((self.folder / "runs").exists(), "nothing half-made is left behind")

    def test_a_case_that_cannot_be_built_leaves_nothing_behind(self):
        self.fail_with(2, "run", self.case, "--set", 'region.left.where="X < -1"')
        self.assertFalse((self.folder / "runs").exists())

    def test_missing_file(self):
        self.assertIn("nowhere.toml", self.fail_with(2, "run", "nowhere.toml"))

    def test_folder_in_use_and_force(self):
        self.succeed("run", self.case, "-o", "out")
        self.assertIn("--force", self.fail_with(2, "run", self.case, "-o", "out"))
        self.succeed("run", self.case, "-o", "out", "--force")
        self.write("other/notes.txt", "mine")
        self.fail_with(2, "run", self.case, "-o", "other", "--force")
        self.assertTrue((self.folder / "other/notes.txt").is_file())

    def test_folder_below_a_file(self):
        self.write("plain", "")
        self.assertIn("plain", self.fail_with(2, "run", self.case, "-o", "plain/out"))

    def test_bad_overrides(self):
        self.assertIn("key.path=value", self.fail_with(2, "run", self.case, "--set", "parameters.n"))
        self.assertIn("unknown parameter", self.fail_with(2, "run", self.case, "--set", "parameters.m=3"))

    def test_impossible_number_of_threads(self):
        self.assertIn("threads", self.fail_with(2, "run", self.case, "-t", "-1"))

    def test_unknown_command_and_option(self):
        self.assertIn('Did you mean "run"?', self.fail_with(2, "rnu", self.case))
        self.assertIn('Did you mean "--force"?', self.fail_with(2, "run", self.case, "--forse"))
        self.assertIn('Did you mean "--version"?', self.fail_with(2, "--verson"))
        self.assertIn("Known tiers: quick, full.", self.fail_with(2, "verify", self.case, "--tier", "fast"))
        self.fail_with(2, "run")
        self.fail_with(2)

    def test_resume_without_a_run(self):
        self.assertIn("no run folder", self.fail_with(2, "resume", "nowhere"))


class Interruptions(CommandTest):
    def interrupted_run(self):
        """A long run that gets Ctrl-C as soon as it has written two frames."""
        self.write("long.toml", LONG)
        with subprocess.Popen([PROGRAM, "run", "long.toml", "-o", "out", "-t", "1"], cwd=self.folder, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True) as process:
            second_frame = self.folder / "out/particles/frame_000001.vtu"
            deadline = time.monotonic() + 60
            while not second_frame.exists() and time.monotonic() < deadline:
                time.sleep(0.005)
            process.send_signal(signal.SIGINT)
            _, message = process.communicate(timeout=60)
        return process.returncode, message

    def test_interrupt_then_resume_gives_the_bits_of_an_undisturbed_run(self):
        code, message = self.interrupted_run()
        self.assertEqual(code, 130, message)
        self.assertIn("sinew resume out", message)
        stopped = self.summary("out")
        self.assertEqual(stopped["status"], "interrupted")
        end = stopped["end_time"] + 0.02
        self.succeed("resume", "out", "--set", f"solver.end_time={end!r}")
        self.succeed("run", "long.toml", "-o", "whole", "--set", f"solver.end_time={end!r}")
        resumed, whole = self.summary("out"), self.summary("whole")
        self.assertEqual(resumed["status"], "completed")
        self.assertEqual(resumed["steps"], whole["steps"])
        self.assertEqual(resumed["state_hash"], whole["state_hash"])
        self.assertEqual(resumed["probes"], whole["probes"])
        self.assertEqual((self.folder / "out/history.csv").read_text(), (self.folder / "whole/history.csv").read_text())
        self.assertEqual((self.folder / "out/particles.pvd").read_text(), (self.folder / "whole/particles.pvd").read_text())

    def test_resume_of_a_finished_run_says_so_and_can_go_further(self):
        self.succeed("run", self.case, "-o", "out")
        self.assertIn("end_time", self.succeed("resume", "out"))
        self.succeed("resume", "out", "--set", "solver.end_time=0.012")
        self.assertAlmostEqual(self.summary("out")["end_time"], 0.012, delta=1e-15)


class Studies(CommandTest):
    STUDY = CASE + '\n[study]\nvary = { "parameters.speed" = [0.5, 1, 2] }\n' + """
[[expect]]
quantity = "probe.tip.rate"
value = -1.0
absolute = 0.1
[[expect]]
quantity = "probe.tip.final"
with = { "parameters.speed" = 2 }
value = 100.0
tolerance = 0.1
"""

    def test_all_runs_and_the_rate(self):
        text = self.succeed("run", self.write("study.toml", self.STUDY), "-o", "out")
        self.assertIn("run 2 of 3", text)
        with open(self.folder / "out/study.csv", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([float(row["parameters.speed"]) for row in rows], [0.5, 1.0, 2.0])
        for row in rows:
            final = self.summary(f"out/{row['folder']}")["probes"]["tip"]["final"]
            self.assertEqual(float(row["tip"]), final)
        rate, final = self.summary("out")["expect"]
        self.assertTrue(rate["pass"], rate)
        self.assertFalse(final["pass"])
        self.assertIn("speed = 2", final["quantity"])

    def test_a_run_that_fails_does_not_stop_the_others(self):
        self.write("study.toml", BLOW_UP + '\n[study]\nvary = { "solver.time_step" = [2e-4, 2e-5] }\n')
        self.fail_with(3, "run", "study.toml", "-o", "out")
        with open(self.folder / "out/study.csv", encoding="utf-8") as file:
            self.assertEqual([row["status"] for row in csv.DictReader(file)], ["unstable", "completed"])
        self.assertEqual(self.summary("out")["status"], "unstable")


class Verifications(CommandTest):
    def test_rows_pass_miss_and_are_skipped(self):
        self.succeed("run", self.case, "-o", "out")
        value = self.summary("out")["probes"]["tip"]["max"]
        good = CASE.replace('"strip"\ndim', '"good"\ndim') + EXPECT.format(value=repr(value), tolerance=1e-9)
        full = EXPECT.format(value=1.0, tolerance=0.1) + 'tier = "full"\n'
        self.write("cases/good/case.toml", good + full)
        self.write("cases/good/reference.toml", "[reference]\ndoi = 1\n")
        self.write("cases/plain.toml", CASE)
        text = self.succeed("verify", "cases", "--json", "rows.json")
        self.assertIn("1 rows passed, 0 failed, 1 skipped", text.splitlines()[-1])
        rows = json.loads((self.folder / "rows.json").read_text())["rows"]
        self.assertEqual([(row["case"], row["pass"]) for row in rows], [("good", True)])
        full_tier = self.call("verify", "cases", "--tier", "full", "-j", "2")
        self.assertEqual(full_tier.returncode, 1)
        self.assertIn("1 rows passed, 1 failed, 0 skipped", full_tier.stdout.splitlines()[-1])

    def test_a_case_that_is_wrong_fails(self):
        self.write("cases/wrong.toml", CASE.replace("support", "suport") + EXPECT.format(value=1.0, tolerance=1.0))
        result = self.call("verify", "cases")
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn('Did you mean "support"?', result.stdout)

    def test_a_run_that_must_fail_can_be_asserted(self):
        self.write("cases/bad.toml", BLOW_UP + '\n[[expect]]\nquantity = "status"\nvalue = 0\nabsolute = 0.5\n')
        self.assertIn("1 rows passed", self.succeed("verify", "cases"))

    def test_nothing_to_verify(self):
        self.assertIn("no case", self.fail_with(2, "verify", self.case))
        self.assertIn("no file or folder", self.fail_with(2, "verify", "nowhere"))


class Commands(CommandTest):
    def test_check_builds_without_running(self):
        text = self.succeed("check", self.case)
        for word in ("80 particles", "neighbors", "time step", "memory", "estimated run time", "mass"):
            self.assertIn(word, text)
        self.assertFalse((self.folder / "runs").exists())

    def test_list_and_describe(self):
        self.assertIn("neo_hookean", self.succeed("list", "materials"))
        self.assertIn("hourglass_stiffness", self.succeed("list"))
        self.assertIn('Did you mean "kernels"?', self.fail_with(2, "list", "kernel"))
        text = self.succeed("describe", "neo_hookean")
        for word in ("density", "kg/m^3", "greater than 0", "must be given"):
            self.assertIn(word, text)
        self.assertIn("end_time", self.succeed("describe", "solver"))
        self.assertIn('Did you mean "neo_hookean"?', self.fail_with(2, "describe", "neohookean"))

    def test_reference_pages(self):
        self.succeed("describe", "--all", "-o", "pages")
        self.assertIn("`cfl`", (self.folder / "pages/sections.md").read_text())
        self.assertIn("## `wendland_c2`", (self.folder / "pages/kernels.md").read_text())

    def test_new_cases_run(self):
        for name in ("beam", "pull", "block3d"):
            self.succeed("new", name)
            self.assertIn("is there already", self.fail_with(2, "new", name))
            self.succeed("check", f"{name}.toml")
        self.succeed("run", "beam.toml", "--set", "solver.max_steps=20")
        self.assertIn("Known templates: beam", self.fail_with(2, "new", "xyz"))

    def test_version(self):
        text = self.succeed("--version")
        for word in ("sinew", "commit", "compiler", "MPI", "PETSc", "HDF5", "vector ISA"):
            self.assertIn(word, text)
