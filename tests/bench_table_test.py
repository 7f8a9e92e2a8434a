"""Tests the tables that ./run bench writes (tests/bench/write_table.py), with example figures."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BENCH = Path(__file__).resolve().parent / "bench"
sys.path.insert(0, str(BENCH))
import write_table  # noqa: E402

EMPTY = "# Speed\nBefore.\n\n%s\n%s\n\nAfter.\n" % (write_table.BEGIN, write_table.END)
LITERAL = {"topic": "frame", "title": "A frame", "key": "literal", "what": "drawn literally", "value": 0.9914, "unit": "",
           "at_most": 1.02, "itself": 0.998, "detail": "45.1 ms, reference 45.5 ms", "verdict": "pass"}
PICTURE = {"topic": "frame", "title": "A frame", "key": "picture", "what": "its picture", "value": 48.26, "unit": "dB",
           "at_least": 50, "detail": "", "verdict": "miss"}
WRITING = {"topic": "export", "title": "Writing", "key": "exr", "what": "EXR", "value": 1.3, "unit": "", "at_most": 1.12,
           "idle": 0.5, "detail": "", "verdict": "noise"}
DRIVER = {"driver": "llvmpipe, OpenGL 4.5"}


def written(document, figures, today="2026-03-02"):
    return write_table.with_figures(document, figures, "2 cores (Some CPU)", today)


def rows(document):
    return [line for line in document.splitlines() if line.startswith("| <!--")]


class WithFiguresTest(unittest.TestCase):
    def test_each_figure_is_a_row_of_its_topic(self):
        text = written(EMPTY, [DRIVER, LITERAL, WRITING, PICTURE])
        lines = text.splitlines()
        self.assertEqual(rows(text), [
            "| <!-- frame/literal --> drawn literally | 0.991 (45.1 ms, reference 45.5 ms) | at most 1.02 | 0.998 | pass |",
            "| <!-- frame/picture --> its picture | 48.3 dB | at least 50 |  | **miss** |",
            "| <!-- export/exr --> EXR | 1.300 | at most 1.12 | 50 % idle before | noise |"])
        self.assertLess(lines.index("### A frame"), lines.index(rows(text)[0]))
        self.assertLess(lines.index(rows(text)[1]), lines.index("### Writing"))
        self.assertEqual(lines.count("| figure | measured | goal | reference noise | verdict |"), 2)

    def test_the_machine_is_named_above_the_tables(self):
        text = written(EMPTY, [DRIVER, LITERAL])
        self.assertIn("Measured on 2026-03-02 with 2 cores (Some CPU) and llvmpipe, OpenGL 4.5.\n", text)
        self.assertIn("Measured on 2026-03-02 with 2 cores (Some CPU).\n", written(EMPTY, [LITERAL]))

    def test_the_driver_stays_if_no_bench_reports_one(self):
        text = written(written(EMPTY, [DRIVER, LITERAL]), [PICTURE], "2026-03-03")
        self.assertIn("Measured on 2026-03-03 with 2 cores (Some CPU) and llvmpipe, OpenGL 4.5.\n", text)

    def test_the_text_around_the_tables_stays(self):
        text = written(EMPTY, [LITERAL])
        self.assertTrue(text.startswith("# Speed\nBefore.\n\n" + write_table.BEGIN))
        self.assertTrue(text.endswith(write_table.END + "\n\nAfter.\n"))

    def test_writing_the_same_again_changes_nothing(self):
        once = written(EMPTY, [DRIVER, LITERAL, WRITING, PICTURE])
        self.assertEqual(written(once, [DRIVER, LITERAL, WRITING, PICTURE]), once)
        self.assertEqual(written(once, []), once)

    def test_a_row_without_a_new_figure_stays_in_place_with_its_date(self):
        text = written(EMPTY, [LITERAL, PICTURE, WRITING])
        for day in ("2026-03-03", "2026-03-04"):
            text = written(text, [{**PICTURE, "value": 60.0, "verdict": "pass"}], day)
        self.assertEqual(rows(text), [
            "| <!-- frame/literal --> drawn literally | 0.991 (45.1 ms, reference 45.5 ms) | at most 1.02 | 0.998 | pass, 2026-03-02 |",
            "| <!-- frame/picture --> its picture | 60.0 dB | at least 50 |  | pass |",
            "| <!-- export/exr --> EXR | 1.300 | at most 1.12 | 50 % idle before | noise, 2026-03-02 |"])

    def test_a_row_is_identified_by_its_key_and_not_by_its_name(self):
        text = written(written(EMPTY, [LITERAL]), [{**LITERAL, "what": "as written", "title": "One frame"}])
        self.assertEqual(rows(text), [
            "| <!-- frame/literal --> as written | 0.991 (45.1 ms, reference 45.5 ms) | at most 1.02 | 0.998 | pass |"])
        self.assertIn("### One frame\n", text)
        self.assertNotIn("### A frame\n", text)

    def test_numbers_have_enough_digits_to_compare(self):
        shown = [write_table.digits(value) for value in (0.004567, 0.0, 1.0204, -1.5, 72.34, 370.2)]
        self.assertEqual(shown, ["0.0046", "0", "1.020", "-1.500", "72.3", "370"])


class WriteTableTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.document = Path(folder.name, "performance.md")
        self.figures = Path(folder.name, "figures.jsonl")
        self.document.write_text(EMPTY, encoding="utf-8")

    def write(self, *lines):
        self.figures.write_text("".join(line + "\n" for line in lines), encoding="utf-8")
        return subprocess.run([sys.executable, BENCH / "write_table.py", self.figures, self.document],
                              capture_output=True, text=True, timeout=60, check=False)

    def test_it_counts_the_verdicts_and_fails_if_a_goal_is_missed(self):
        plain = {**LITERAL, "key": "plain", "verdict": ""}
        done = self.write(*map(json.dumps, (DRIVER, LITERAL, PICTURE, WRITING, plain)))
        self.assertEqual((done.stdout, done.returncode), ("1 pass, 1 miss, 1 noise\n", 1))
        self.assertEqual(len(rows(self.document.read_text(encoding="utf-8"))), 4)

    def test_noise_is_not_a_failure(self):
        done = self.write(*map(json.dumps, (LITERAL, WRITING)))
        self.assertEqual((done.stdout, done.returncode), ("1 pass, 0 miss, 1 noise\n", 0))

    def test_an_invalid_line_is_reported_and_the_document_stays(self):
        done = self.write(json.dumps(LITERAL), '{"topic": ')
        self.assertIn("figures.jsonl:2: error:", done.stderr)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(self.document.read_text(encoding="utf-8"), EMPTY)

    def test_a_document_without_the_marks_is_refused(self):
        self.document.write_text("# Speed\n", encoding="utf-8")
        done = self.write(json.dumps(LITERAL))
        self.assertIn("performance.md: error: the lines '<!-- figures", done.stderr)
        self.assertEqual(self.document.read_text(encoding="utf-8"), "# Speed\n")


if __name__ == "__main__":
    unittest.main()
