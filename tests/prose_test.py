"""Checks the rules of prose.py on this tree, and on small trees that break one rule each."""

import tempfile
import unittest
from pathlib import Path

import prose


def errors_in(files):
    """What check_tree reports for a tree with these files: {path: text}."""
    with tempfile.TemporaryDirectory() as root:
        for path, text in files.items():
            file = Path(root, path)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
        return prose.check_tree(root)[0]


class ProseTest(unittest.TestCase):
    def assert_error(self, path, text, expected):
        errors = errors_in({path: text})
        self.assertEqual(len(errors), 1, errors)
        self.assertIn(expected, errors[0])

    def assert_none(self, path, text):
        self.assertEqual(errors_in({path: text}), [])

    def test_this_tree_keeps_the_rules(self):
        errors, warnings = prose.check_tree(Path(__file__).resolve().parent.parent)
        print("\n".join(warnings))
        self.assertEqual(errors, [])

    def test_every_exception_is_used_and_has_a_reason(self):
        root = Path(__file__).resolve().parent.parent
        for file, part, reason in prose.EXCEPTIONS:
            self.assertIn(part, (root / file).read_text(encoding="utf-8"))
            self.assertTrue(reason)

    def test_each_phrase_is_refused_in_code(self):
        for text in (
            "'a.png' is no PNG",
            "there are files that are no pictures",
            "the history starts anew",
            "Nobody is listening",
            "somebody else writes to it",
            "there is such a file",
            "as many as a vector has",
            "so many of the files",
            "a copy in the place of the file",
        ):
            self.assert_error("app/ui/a.cpp", f'say("{text}");\n', "app/ui/a.cpp:1: error")

    def test_usual_english_is_taken(self):
        for text in (
            "There is no preset",
            "the file is no longer there",
            "there are no more devices",
            "It is not a PNG",
        ):
            self.assert_none("app/ui/a.cpp", f'say("{text}");\n')

    def test_a_text_may_be_broken_over_lines(self):
        self.assert_error("app/ui/a.cpp", 'say("What follows is "\n    "no text");\n', "a.cpp:1: error")

    def test_two_texts_of_one_line_are_two(self):
        self.assert_none("app/ui/a.cpp", 'say("it is", "no text");\n')

    def test_comments_and_includes_of_code_are_not_texts(self):
        self.assert_none("app/ui/a.cpp", '// "it is no text"\n#include "so many.h"\n')

    def test_texts_of_annotations_are_read(self):
        self.assert_error(
            "shaders/a/b.frag",
            'uniform float a; // is no text @label "A" @help "This is no text."\n',
            "b.frag:1: error: 'is no' reads like a translation: This is no text.",
        )

    def test_names_in_json_are_read(self):
        self.assert_error("shaders/a/look.json", '{\n"about": "made anew"\n}\n', "look.json:2: error")
        self.assert_error("presets/a/b.json", '{\n"about": "made anew"\n}\n', "b.json:2: error")

    def test_the_script_is_read_without_its_comments(self):
        self.assert_error("run", "# anew\necho made anew\n", "run:2: error")

    def test_a_sentence_of_a_page_has_an_end(self):
        self.assert_none("docs/a.md", "word\n" * 35)
        self.assert_error("docs/a.md", "word\n" * 36, "a.md:1: error: a sentence of 36 words")
        self.assert_none("docs/a.md", "word\n" * 20 + "end. " + "Word\n" * 20)

    def test_long_sentences_are_warned_of(self):
        errors, warnings = prose.page_problems("docs/a.md", "word " * 26 + "\n")
        self.assertEqual(errors, [])
        self.assertEqual(len(warnings), 1)
        self.assertEqual(prose.page_problems("docs/a.md", "word " * 25 + "\n"), ([], []))

    def test_list_items_are_sentences_of_their_own(self):
        self.assert_none("docs/a.md", "- " + "word " * 20 + "\n- " + "word " * 20 + "\n")

    def test_code_is_not_prose(self):
        self.assert_none("docs/a.md", "```sh\n" + "word " * 40 + "made anew\n```\n")
        self.assert_none("docs/a.md", "the key `made anew` and `" + "word " * 20 + "`\n")

    def test_lines_of_a_page_are_short_outside_tables(self):
        self.assert_error("docs/a.md", "x" * 161 + "\n", "a line of 161 characters")
        self.assert_none("docs/a.md", "| " + "x" * 170 + " |\n")

    def test_a_cell_holds_two_sentences(self):
        self.assert_none("docs/a.md", "| a | One fact. Another fact. |\n")
        self.assert_error("docs/a.md", "| a | One. Two. Three. |\n", "a table cell of 3 sentences")

    def test_a_bar_in_code_does_not_end_a_cell(self):
        self.assert_error("docs/a.md", "| `a|b` One. Two. Three. |\n", "a table cell of 3 sentences")

    def test_links_lead_somewhere(self):
        pages = {"docs/a.md": "[b](b.md#the-two-looks) [own](#here)\n\n# Here\n", "docs/b.md": "## The `two` looks\n"}
        self.assertEqual(errors_in(pages), [])
        self.assert_error("docs/a.md", "[b](b.md)\n", "a.md:1: error: the link 'b.md' leads nowhere")
        self.assert_error("docs/a.md", "[b](#b)\n", "a.md:1: error: the link '#b' leads nowhere")
        self.assert_none("docs/a.md", "[b](https://example.org/b.md)\n")

    def test_tests_that_a_page_names_exist(self):
        test = {"tests/cli/a_test.py": "class A:\n    def test_it_works(self):\n        pass\n"}
        self.assertEqual(errors_in({**test, "docs/a.md": "`test_it_works`\n"}), [])
        self.assertEqual(errors_in({**test, "docs/a.md": "one\n`test_it_failed`\n"}),
                         ["docs/a.md:2: error: there is no test 'test_it_failed'"])

    def test_every_page_at_the_top_level_is_read(self):
        self.assert_error("CONTRIBUTING.md", "word\n" * 36, "CONTRIBUTING.md:1: error: a sentence of 36 words")
        self.assert_error("SECURITY.md", "[b](docs/b.md)\n", "SECURITY.md:1: error: the link 'docs/b.md' leads nowhere")

    def test_the_readme_is_short(self):
        self.assert_none("README.md", "line\n\n" * 40)
        self.assert_error("README.md", "line\n\n" * 40 + "end\n", "more than 80 lines")


if __name__ == "__main__":
    unittest.main()
