from sample import SampleTest
import check_layers


class CheckLayersTest(SampleTest):
    def check(self, file, text):
        self.write(f"src/sinew/{file}", text)
        return check_layers.check(self.root)

    def test_allowed_includes_pass(self):
        self.assertEqual(self.check("materials/a.hpp", "#include <cmath>\n#include <sinew/core/vec.hpp>\n"), [])
        self.assertEqual(self.check("materials/b.hpp", "#include <sinew/materials/a.hpp>\n"), [])
        self.assertEqual(self.check("model/case.cpp", "#include <fmt/format.h>\n#include <sinew/time/step.hpp>\n"), [])
        self.assertEqual(self.check("io/read_toml.cpp", "#include <toml++/toml.h>\n"), [])

    def test_sibling_is_named_with_line_and_rule(self):
        lines = self.check("materials/a.hpp", "#pragma once\n#include <sinew/kernels/spiky.hpp>\n")
        self.assertEqual(lines, ["src/sinew/materials/a.hpp:2: materials must not include kernels (it may include: core)"])

    def test_upward_includes_fail(self):
        self.assertIn("core must not include materials", self.check("core/a.hpp", "#include <sinew/materials/a.hpp>\n")[0])

    def test_model_and_io_do_not_meet(self):
        self.assertIn("model must not include io", self.check("model/a.cpp", "#include <sinew/io/b.hpp>\n")[0])
        self.assertIn("io must not include model", self.check("io/b.hpp", "#include <sinew/model/a.hpp>\n")[0])

    def test_particles_do_not_know_neighbors(self):
        self.assertEqual(len(self.check("particles/generate/a.hpp", "#include <sinew/neighbors/b.hpp>\n")), 1)

    def test_third_parties_stay_in_their_file(self):
        for header in ["toml++/toml.h", "hdf5.h", "cairo.h", "cairo/cairo.h", "muParser.h", "CLI/CLI.hpp", "nlohmann/json.hpp",
                       "zlib.h"]:
            with self.subTest(header):
                self.assertIn("only", self.check("formulations/a.cpp", f"  #  include <{header}>\n")[0])

    def test_text_library_is_not_for_physics(self):
        self.assertIn("only", self.check("kernels/a.hpp", "#include <fmt/format.h>\n")[0])

    def test_containers_are_not_for_physics(self):
        self.assertIn("no containers", self.check("kernels/a.hpp", "#include <vector>\n")[0])
        self.assertEqual(self.check("kernels/a.hpp", "#include <array>\n"), [])

    def test_unknown_library_folder_and_quotes_fail(self):
        self.assertIn("not in the tables", self.check("model/a.cpp", "#include <boost/any.hpp>\n")[0])
        self.assertIn("write <sinew/...>", self.check("model/a.cpp", '#include "case.hpp"\n')[0])
        self.assertIn("folder misc", "\n".join(self.check("misc/a.cpp", "")))
