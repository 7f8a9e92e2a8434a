#include "glsl/include.h"

#include "glsl/check.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace {
/// look/ is the look's folder, include/ lies beside it, shared/ is the program's.
class Tree {
public:
    Tree() {
        for (const char* folder : {"look/deep", "include", "shared", "outside"})
            fs::create_directories(m_folder / folder);
    }

    fs::path write(const std::string& name, const std::string& text) const {
        return m_folder.write(name, text);
    }

    Result<Stage> load(const std::string& name) {
        m_files.clear();
        return load_stage(root() / name, {root() / "look", root() / "shared"}, m_files);
    }

    const fs::path& root() const { return m_folder.path(); }
    bool watches(const std::string& name) const {
        return std::ranges::find(m_files, root() / name) != m_files.end();
    }

private:
    TemporaryFolder m_folder;
    std::vector<fs::path> m_files;
};

std::string first_message(const Result<Stage>& stage) {
    REQUIRE_FALSE(stage.has_value());
    return stage.error().front().message;
}
}  // namespace

TEST_CASE("every line of an assembled shader knows its author's file and line") {
    Tree tree;
    const fs::path top = tree.write("look/a.frag",
                                    "#version 410 core\n"
                                    "#include \"noise.glsl\"  // from the shared ones\n"
                                    "void main() {}\n");
    const fs::path noise = tree.write("shared/noise.glsl", "float a;\r\nfloat b;\r\n");
    const auto stage = tree.load("look/a.frag");

    REQUIRE(stage.has_value());
    CHECK(stage->file == top);
    CHECK(stage->text ==
          "#version 410 core\nfloat a;\nfloat b;\n  // from the shared ones\nvoid main() {}\n");
    const LineMap expected{{top, 1}, {noise, 1}, {noise, 2}, {top, 2}, {top, 3}};
    CHECK(stage->lines == expected);
}

TEST_CASE("an include is looked for beside the file, in the look, beside the look, in the shared") {
    Tree tree;
    tree.write("look/a.frag", "#include \"deep/b.glsl\"\n");
    tree.write("look/deep/b.glsl", "#include \"c.glsl\"\n");
    tree.write("shared/c.glsl", "shared\n");
    CHECK(tree.load("look/a.frag")->text == "shared\n");
    CHECK(tree.watches("look/deep/c.glsl"));
    CHECK(tree.watches("include/c.glsl"));
    tree.write("include/c.glsl", "beside the look\n");
    CHECK(tree.load("look/a.frag")->text == "beside the look\n");
    tree.write("look/c.glsl", "the look\n");
    CHECK(tree.load("look/a.frag")->text == "the look\n");
    tree.write("look/deep/c.glsl", "beside the file\n");
    CHECK(tree.load("look/a.frag")->text == "beside the file\n");
}

TEST_CASE("an include in a comment is none") {
    Tree tree;
    tree.write("look/a.frag", "// #include \"x\"\n/*\n#include \"y\"\n*/ int a;\n");
    REQUIRE(tree.load("look/a.frag").has_value());
}

TEST_CASE("a comment that ends or starts on an include's line is kept") {
    Tree tree;
    tree.write("look/b.glsl", "int b;");
    tree.write("look/a.frag", "/* a\n*/ #include \"b.glsl\" /* c\n*/\nint a;\n");
    const auto stage = tree.load("look/a.frag");
    REQUIRE(stage.has_value());
    CHECK(stage->text == "/* a\n*/ \nint b;\n /* c\n*/\nint a;\n");
}

TEST_CASE("a missing include is reported where it is asked for, and watched") {
    Tree tree;
    const fs::path top =
        tree.write("look/a.frag", "\n#include \"gone.glsl\"\n#include \"too.glsl\"\n");
    const auto stage = tree.load("look/a.frag");
    REQUIRE_FALSE(stage.has_value());
    REQUIRE(stage.error().size() == 2);
    CHECK(stage.error()[0].file == top);
    CHECK(stage.error()[0].line == 2);
    CHECK(stage.error()[0].message.starts_with("there is no file 'gone.glsl'"));
    CHECK(stage.error()[1].line == 3);
    CHECK(tree.watches("look/a.frag"));
    CHECK(tree.watches("look/gone.glsl"));
    CHECK(tree.watches("shared/too.glsl"));
}

TEST_CASE("includes that go round in a circle show the circle") {
    Tree tree;
    tree.write("look/a.frag", "#include \"b.glsl\"\n");
    tree.write("look/b.glsl", "int b;\n#include \"c.glsl\"\n");
    const fs::path last =
        tree.write("look/c.glsl", "#include \"deep/../b.glsl\"\n#include \"b.glsl\"\n");
    const auto stage = tree.load("look/a.frag");
    REQUIRE_FALSE(stage.has_value());
    REQUIRE(stage.error().size() == 2);
    CHECK(stage.error()[0].message == "'..' cannot be used in an include");
    CHECK(stage.error()[1] == Diagnostic{last, 2,
                                         "includes go round in a circle: b.glsl -> c.glsl -> "
                                         "b.glsl"});
}

TEST_CASE("nothing outside of the roots is readable") {
    Tree tree;
    const fs::path secret = tree.write("outside/secret.glsl", "secret\n");
    fs::create_symlink(secret, tree.root() / "look/link.glsl");
    fs::create_directory_symlink(tree.root() / "outside", tree.root() / "look/folder");
    const std::vector<std::string> names{"../outside/secret.glsl",
                                         "link.glsl",
                                         "folder/secret.glsl",
                                         secret.string(),
                                         "deep/../../outside/secret.glsl",
                                         "..\\outside\\secret.glsl",
                                         "C:/secret.glsl",
                                         ""};
    for (const std::string& name : names) {
        CAPTURE(name);
        tree.write("look/a.frag", "#version 410 core\n#include \"" + name + "\"\n");
        const auto stage = tree.load("look/a.frag");
        REQUIRE_FALSE(stage.has_value());
        CHECK(stage.error().front().line == 2);
    }
    fs::create_symlink(secret, tree.root() / "look/top.frag");
    CHECK(first_message(tree.load("look/top.frag")).find("leads out of") != std::string::npos);
}

TEST_CASE("a link within the roots is followed") {
    Tree tree;
    tree.write("shared/real.glsl", "real\n");
    fs::create_symlink(tree.root() / "shared/real.glsl", tree.root() / "look/link.glsl");
    tree.write("look/a.frag", "#include \"link.glsl\"\n");
    CHECK(tree.load("look/a.frag")->text == "real\n");
}

TEST_CASE("a file comes twice unless it says #pragma once") {
    Tree tree;
    tree.write("look/a.frag", "#include \"b.glsl\"\n#include \"b.glsl\"\n");
    tree.write("look/b.glsl", "b\n");
    CHECK(tree.load("look/a.frag")->text == "b\nb\n");
    tree.write("look/b.glsl", "#pragma once\nb\n");
    CHECK(tree.load("look/a.frag")->text == "            \nb\n");
}

TEST_CASE("an include that is not written as one says how it is written") {
    Tree tree;
    for (const char* line :
         {"#include <a.glsl>", "#include", "#include a.glsl", "#include \"a.glsl"}) {
        tree.write("look/a.frag", std::string(line) + "\n");
        CHECK(first_message(tree.load("look/a.frag")) ==
              "an include is written #include \"file.glsl\"");
    }
}

TEST_CASE("#line is blanked out, so that lines stay the author's") {
    Tree tree;
    tree.write("look/a.frag", "  # /* */ line 99 3 // far\nint a; // #line 5\n");
    const auto stage = tree.load("look/a.frag");
    REQUIRE(stage.has_value());
    CHECK(stage->text == std::string(20, ' ') + "// far\nint a; // #line 5\n");
}

TEST_CASE("files that are no text, or are not there, are one clear error") {
    Tree tree;
    CHECK(first_message(tree.load("look/none.frag")) == "there is no such file");
    CHECK(first_message(tree.load("look/deep")) == "is a folder, not a file");
    tree.write("look/binary.frag", std::string("a\nb\0c", 5));
    const auto binary = tree.load("look/binary.frag");
    REQUIRE_FALSE(binary.has_value());
    CHECK(binary.error().front().line == 2);
    tree.write("look/huge.frag", std::string(std::size_t{5} << 20, 'x'));
    CHECK(first_message(tree.load("look/huge.frag")).find("too large") != std::string::npos);
    tree.write("look/open.frag", "int a;\nint b; /* never\nclosed\n");
    const auto open = tree.load("look/open.frag");
    REQUIRE_FALSE(open.has_value());
    CHECK(open.error().front().line == 2);
}

TEST_CASE("includes that multiply or go too deep end with an error") {
    Tree tree;
    for (int i = 0; i < 100; ++i) {
        const std::string next = "#include \"" + std::to_string(i + 1) + ".glsl\"\n";
        tree.write("look/" + std::to_string(i) + ".glsl", next + next);
    }
    tree.write("look/100.glsl", "int a;\n");
    CHECK(first_message(tree.load("look/0.glsl")) == "includes are nested more than 64 deep");
    const auto many = tree.load("look/80.glsl");
    CHECK(first_message(many) == "more than 4096 includes in one shader");
    CHECK(many.error().size() == 1);
}

TEST_CASE("the program's own vertex shader checks with a fragment shader that reads uv") {
    const Stage fragment = builtin_stage(
        "#version 410 core\nin vec2 uv;\nout vec4 color;\nvoid main() { color = vec4(uv, 0, 1); "
        "}\n");
    CHECK(check_program(fullscreen_vertex_stage(), fragment).has_value());
}
