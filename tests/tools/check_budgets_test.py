from sample import SampleTest
import check_budgets
from cpp_functions import functions

LIMITS = "[limits]\nfile_lines = 10\nfunction_lines = 4\narguments = 2\n"


class CppFunctionsTest(SampleTest):
    def names(self, text):
        return [(name, arguments) for name, _, _, arguments in functions(text)]

    def test_kinds_of_braces(self):
        text = """
            namespace sinew {
            struct alignas(64) Row : Base { double x = 0.0; int a[2] = {1, 2}; };
            template <class T, int n = (1 > 0)> struct Box<T, n> {
              explicit Box(int a, std::map<int, int> b = {}) : a_{a}, b_(b) { run(); }
              Box& operator=(Box&& other) noexcept { return *this; }
              bool operator()(int a) const { return a; }
              template <class F> requires Callable<F> auto each(F&& f) -> decltype(f(1)) { return f(1); }
            };
            constexpr std::array<int, 2> table{1, 2};
            const auto squared = [](double x) { return x * x; };
            enum class Kind { a, b };
            }  // namespace
            int main() { if (true) { loop(); } }
        """
        self.assertEqual(self.names(text), [("Box", 2), ("operator=", 1), ("operator()", 1), ("each", 1), ("main", 0)])

    def test_comments_literals_and_macros_are_no_code(self):
        self.assertEqual(self.names('// f() {\n/* g() { */\n#define H() { \\\n  }\nchar c = \'{\'; int k() { say("}"); }'), [("k", 0)])

    def test_lines(self):
        self.assertEqual(list(functions("\nint f(int a,\n      int b) {\n  g();\n}\n")), [("f", 2, 5, 2)])

    def test_arguments_of_template_types(self):
        self.assertEqual(self.names("void f(std::map<int, std::pair<int, int>> a, int (&b)[3], int c = g(1, 2)) {}"), [("f", 3)])


class CheckBudgetsTest(SampleTest):
    def check(self, file, text, exceptions=""):
        self.write("tools/budgets.toml", LIMITS + exceptions)
        self.write(file, text)
        return check_budgets.check(self.root)

    def test_short_code_passes(self):
        self.assertEqual(self.check("src/a.cpp", "int f(int a, int b) {\n  return a;\n}\n"), [])

    def test_long_file_fails(self):
        self.assertEqual(self.check("src/a.hpp", "\n" * 11), ["src/a.hpp:1: 11 lines in the file, the budget is 10"])
        self.assertEqual(len(self.check("scripts/a", "\n" * 11)), 2)

    def test_long_function_fails(self):
        body = "void f() {\n\n\n\n}\n"
        self.assertEqual(self.check("tests/a.cpp", body), ["tests/a.cpp:1: f: 5 lines in a function, the budget is 4"])

    def test_many_arguments_fail(self):
        self.assertEqual(self.check("src/a.cpp", "void f(int a, int b, int c) {}\n"),
                         ["src/a.cpp:1: f: 3 arguments, the budget is 2"])

    def test_python_is_checked(self):
        self.assertEqual(len(self.check("tools/a.py", "def f(a, b, c):\n    a\n    a\n    a\n    a\n")), 2)

    def test_exception_lifts_the_budget(self):
        entry = '[[exception]]\nfile = "src/a.cpp"\nfunction = "f"\nlimit = "arguments"\nvalue = 3\nreason = "as in the book"\n'
        self.assertEqual(self.check("src/a.cpp", "void f(int a, int b, int c) {}\n", entry), [])
        self.assertEqual(self.check("src/a.cpp", "void f(int a, int b, int c, int d) {}\n", entry),
                         ["src/a.cpp:1: f: 4 arguments, the budget is 3"])

    def test_exception_needs_a_reason_and_a_use(self):
        entry = '[[exception]]\nfile = "src/a.cpp"\nlimit = "file_lines"\nvalue = 20\n'
        lines = "\n".join(self.check("src/a.cpp", "int a;\n", entry))
        self.assertIn("gives no reason", lines)
        self.assertIn("no longer needed", lines)
