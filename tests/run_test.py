"""Runs ./run in a copy of its files, with substitutes for apt, sudo, CMake, Ninja and CTest."""

import json
import os
import pty
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parent.parent
TOOLS = "bash env dirname readlink awk sed grep tr wc tail tee paste fold nproc cat mkdir chmod python3 id basename mv rm".split()

# The packages of the simulated system are files in $BOX/installed. Calls are logged in $BOX/log.
STAND_INS = {
    "dpkg-query": '[ -e "$BOX/installed/${!#}" ] && echo installed',
    "apt-cache": """
        [ -e "$BOX/known" ] || exit 100
        for name in "${@:3}"; do echo "Package: $name"; echo "Installed-Size: 1000"; done
    """,
    "apt-get": """
        case "$*" in
            *--print-uris*) echo "'x' a.deb 2000000 SHA"; echo "'y' b.deb 1000000 SHA" ;;
            *' -s '*) echo 'Inst one (1)'; echo 'Inst two (1)' ;;
            update*) echo "apt-get $*" >> "$BOX/log"; touch "$BOX/known" ;;
            *) echo "apt-get $*" >> "$BOX/log"; cd "$BOX/installed"; touch_all "$@" ;;
        esac""",
    "touch_all": 'for name in "$@"; do : > "$name"; done 2>/dev/null; exit 0',
    "touch": ': > "$1"',
    "npm": """
        echo "npm $1 $2" >> "$BOX/log"
        [ ! -e "$BOX/npm_fails" ] && : > "$4/interactive-shader-format-2.9.0.tgz" """,
    "sha512sum": 'read -r sum file; [ -e "$file" ] && [ ! -e "$BOX/sum_differs" ]',
    "tar": ': > "$4/package.json"',
    "sudo": 'echo sudo >> "$BOX/log"; exec "$@"',
    "cmake": """
        echo "cmake $*" >> "$BOX/log"
        [ -e "$BOX/cmake_fails" ] && exit 1
        case "$1" in
            --preset) mkdir -p "build/$2"; : > "build/$2/build.ninja" ;;
            --build)
                [ -e "$BOX/build_fails" ] && exit 1
                mkdir -p "$2/app"; cp_program "$2/app/afterglow" ;;
        esac""",
    "cp_program": """
        printf '%s\\n' '#!/bin/bash' 'echo "in $PWD"' '[ $# = 0 ] || printf "<%s>\\n" "$@"' 'exit 7' > "$1"
        chmod +x "$1" """,
    "ninja": '[ -x "$2/app/afterglow" ] && echo "ninja: no work to do."',
    "ctest": 'echo "golden=${AFTERGLOW_UPDATE_GOLDEN:-} ctest $*" >> "$BOX/log"; cat "$BOX/ctest_output"; [ ! -e "$BOX/tests_fail" ]',
}


class RunTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.box = Path(folder.name).resolve()
        for name in ("bin", "installed", "a person's folder", "tree/third_party"):
            (self.box / name).mkdir(parents=True)
        for name in ("run", "third_party/install_packages", "third_party/install_isf_reader",
                     "third_party/packages.txt"):
            shutil.copy(SOURCE / name, self.box / "tree" / name)
        for tool in TOOLS:
            (self.box / "bin" / tool).symlink_to(shutil.which(tool))
        for name, script in STAND_INS.items():
            file = self.box / "bin" / name
            file.write_text(f"#!/bin/bash\n{script}\n", encoding="utf-8")
            file.chmod(0o755)
        self.note("known")
        self.note("ctest_output", "100% tests passed, 0 tests failed out of 4\n")

    def note(self, name, text=""):
        (self.box / name).write_text(text, encoding="utf-8")

    def log(self):
        file = self.box / "log"
        return file.read_text(encoding="utf-8") if file.exists() else ""

    def environment(self):
        return {"PATH": str(self.box / "bin"), "BOX": str(self.box), "HOME": str(self.box)}

    def run_it(self, *arguments, folder="a person's folder"):
        return subprocess.run(
            [self.box / "tree/run", *arguments],
            cwd=self.box / folder,
            env=self.environment(),
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=60,
            check=False,
        )

    def run_at_terminal(self, answer, *arguments):
        """Exit code of ./run with a terminal as stdin, where `answer` is typed."""
        try:
            terminal, stdin = pty.openpty()
        except OSError as reason:
            self.skipTest(f"this system gives no terminals: {reason}")
        os.write(terminal, answer.encode())
        done = subprocess.run(
            [self.box / "tree/run", *arguments],
            cwd=self.box,
            env=self.environment(),
            stdin=stdin,
            capture_output=True,
            timeout=60,
            check=False,
        )
        os.close(stdin)
        os.close(terminal)
        return done.returncode

    def remove(self, *names):
        for name in names:
            (self.box / "bin" / name).unlink()

    def test_it_opens_the_lab_as_it_was_left(self):
        done = self.run_it()
        self.assertEqual(done.stdout, f"in {self.box}/a person's folder\n")
        self.assertEqual(done.returncode, 7)

    def test_a_command_gets_its_words_as_they_are_and_the_persons_folder(self):
        done = self.run_it("render", "my look", "-o", "a b.png", "--set", "x=*")
        self.assertEqual(
            done.stdout,
            f"in {self.box}/a person's folder\n<render>\n<my look>\n<-o>\n<a b.png>\n<--set>\n<x=*>\n",
        )

    def test_check_and_bench_of_a_look_are_the_programs(self):
        self.assertIn("<check>\n<crt>", self.run_it("check", "crt").stdout)
        self.assertIn("<bench>\n<crt>\n<--json>", self.run_it("bench", "crt", "--json").stdout)

    def test_golden_with_arguments_is_the_programs(self):
        done = self.run_it("golden", "my looks", "--update", "a")
        self.assertIn("<golden>\n<my looks>\n<--update>\n<a>", done.stdout)
        self.assertIn("<golden>\n<--help>", self.run_it("golden", "--help").stdout)
        self.assertNotIn("ctest --", self.log())

    def test_golden_pictures_of_the_tests_are_redrawn_only_by_their_own_option(self):
        for arguments in ((), ("--redraw-tests", "crt"), ("--redraw-test",), ("crt", "--redraw-tests"), ("",)):
            with self.subTest(arguments):
                done = self.run_it("golden", *arguments)
                self.assertNotEqual(done.returncode, 0)
                self.assertNotIn("ctest --", self.log())
        self.assertIn("--redraw-tests", self.run_it("golden").stderr)
        done = self.run_it("golden", "--redraw-tests")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("golden=1 ctest --test-dir", self.log())
        self.assertIn("-L golden", self.log())

    def test_it_says_what_it_installs_and_how_much_before_it_does(self):
        said = self.run_it("build").stderr
        self.assertIn("g++", said)
        self.assertIn("Packages including dependencies: 2 (3 MB to download, 2 MB on disk)", said)
        self.assertIn("apt-get install", self.log())
        self.assertIn("libopenimageio-dev", self.log())
        self.assertIn("--no-install-recommends", self.log())

    def test_what_is_installed_is_not_installed_again(self):
        self.run_it("build")
        before = self.log().count("apt-get install")
        done = self.run_it("build")
        self.assertEqual(self.log().count("apt-get install"), before)
        self.assertEqual(done.stderr, "")

    def test_at_a_terminal_it_asks_and_no_means_no(self):
        self.run_at_terminal("n\n", "build")
        self.assertNotIn("apt-get install", self.log())
        self.assertIn("cmake --preset release", self.log())

    def test_at_a_terminal_yes_or_the_option_installs(self):
        self.run_at_terminal("y\n", "build")
        self.assertIn("apt-get install", self.log())
        shutil.rmtree(self.box / "installed")
        (self.box / "installed").mkdir()
        self.run_at_terminal("", "--yes", "build")
        self.assertEqual(self.log().count("apt-get install"), 2)

    def test_without_lists_of_packages_it_fetches_them_first(self):
        (self.box / "known").unlink()
        self.run_it("build")
        self.assertLess(self.log().index("apt-get update"), self.log().index("apt-get install"))

    def test_without_apt_it_builds_where_cmake_finds_everything(self):
        self.remove("apt-get", "dpkg-query", "apt-cache")
        self.assertEqual(self.run_it("list", "looks").returncode, 7)

    def test_without_apt_it_prints_the_packages_where_cmake_does_not(self):
        self.remove("apt-get", "dpkg-query", "apt-cache")
        self.note("cmake_fails")
        done = self.run_it()
        self.assertEqual(done.returncode, 1)
        self.assertIn("nlohmann-json3-dev", done.stderr)
        self.assertNotIn("xdotool", done.stderr)

    def test_a_build_that_fails_starts_nothing(self):
        self.note("build_fails")
        done = self.run_it("render", "x")
        self.assertEqual((done.returncode, done.stdout), (1, ""))

    def test_the_tests_close_with_a_plain_count(self):
        self.note("ctest_output", "100% tests passed, 0 tests failed out of 4\n")
        done = self.run_it("test")
        self.assertEqual(done.stdout.splitlines()[-1], "4 passed, 0 failed, 0 skipped")
        self.assertEqual(done.returncode, 0)

    def test_failed_and_skipped_tests_are_counted_and_fail(self):
        self.note(
            "ctest_output",
            "60% tests passed, 2 tests failed out of 5\n\nThe following tests did not run:\n"
            "\t  3 - c (Skipped)\n\nThe following tests FAILED:\n\t  2 - b (Failed)\n",
        )
        self.note("tests_fail")
        done = self.run_it("test")
        self.assertEqual(done.stdout.splitlines()[-1], "2 passed, 2 failed, 1 skipped")
        self.assertEqual(done.returncode, 1)

    def test_the_reader_of_isf_files_comes_from_npm_once(self):
        for _ in range(2):
            self.assertEqual(self.run_it("test").returncode, 0)
        self.assertEqual(self.log().count("npm pack interactive-shader-format@2.9.0\n"), 1)
        self.assertTrue((self.box / "tree/build/npm/interactive-shader-format/package.json").exists())
        self.assertNotRegex(self.log(), "apt-get install .* npm\n")

    def test_without_npm_the_tests_run_and_it_says_what_to_do(self):
        self.remove("npm")
        done = self.run_it("test")
        self.assertRegex(self.log(), "apt-get install .* npm\n")
        self.assertIn("set the registry of npm", done.stderr)
        self.assertIn("/tree/build/npm/interactive-shader-format-2.9.0.tgz", done.stderr)
        self.assertEqual(done.stdout.splitlines()[-1], "4 passed, 0 failed, 0 skipped")

    def test_a_package_of_npm_that_fails_or_differs_is_not_used(self):
        for reason in ("npm_fails", "sum_differs"):
            with self.subTest(reason):
                self.note(reason)
                done = self.run_it("test")
                self.assertIn("a test is skipped", done.stderr)
                self.assertEqual(done.returncode, 0)
                self.assertFalse((self.box / "tree/build/npm/interactive-shader-format").exists())
                (self.box / reason).unlink()

    def test_the_sanitizers_have_a_build_of_their_own(self):
        self.run_it("test", "--sanitize", "-R", "base")
        self.assertIn("cmake --preset sanitize", self.log())
        self.assertRegex(self.log(), r"ctest .*build/sanitize.* -L unit\|bad_input -R base")

    def test_random_texts_have_a_build_and_packages_of_their_own(self):
        self.run_it("test")
        self.assertNotIn("libclang-rt-dev", self.log())
        self.run_it("soak", "fuzz", "5000")
        self.assertIn("libclang-rt-dev", self.log())
        self.assertIn("cmake --preset fuzz", self.log())
        self.assertIn("--target fuzzers", self.log())

    def write_bench(self, name, key, verdict, ending=0):
        """Writes a benchmark that reports one figure."""
        (self.box / f"tree/tests/bench/{name}_bench.cpp").touch()
        figure = {"topic": "t", "title": "T", "key": key, "what": key, "value": 1.0, "unit": "", "at_most": 2.0,
                  "verdict": verdict}
        program = self.box / f"tree/build/release/tests/bench/{name}_bench"
        program.write_text(
            f"#!/bin/bash\necho '{json.dumps(figure)}' >> \"$AFTERGLOW_BENCH_FIGURES\"\nexit {ending}\n",
            encoding="utf-8")
        program.chmod(0o755)

    def run_benches(self, *benches):
        """The result of ./run bench, and the page that it wrote."""
        for folder in ("tests/bench", "build/release/tests/bench", "docs"):
            (self.box / "tree" / folder).mkdir(parents=True, exist_ok=True)
        for name in ("figure.py", "write_table.py"):
            shutil.copy(SOURCE / "tests/bench" / name, self.box / "tree/tests/bench")
        page = self.box / "tree/docs/performance.md"
        page.write_text("<!-- figures, written by ./run bench -->\n<!-- end of figures -->\n", encoding="utf-8")
        for bench in benches:
            self.write_bench(*bench)
        return self.run_it("bench"), page.read_text(encoding="utf-8")

    def test_figures_of_benches_become_tables_of_the_page(self):
        script = self.box / "tree/tests/bench/last_bench.py"
        script.parent.mkdir(parents=True)
        script.write_text("import sys\nprint('got', sys.argv[1])\n", encoding="utf-8")
        done, page = self.run_benches(("one", "first", "pass"), ("two", "second", "noise"))
        self.assertIn("<!-- t/first -->", page)
        self.assertIn("<!-- t/second -->", page)
        self.assertIn(f"got {self.box}/tree/build/release/app/afterglow\n", done.stdout)
        self.assertTrue(done.stdout.endswith("\n1 pass, 0 miss, 1 noise\n"))
        self.assertEqual(done.returncode, 0)

    def test_a_missed_goal_fails_the_run(self):
        done, _ = self.run_benches(("one", "first", "miss"), ("two", "second", "pass"))
        self.assertTrue(done.stdout.endswith("\n1 pass, 1 miss, 0 noise\n"))
        self.assertEqual(done.returncode, 1)

    def test_a_bench_that_fails_does_not_stop_the_others(self):
        done, page = self.run_benches(("one", "first", "pass", 3), ("two", "second", "pass"))
        self.assertIn("Benchmark one_bench failed\n", done.stderr)
        self.assertIn("<!-- t/second -->", page)
        self.assertTrue(done.stdout.endswith("\n2 pass, 0 miss, 0 noise\n"))
        self.assertEqual(done.returncode, 1)

    def test_help_tells_the_two_checks_apart_and_installs_nothing(self):
        done = self.run_it("--help")
        self.assertIn("./run check", done.stdout)
        self.assertIn("check LOOK", done.stdout)
        self.assertEqual(self.log(), "")


class RegisteredTests(unittest.TestCase):
    def test_every_class_of_the_window_runs(self):
        window = SOURCE / "tests/window"
        files = [file for file in window.glob("*.py") if not file.stem.endswith("_test")]
        classes = {name for file in files
                   for name in re.findall(r"^class (\w+)\(Person\)", file.read_text(encoding="utf-8"), re.MULTILINE)}
        listed = re.search(r"foreach\(class ([^)]*)\)", (SOURCE / "tests/CMakeLists.txt").read_text(encoding="utf-8"))[1]
        self.assertEqual(set(listed.split()), classes)
        bases = re.search(r"class WindowTest\(([^)]*)\)", (window / "window_test.py").read_text(encoding="utf-8"))[1]
        self.assertEqual(set(re.split(r",\s*", bases)), classes)


if __name__ == "__main__":
    unittest.main()
