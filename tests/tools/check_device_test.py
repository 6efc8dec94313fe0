from sample import SampleTest
import check_device


class CheckDeviceTest(SampleTest):
    def compiler(self, script):
        self.write("cuda/bin/nvcc", f"#!/bin/sh\n{script}\n")
        path = self.root / "cuda/bin/nvcc"
        path.chmod(0o755)
        return str(path)

    def test_without_a_compiler_it_is_skipped(self):
        self.assertEqual(check_device.check(self.root, None), (0, "device: skipped, since there is no nvcc"))

    def test_compiler_is_found_on_the_path_and_in_its_home(self):
        nvcc = self.compiler("exit 0")
        self.assertEqual(check_device.find_nvcc({"PATH": str(self.root / "cuda/bin")}), nvcc)
        self.assertEqual(check_device.find_nvcc({"CUDA_HOME": str(self.root / "cuda")}), nvcc)

    def test_success_passes(self):
        code, text = check_device.check(self.root, self.compiler("exit 0"))
        self.assertEqual(code, 0)
        self.assertIn("compiles with", text)

    def test_source_that_does_not_compile_fails(self):
        code, text = check_device.check(self.root, self.compiler("echo point_physics.cu: error >&2; exit 2"))
        self.assertEqual(code, 1)
        self.assertIn("point_physics.cu: error", text)
        self.assertIn("does not compile", text)
