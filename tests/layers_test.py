"""Checks the rules of layers.py on this tree, and on small trees that break one rule each."""

import tempfile
import unittest
from pathlib import Path

import layers

CMAKE = """
# add_layer(commented USES out)
add_layer(base LINKS fmt)
add_layer(model USES base
    LINKS fmt)
add_layer(io USES base)
add_layer(gpu USES base model)
add_layer(ui USES gpu)
add_layer(lab USES base ROOMS media .
    window LINKS fmt)
"""


def breaches_in(files):
    """What check_tree reports for a tree with these files: {path: text}."""
    with tempfile.TemporaryDirectory() as root:
        for path, text in {"app/CMakeLists.txt": CMAKE, **files}.items():
            file = Path(root, path)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
        return layers.check_tree(root)


class LayersTest(unittest.TestCase):
    def assert_breach(self, path, text, expected):
        self.assertEqual(breaches_in({path: text}), [expected])

    def assert_none(self, path, text):
        self.assertEqual(breaches_in({path: text}), [])

    def test_this_tree_keeps_the_rules(self):
        self.assertEqual(layers.check_tree(Path(__file__).resolve().parent.parent), [])

    def test_the_uses_of_each_layer_are_read_from_cmake(self):
        self.assertEqual(
            layers.read_layers(CMAKE),
            {
                "base": set(),
                "model": {"base"},
                "io": {"base"},
                "gpu": {"base", "model"},
                "ui": {"gpu"},
                "lab": {"base"},
            },
        )

    def test_the_rooms_of_each_layer_are_read_from_cmake(self):
        self.assertEqual(layers.read_rooms(CMAKE)["lab"], ["media", ".", "window"])
        self.assertEqual(layers.read_rooms(CMAKE)["model"], [])

    def test_a_room_includes_itself_and_the_rooms_below_it(self):
        self.assert_none("app/lab/window/panes.h", '#include "lab/lab.h"\n#include "lab/media/source.h"\n')
        self.assert_none("app/lab/lab.h", '#include "lab/media/source.h"\n#include "lab/lab_state.h"\n')
        self.assert_breach(
            "app/lab/media/source.h",
            '#include "base/text.h"\n#include "lab/window/panes.h"\n',
            "app/lab/media/source.h:2: error: lab/media may not include lab/window: it is above it",
        )
        self.assert_breach(
            "app/lab/media/source.h",
            '#include "lab/lab.h"\n',
            "app/lab/media/source.h:1: error: lab/media may not include lab/.: it is above it",
        )

    def test_every_room_is_in_the_order_of_its_layer(self):
        self.assert_breach(
            "app/lab/attic/box.h",
            "int box;\n",
            "app/lab/attic/box.h: error: lab/attic is not in the ROOMS of lab in app/CMakeLists.txt",
        )
        self.assert_breach(
            "app/model/attic/box.h",
            "int box;\n",
            "app/model/attic/box.h: error: model/attic is not in the ROOMS of model in app/CMakeLists.txt",
        )

    def test_a_layer_may_include_itself_and_what_it_uses(self):
        self.assert_none("app/model/look.h", '#include "base/text.h"\n#include "model/plan.h"\n')

    def test_an_include_upwards_is_a_breach(self):
        self.assert_breach(
            "app/base/text.h",
            '#include <string>\n#include "model/look.h"\n',
            "app/base/text.h:2: error: base may not include model: it is not in its USES",
        )

    def test_what_a_used_layer_uses_may_not_be_included(self):
        self.assert_breach(
            "app/ui/panel.cpp",
            '#  include "base/text.h"  // by way of gpu\n',
            "app/ui/panel.cpp:1: error: ui may not include base: it is not in its USES",
        )

    def test_an_include_names_its_layer(self):
        self.assert_breach(
            "app/base/text.cpp",
            '#include "text.h"\n',
            'app/base/text.cpp:1: error: #include "text.h" does not name a layer and a file',
        )

    def test_a_folder_of_code_is_a_layer(self):
        self.assert_breach(
            "app/extra/x.cpp", "\n", "app/extra: error: app/CMakeLists.txt has no add_layer(extra ...)"
        )
        self.assert_breach(
            "app/rooms/room/x.cpp", "\n", "app/rooms: error: app/CMakeLists.txt has no add_layer(rooms ...)"
        )

    def test_gl_egl_and_glfw_stay_in_gpu(self):
        for call, name, what in [
            ("glDrawArrays(0, 0, 3);", "glDrawArrays(", "a GL call"),
            ("auto d = eglGetDisplay(x);", "eglGetDisplay", "an EGL call"),
            ("if (glfwInit())", "glfwInit", "a GLFW call"),
            ("#include <epoxy/gl.h>", "#include <epoxy/", "a header of GL, EGL or GLFW"),
        ]:
            self.assert_none("app/gpu/texture.cpp", call + "\n")
            for path in ("app/ui/panel.cpp", "app/main.cpp"):
                self.assert_breach(
                    path, "\n" + call + "\n", f"{path}:2: error: '{name}' is {what}, which belongs in gpu/"
                )

    def test_dear_imgui_stays_in_ui(self):
        for line in ("ImGui::Text(name);", "#include <imgui.h>"):
            self.assert_none("app/ui/panel.cpp", line + "\n")
            self.assertEqual(len(breaches_in({"app/gpu/texture.cpp": line + "\n"})), 1)

    def test_system_calls_stay_in_io_and_gpu(self):
        for line, name, what in [
            ("#include <unistd.h>", "#include <unistd.h", "a header of POSIX or Linux"),
            ("#include <csignal>", "#include <csignal", "a header of POSIX or Linux"),
            ("#include <sys/stat.h>", "#include <sys/", "a header of POSIX or Linux"),
            ("# include <linux/input.h>", "# include <linux/", "a header of POSIX or Linux"),
            ('setenv("HOME", home, 1);', "setenv(", "a POSIX call"),
            ('std::ifstream file("/proc/self/statm");', "/proc/", "a file of Linux"),
        ]:
            for path in ("app/io/clock.cpp", "app/gpu/driver_cache.cpp", "tests/io/a_test.cpp"):
                self.assert_none(path, line + "\n")
            for path in ("app/lab/lab.cpp", "app/main.cpp"):
                self.assert_breach(
                    path, "\n" + line + "\n", f"{path}:2: error: '{name}' is {what}, which belongs in io/ or gpu/"
                )

    def test_standard_headers_are_not_system_calls(self):
        self.assert_none(
            "app/lab/lab.cpp",
            "#include <cstdlib>\n#include <filesystem>\n#include <signal_path.h>\n"
            'const char* home = std::getenv("HOME");\n',
        )

    def test_comments_and_texts_are_not_calls(self):
        self.assert_none(
            "app/base/text.cpp",
            '// glEnable( is for gpu\n/* ImGui::\n ImGui */ auto a = "glEnable(\\" ImGui";\n'
            'auto b = R"(\nImGui)"; glslang::x(); int global = globals(\'"\');\n',
        )

    def test_a_function_may_have_60_lines_and_not_61(self):
        def function(lines):
            return "int f(int a,\n      int b) {\n" + "    for (;;) { g(); }\n" * (lines - 3) + "}\n"

        self.assert_none("app/base/text.cpp", "struct S {\n" + function(60) + function(60) + "};\n")
        for path in ("app/base/text.cpp", "shaders/x/x.frag"):
            self.assert_breach(
                path, "\n" + function(61), f"{path}:2: error: a function of 61 lines; 60 are the most"
            )

    def test_a_table_is_no_function(self):
        self.assert_none("app/base/text.cpp", "const Row rows[] = {\n" + "    {f(), 1},\n" * 90 + "};\n")

    def test_a_python_function_may_have_60_lines_and_not_61(self):
        self.assert_none("tests/x.py", "def f():\n" + "    g()\n" * 59)
        self.assert_breach(
            "tests/x.py",
            "def f():\n" + "    g()\n" * 60,
            "tests/x.py:1: error: a function of 61 lines; 60 are the most",
        )

    def test_a_file_may_have_500_lines_and_not_501(self):
        self.assert_none("app/base/text.cpp", "\n" * 500)
        self.assert_breach(
            "app/base/text.cpp", "\n" * 501, "app/base/text.cpp: error: 501 lines; 500 are the most"
        )

    def test_no_host_of_packages_is_named(self):
        host = "https://" + "deb.example.org/x"
        self.assertEqual(len(breaches_in({"docs/a.md": "get it from " + host})), 1)
        self.assert_none("docs/a.md", "see https://example.org/packages/deb.html")

    def test_a_tree_without_layers_is_a_breach(self):
        self.assertEqual(
            breaches_in({"app/CMakeLists.txt": "\n"}), ["app/CMakeLists.txt: error: has no add_layer lines"]
        )


if __name__ == "__main__":
    unittest.main()
