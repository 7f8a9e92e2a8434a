"""The table that ./run bench writes (tests/bench/write_table.py), of figures made by hand."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BENCH = Path(__file__).resolve().parent / "bench"
sys.path.insert(0, str(BENCH))
import write_table  # noqa: E402

EMPTY = "# Speed\nBefore.\n\n%s\n%s\n\nBehind.\n" % (write_table.BEGIN, write_table.END)
LITERAL = {"topic": "frame", "title": "A frame", "key": "literal", "what": "drawn literally", "value": 0.9914, "unit": "",
           "at_most": 1.02, "itself": 0.998, "detail": "45.1 ms beside 45.5", "verdict": "kept"}
PICTURE = {"topic": "frame", "title": "A frame", "key": "picture", "what": "its picture", "value": 48.26, "unit": "dB",
           "at_least": 50, "detail": "", "verdict": "missed"}
WRITING = {"topic": "export", "title": "Writing", "key": "exr", "what": "EXR", "value": 1.3, "unit": "", "at_most": 1.12,
           "idle": 0.5, "detail": "", "verdict": "does not count"}
DRIVER = {"driver": "llvmpipe, OpenGL 4.5"}


def written(document, figures, today="2026-03-02"):
    return write_table.with_figures(document, figures, "2 cores (Some CPU)", today)


def rows(document):
    return [line for line in document.splitlines() if line.startswith("| <!--")]


class WithFiguresTest(unittest.TestCase):
    def test_each_figure_is_a_row_under_what_it_is_about(self):
        text = written(EMPTY, [DRIVER, LITERAL, WRITING, PICTURE])
        lines = text.splitlines()
        self.assertEqual(rows(text), [
            "| <!-- frame/literal --> drawn literally | 0.991 (45.1 ms beside 45.5) | at most 1.02 | 0.998 | kept |",
            "| <!-- frame/picture --> its picture | 48.3 dB | at least 50 |  | **missed** |",
            "| <!-- export/exr --> EXR | 1.300 | at most 1.12 | idle before: 50 % | does not count |"])
        self.assertLess(lines.index("### A frame"), lines.index(rows(text)[0]))
        self.assertLess(lines.index(rows(text)[1]), lines.index("### Writing"))
        self.assertEqual(lines.count("| what | measured | goal | yardstick to itself | verdict |"), 2)

    def test_what_was_measured_on_is_told_above(self):
        text = written(EMPTY, [DRIVER, LITERAL])
        self.assertIn("Measured on 2026-03-02 with 2 cores (Some CPU) and llvmpipe, OpenGL 4.5.\n", text)
        self.assertIn("Measured on 2026-03-02 with 2 cores (Some CPU).\n", written(EMPTY, [LITERAL]))

    def test_a_driver_that_no_bench_told_stays(self):
        text = written(written(EMPTY, [DRIVER, LITERAL]), [PICTURE], "2026-03-03")
        self.assertIn("Measured on 2026-03-03 with 2 cores (Some CPU) and llvmpipe, OpenGL 4.5.\n", text)

    def test_what_stands_around_the_table_stays(self):
        text = written(EMPTY, [LITERAL])
        self.assertTrue(text.startswith("# Speed\nBefore.\n\n" + write_table.BEGIN))
        self.assertTrue(text.endswith(write_table.END + "\n\nBehind.\n"))

    def test_writing_the_same_again_changes_nothing(self):
        once = written(EMPTY, [DRIVER, LITERAL, WRITING, PICTURE])
        self.assertEqual(written(once, [DRIVER, LITERAL, WRITING, PICTURE]), once)
        self.assertEqual(written(once, []), once)

    def test_a_row_whose_bench_did_not_run_stays_in_its_place_with_its_day(self):
        text = written(EMPTY, [LITERAL, PICTURE, WRITING])
        for day in ("2026-03-03", "2026-03-04"):
            text = written(text, [{**PICTURE, "value": 60.0, "verdict": "kept"}], day)
        self.assertEqual(rows(text), [
            "| <!-- frame/literal --> drawn literally | 0.991 (45.1 ms beside 45.5) | at most 1.02 | 0.998 | kept, 2026-03-02 |",
            "| <!-- frame/picture --> its picture | 60.0 dB | at least 50 |  | kept |",
            "| <!-- export/exr --> EXR | 1.300 | at most 1.12 | idle before: 50 % | does not count, 2026-03-02 |"])

    def test_a_row_is_known_by_its_key_and_not_by_its_words(self):
        text = written(written(EMPTY, [LITERAL]), [{**LITERAL, "what": "as it was written", "title": "One frame"}])
        self.assertEqual(rows(text), [
            "| <!-- frame/literal --> as it was written | 0.991 (45.1 ms beside 45.5) | at most 1.02 | 0.998 | kept |"])
        self.assertIn("### One frame\n", text)
        self.assertNotIn("### A frame\n", text)

    def test_numbers_have_the_digits_that_tell(self):
        told = [write_table.digits(value) for value in (0.004567, 0.0, 1.0204, -1.5, 72.34, 370.2)]
        self.assertEqual(told, ["0.0046", "0", "1.020", "-1.500", "72.3", "370"])


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

    def test_it_counts_the_verdicts_and_fails_where_a_bound_is_missed(self):
        told = {**LITERAL, "key": "told", "verdict": ""}
        done = self.write(*map(json.dumps, (DRIVER, LITERAL, PICTURE, WRITING, told)))
        self.assertEqual((done.stdout, done.returncode), ("1 kept, 1 missed, 1 do not count\n", 1))
        self.assertEqual(len(rows(self.document.read_text(encoding="utf-8"))), 4)

    def test_what_does_not_count_is_no_failure(self):
        done = self.write(*map(json.dumps, (LITERAL, WRITING)))
        self.assertEqual((done.stdout, done.returncode), ("1 kept, 0 missed, 1 do not count\n", 0))

    def test_a_broken_line_is_told_and_the_document_stays(self):
        done = self.write(json.dumps(LITERAL), '{"topic": ')
        self.assertIn("figures.jsonl:2: error:", done.stderr)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(self.document.read_text(encoding="utf-8"), EMPTY)

    def test_a_document_without_the_marks_is_told(self):
        self.document.write_text("# Speed\n", encoding="utf-8")
        done = self.write(json.dumps(LITERAL))
        self.assertIn("performance.md: error: lacks the lines", done.stderr)
        self.assertEqual(self.document.read_text(encoding="utf-8"), "# Speed\n")


if __name__ == "__main__":
    unittest.main()
