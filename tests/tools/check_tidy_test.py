import shutil
import tempfile
import unittest

from sample import SampleTest
import check_tidy

FLAGS = ("c++", "-std=c++20", "-Wall")
CLEAN = "namespace {\nint helper(int a) { return a + 1; }\n}\nint use_%s(int a) { return helper(a); }\n"
FAULT = "double half_of(int a) { return a / 2; }\n"


@unittest.skipUnless(shutil.which("clang-tidy"), "there is no clang-tidy")
class CheckTidyTest(SampleTest):
    def said(self, **texts):
        for name, text in texts.items():
            self.write(f"src/sinew/core/{name}.cpp", text)
        sources = [self.root / f"src/sinew/core/{name}.cpp" for name in texts]
        with tempfile.TemporaryDirectory() as folder:
            return check_tidy.check((sources, FLAGS), folder)

    def test_clean_sources_pass(self):
        self.assertEqual(self.said(one=CLEAN % "one", two="int other();\n"), "")

    def test_fault_is_named_with_file_and_line(self):
        text = self.said(one=CLEAN % "one", two="int other();\n" + FAULT)
        self.assertIn("two.cpp:2:", text)
        self.assertIn("bugprone-integer-division", text)

    def test_sources_that_cannot_stand_together_are_parted(self):
        self.assertEqual(self.said(one=CLEAN % "one", two=CLEAN % "two"), "")
        self.assertIn("three.cpp:1:", self.said(one=CLEAN % "one", two=CLEAN % "two", three=FAULT))

    def test_groups_are_of_one_folder_and_kind(self):
        self.write("src/sinew/core/a.cpp", "int a;\n")
        self.write("src/sinew/core/b.cpp", "template void A<2>::b();\n")
        self.write("src/sinew/io/c.cpp", "template class C<2>;\n")
        self.write("tests/d.cpp", "int d;\n")
        entries = [{"file": str(self.root / f), "command": f"c++ -O3 -o x.o -c {f}"}
                   for f in ["src/sinew/core/a.cpp", "src/sinew/core/b.cpp", "src/sinew/io/c.cpp", "tests/d.cpp"]]
        names = sorted([source.name for source in sources] for sources, _ in check_tidy.groups(entries, self.root))
        self.assertEqual(names, [["a.cpp"], ["b.cpp"], ["c.cpp"]])

    def test_large_groups_are_split_evenly(self):
        for k in range(10):
            self.write(f"src/sinew/core/s{k}.cpp", "int s;\n")
        entries = [{"file": str(self.root / f"src/sinew/core/s{k}.cpp"), "command": "c++ -o x.o -c s"} for k in range(10)]
        self.assertEqual([len(sources) for sources, _ in check_tidy.groups(entries, self.root)], [5, 5])
