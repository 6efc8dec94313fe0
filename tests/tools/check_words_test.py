from sample import SampleTest
import check_words


class CheckWordsTest(SampleTest):
    def messages(self, text):
        return [message for _, message in check_words.offenses(text)]

    def test_plain_text_passes(self):
        self.assertEqual(self.messages("The color of the neighbor, stabilized. Realistic organisms, analyses.\n"), [])
        self.assertEqual(self.messages("/usr/bin/python3, build/release/x, $HOME/home/, version 1.2.3\n"), [])

    def test_every_british_word_is_seen(self):
        for beginning in check_words.BRITISH:
            with self.subTest(beginning):
                self.assertEqual(len(self.messages(f"a {beginning}e b")), 1)
        self.assertEqual(self.messages("Unstabilised"), ['American spelling: "Unstabilised" -> "stabiliz..."'])

    def test_quotes_are_free(self):
        self.assertEqual(self.messages('key "stabilisation" or `neighbours`\n'), [])
        self.assertEqual(self.messages('parse(R"(\n[colour]\n)");\n'), [])
        self.assertEqual(self.messages('say("a \\"b\\" colour");\n'), [])

    def test_line_numbers_survive_raw_strings(self):
        self.assertEqual(check_words.offenses('R"(\n\n)" colour\n')[0][0], 3)

    def test_machine_paths_fail_even_in_quotes(self):
        for path in ["/home/me/x", "/root/x", "/tmp/x", "/Users/me/x"]:
            with self.subTest(path):
                self.assertIn("path of one machine", self.messages(f'open("{path}")')[0])

    def test_hosts_fail(self):
        for host in ["https://pypi" ".org/simple", "registry" ".example.com", "http://localhost:8080", "10.1.2.3"]:
            with self.subTest(host):
                self.assertEqual(len(self.messages(host)), 1)

    def test_unfinished_work_fails(self):
        self.assertEqual(len(self.messages("// TODO: later")), 1)
        self.assertEqual(len(self.messages("# FIXME")), 1)

    def test_file_and_line_are_printed(self):
        self.write("docs/a.md", "fine\nthe centre\n")
        self.write("build/b.md", "the centre\n")
        self.assertEqual(check_words.check(self.root), ['docs/a.md:2: American spelling: "centre" -> "center..."'])
