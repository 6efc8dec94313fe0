"""The documentation says what the program does. SINEW: the program."""
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SINEW = os.environ["SINEW"]
PAGES = sorted(ROOT.glob("*.md")) + sorted((ROOT / "docs").rglob("*.md")) + sorted((ROOT / "benchmarks").glob("*.md"))


def text_of(name):
    return (ROOT / name).read_text(encoding="utf-8")


def blocks(text, language):
    return re.findall(rf"```{language}\n(.*?)```", text, re.DOTALL)


def sinew(*arguments):
    return subprocess.run([SINEW, *arguments], capture_output=True, text=True, check=False)


class DocsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def assert_valid_case(self, text):
        case = self.folder / "case.toml"
        case.write_text(text, encoding="utf-8")
        check = sinew("check", str(case), "-t", "1")
        self.assertEqual(check.returncode, 0, check.stdout + check.stderr)

    def test_reference_is_what_the_program_writes(self):
        written = sinew("describe", "--all", "-o", str(self.folder))
        self.assertEqual(written.returncode, 0, written.stderr)
        pages = {page.name for page in self.folder.glob("*.md")}
        self.assertEqual(pages, {page.name for page in (ROOT / "docs/reference").glob("*.md")} - {"README.md"})
        for page in sorted(pages):
            with self.subTest(page):
                self.assertEqual((self.folder / page).read_text(encoding="utf-8"), text_of(f"docs/reference/{page}"),
                                 "run: ./sinew describe --all -o docs/reference")

    def test_case_of_the_readme(self):
        (case,) = blocks(text_of("README.md"), "toml")
        self.assert_valid_case(case)

    def test_case_file_page_is_one_valid_case(self):
        self.assert_valid_case("\n".join(blocks(text_of("docs/guide/case_file.md"), "toml")))

    def test_case_file_page_has_every_name(self):
        page = text_of("docs/guide/case_file.md")
        names = []
        for kind in ("sections", "geometries", "stabilizations", "materials"):
            names += re.findall(r"^\| `(\w+)` \|", text_of(f"docs/reference/{kind}.md"), re.MULTILINE)
        for kind in ("materials", "kernels", "corrections", "geometries", "fields", "totals"):
            names += re.findall(r"^## `([\w.]+)`$", text_of(f"docs/reference/{kind}.md"), re.MULTILINE)
        self.assertGreater(len(names), 100)
        for name in sorted(set(names)):
            with self.subTest(name):
                self.assertRegex(page, rf"(?<![\w.]){re.escape(name)}(?!\w)")

    def test_commands_of_the_readme_exist(self):
        for verb in sorted(set(re.findall(r"\./sinew (\w+)", text_of("README.md")))):
            with self.subTest(verb):
                self.assertEqual(sinew(verb, "--help").returncode, 0)

    def test_links_lead_somewhere(self):
        for page in PAGES:
            for target in re.findall(r"\]\(([^)#\s]+)[^)]*\)", page.read_text(encoding="utf-8")):
                if "://" not in target:
                    with self.subTest(f"{page.relative_to(ROOT)}: {target}"):
                        self.assertTrue((page.parent / target).exists())


if __name__ == "__main__":
    unittest.main()
