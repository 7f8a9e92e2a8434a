#include "glsl/text/include.h"

#include "glsl/compile/check.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace {
/// look/ is the look's folder, include/ is next to it, shared/ belongs to the program.
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
        const fs::path opened = tree.empty() ? fs::path() : root() / tree;
        return load_stage(root() / name, {root() / "look", {root() / "shared", named}, {}, opened},
                          m_files);
    }

    std::string tree = "look";    // the folder that was opened; "": the file alone
    std::vector<fs::path> named;  // folders of --include

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

TEST_CASE("every line of an assembled shader maps to its original file and line") {
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

TEST_CASE("includes are searched next to the file, in the look, next to the look and in shared/") {
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

TEST_CASE("an include in a comment is ignored") {
    Tree tree;
    tree.write("look/a.frag", "// #include \"x\"\n/*\n#include \"y\"\n*/ int a;\n");
    REQUIRE(tree.load("look/a.frag").has_value());
}

TEST_CASE("a comment that starts or ends on an include's line is kept") {
    Tree tree;
    tree.write("look/b.glsl", "int b;");
    tree.write("look/a.frag", "/* a\n*/ #include \"b.glsl\" /* c\n*/\nint a;\n");
    const auto stage = tree.load("look/a.frag");
    REQUIRE(stage.has_value());
    CHECK(stage->text == "/* a\n*/ \nint b;\n /* c\n*/\nint a;\n");
}

TEST_CASE("a missing include is reported at its line and watched") {
    Tree tree;
    const fs::path top =
        tree.write("look/a.frag", "\n#include \"gone.glsl\"\n#include \"too.glsl\"\n");
    const auto stage = tree.load("look/a.frag");
    REQUIRE_FALSE(stage.has_value());
    REQUIRE(stage.error().size() == 2);
    CHECK(stage.error()[0].file == top);
    CHECK(stage.error()[0].line == 2);
    CHECK(stage.error()[0].message.starts_with("can't find 'gone.glsl'"));
    CHECK(stage.error()[1].line == 3);
    CHECK(tree.watches("look/a.frag"));
    CHECK(tree.watches("look/gone.glsl"));
    CHECK(tree.watches("shared/too.glsl"));
}

TEST_CASE("circular includes are reported with their chain") {
    Tree tree;
    tree.write("look/a.frag", "#include \"b.glsl\"\n");
    tree.write("look/b.glsl", "int b;\n#include \"c.glsl\"\n");
    const fs::path last = tree.write("look/c.glsl", "int c;\n#include \"deep/../b.glsl\"\n");
    const auto stage = tree.load("look/a.frag");
    REQUIRE_FALSE(stage.has_value());
    REQUIRE(stage.error().size() == 1);
    CHECK(stage.error()[0] == Diagnostic{last, 2, "circular #include: b.glsl -> c.glsl -> b.glsl"});
}

TEST_CASE("files outside the opened folder and the include folders are not readable") {
    Tree tree;
    const fs::path secret = tree.write("outside/secret.glsl", "secret\n");
    const std::vector<std::string> names{
        "../outside/secret.glsl",   secret.string(),  "deep/../../outside/secret.glsl",
        "..\\outside\\secret.glsl", "C:/secret.glsl", ""};
    for (const std::string& name : names) {
        CAPTURE(name);
        tree.write("look/a.frag", "#version 410 core\n#include \"" + name + "\"\n");
        const auto stage = tree.load("look/a.frag");
        REQUIRE_FALSE(stage.has_value());
        CHECK(stage.error().front().line == 2);
    }
}

TEST_CASE("an include may go up only within the opened tree") {
    Tree tree;
    tree.write("outside/tint.glsl", "float tint;\n");
    tree.write("look/deep/a.frag", "#include \"../../outside/tint.glsl\"\n");
    tree.write("look/deep/b.frag", "#include \"../b.glsl\"\n");
    tree.write("look/b.glsl", "#include \"./deep/c.glsl\"\n");
    tree.write("look/deep/c.glsl", "float c;\n");
    CHECK(tree.load("look/deep/b.frag")->text == "float c;\n");

    const std::string refusal = first_message(tree.load("look/deep/a.frag"));
    CHECK(refusal.find("'" + (tree.root() / "look").string() + "'") != std::string::npos);
    CHECK(refusal.find("--include FOLDER") != std::string::npos);
    tree.named = {tree.root() / "outside"};
    CHECK(tree.load("look/deep/a.frag")->text == "float tint;\n");
    tree.write("look/d.frag", "#include \"tint.glsl\"\n");
    CHECK(tree.load("look/d.frag")->text == "float tint;\n");
}

TEST_CASE(
    "the tree of a single file is the nearest folder with .git or look.json, else its parent") {
    Tree tree;
    const auto opens = [&](const std::string& name) {
        return tree.load("look/deep/" + name).has_value();
    };
    tree.tree = "";
    tree.write("outside/tint.glsl", "float tint;\n");
    tree.write("look/near.glsl", "float near_by;\n");
    tree.write("look/deep/far.frag", "#include \"../../outside/tint.glsl\"\n");
    tree.write("look/deep/near.frag", "#include \"../near.glsl\"\n");
    CHECK(opened_tree(tree.root() / "look/deep/far.frag") == tree.root() / "look");
    CHECK(opens("near.frag"));
    CHECK_FALSE(opens("far.frag"));

    fs::create_directory(tree.root() / ".git");
    CHECK(opened_tree(tree.root() / "look/deep/far.frag") == tree.root());
    CHECK(opens("far.frag"));
    tree.write("look/look.json", "{}");
    CHECK(opened_tree(tree.root() / "look/deep/far.frag") == tree.root() / "look");
    CHECK_FALSE(opens("far.frag"));
}

TEST_CASE("a link is resolved from its own location: main file, include and include folder") {
    Tree tree;
    tree.write("outside/lib/color.glsl", "#include \"../space.glsl\"\n");
    tree.write("outside/space.glsl", "float space;\n");
    tree.write("outside/main.frag", "#include \"lygia/lib/color.glsl\"\n");
    fs::create_directory_symlink(tree.root() / "outside", tree.root() / "look/lygia");
    fs::create_symlink(tree.root() / "outside/main.frag", tree.root() / "look/top.frag");
    CHECK(tree.load("look/top.frag")->text == "float space;\n");

    fs::create_symlink(tree.root() / "outside/space.glsl", tree.root() / "look/link.glsl");
    tree.write("look/a.frag", "#include \"link.glsl\"\n");
    CHECK(tree.load("look/a.frag")->text == "float space;\n");
}

TEST_CASE("only files with a shader extension are included, also through links") {
    Tree tree;
    for (const char* name :
         {"a.glsl", "a.frag", "a.vert", "a.fs", "a.vs", "a.h", "a.inc", "a.slang", "A.GLSL"}) {
        CAPTURE(name);
        tree.write(std::string("look/") + name, "int a;\n");
        tree.write("look/top.frag", std::string("#include \"") + name + "\"\n");
        CHECK(tree.load("look/top.frag").has_value());
    }
    for (const char* name : {"a.txt", "id_rsa", "a.glsl.bak"}) {
        CAPTURE(name);
        tree.write(std::string("look/") + name, "int a;\n");
        tree.write("look/top.frag", std::string("#include \"") + name + "\"\n");
        CHECK(first_message(tree.load("look/top.frag")).find("use a file that ends in .glsl") !=
              std::string::npos);
    }
    fs::create_symlink(tree.root() / "look/id_rsa", tree.root() / "look/key.glsl");
    tree.write("look/top.frag", "#include \"key.glsl\"\n");
    CHECK(first_message(tree.load("look/top.frag")).find("isn't a shader file") !=
          std::string::npos);
}

TEST_CASE("a missing include that differs only in case gives a suggestion") {
    Tree tree;
    tree.write("look/deep/Noise.glsl", "int a;\n");
    tree.write("look/a.frag", "#include \"deep/noise.glsl\"\n");
    CHECK(first_message(tree.load("look/a.frag")).ends_with(" (did you mean 'Noise.glsl'?)"));
}

TEST_CASE("a file is included twice unless it has #pragma once") {
    Tree tree;
    tree.write("look/a.frag", "#include \"b.glsl\"\n#include \"b.glsl\"\n");
    tree.write("look/b.glsl", "b\n");
    CHECK(tree.load("look/a.frag")->text == "b\nb\n");
    tree.write("look/b.glsl", "#pragma once\nb\n");
    CHECK(tree.load("look/a.frag")->text == "            \nb\n");
}

TEST_CASE("a malformed include gives the expected syntax") {
    Tree tree;
    for (const char* line :
         {"#include <a.glsl>", "#include", "#include a.glsl", "#include \"a.glsl"}) {
        tree.write("look/a.frag", std::string(line) + "\n");
        CHECK(first_message(tree.load("look/a.frag")) == "expected #include \"file.glsl\"");
    }
}

TEST_CASE("#line is replaced by spaces, so that line numbers stay") {
    Tree tree;
    tree.write("look/a.frag", "  # /* */ line 99 3 // far\nint a; // #line 5\n");
    const auto stage = tree.load("look/a.frag");
    REQUIRE(stage.has_value());
    CHECK(stage->text == std::string(20, ' ') + "// far\nint a; // #line 5\n");
}

TEST_CASE("missing, binary, huge and unclosed files give one clear error") {
    Tree tree;
    CHECK(first_message(tree.load("look/none.frag")) == "file not found");
    CHECK(first_message(tree.load("look/deep")) == "this is a folder, not a file");
    tree.write("look/binary.frag", std::string("a\nb\0c", 5));
    const auto binary = tree.load("look/binary.frag");
    REQUIRE_FALSE(binary.has_value());
    CHECK(binary.error().front().line == 2);
    tree.write("look/huge.frag", std::string(std::size_t{5} << 20, 'x'));
    CHECK(first_message(tree.load("look/huge.frag")).find("larger than the limit") !=
          std::string::npos);
    tree.write("look/open.frag", "int a;\nint b; /* never\nclosed\n");
    const auto open = tree.load("look/open.frag");
    REQUIRE_FALSE(open.has_value());
    CHECK(open.error().front().line == 2);
}

TEST_CASE("includes that multiply or nest too deep are an error") {
    Tree tree;
    for (int i = 0; i < 100; ++i) {
        const std::string next = "#include \"" + std::to_string(i + 1) + ".glsl\"\n";
        tree.write("look/" + std::to_string(i) + ".glsl", next + next);
    }
    tree.write("look/100.glsl", "int a;\n");
    CHECK(first_message(tree.load("look/0.glsl")) ==
          "includes are nested deeper than the limit of 64 levels");
    const auto many = tree.load("look/80.glsl");
    CHECK(first_message(many) == "the shader has more includes than the limit of 4096");
    CHECK(many.error().size() == 1);
}

TEST_CASE("the built-in vertex shader links with a fragment shader that reads uv") {
    const Stage fragment = builtin_stage(
        "#version 410 core\nin vec2 uv;\nout vec4 color;\nvoid main() { color = vec4(uv, 0, 1); "
        "}\n");
    CHECK(check_program(fullscreen_vertex_stage(), fragment).has_value());
}
