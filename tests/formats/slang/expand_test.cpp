#include "formats/slang/expand.h"

#include "formats/slang/slang_folder.h"
#include "problems_of.h"

#include <fmt/format.h>

namespace {
// The lines of the vertex stage after #version and the host's definitions.
std::string body_of(SlangFolder& folder, const std::string& text) {
    const auto shader = folder.shader_of("#version 450\n" + text);
    REQUIRE_MESSAGE(shader.has_value(), problems_of(shader));
    std::string body;
    for (const std::string_view line : split_lines(shader->vertex.text))
        if (!line.starts_with("#version") && !line.starts_with("#define _HAS_"))
            body += std::string(line) + "|";
    return body;
}
}  // namespace

TEST_CASE("a slang include is relative to its own file, and may go up") {
    SlangFolder folder;
    folder.write("deep/one.inc", "#include \"two.inc\"\n#include \"../three.inc\"\n");
    folder.write("deep/two.inc", "2\n");
    folder.write("three.inc", "3\n");
    CHECK(body_of(folder, "#include \"deep/one.inc\"\nend\n") == "2|3|end|");
    CHECK(body_of(folder, "#include \"deep\\two.inc\"  // with a backslash\n") == "2|");
    CHECK(folder.has_seen("deep/two.inc"));
}

TEST_CASE("a slang include is expanded each time, also in an inactive #if") {
    SlangFolder folder;
    folder.write("x.inc", "x");
    CHECK(body_of(folder, "#if 0\n#include \"x.inc\"\n#endif\n#include \"x.inc\"\n") ==
          "#if 0|x|#endif|x|");
}

TEST_CASE("in a comment, an include counts only at the start of a line") {
    SlangFolder folder;
    folder.write("x.inc", "x\n");
    CHECK(body_of(folder, "/* as in\n   #include \"missing.inc\"\n*/ a\n  #include \"x.inc\"\n") ==
          "/* as in|   #include \"missing.inc\"|*/ a|x|");
    CHECK(body_of(folder, "/*\n#include \"x.inc\"\n*/\n") == "/*|x|*/|");
    CHECK(body_of(folder, "a // /* no block\n  #include \"x.inc\"\n") == "a // /* no block|x|");
    CHECK(body_of(folder, "// #include \"missing.inc\"\n") == "// #include \"missing.inc\"|");
}

TEST_CASE("a missing optional include is skipped and watched") {
    SlangFolder folder;
    const std::string text = "a\n#pragma include_optional \"user.inc\"\nb\n";
    CHECK(body_of(folder, text) == "a|b|");
    CHECK(folder.has_seen("user.inc"));
    folder.write("user.inc", "u\n");
    CHECK(body_of(folder, text) == "a|u|b|");
    folder.write("user.inc", std::string(1, '\0'));
    CHECK(folder.refusal(folder.shader("a.slang"))
              .starts_with("user.inc:1: error: this is not a text file"));
}

TEST_CASE("every missing include is reported at its line") {
    SlangFolder folder;
    folder.write("one.inc", "\n#include \"gone.inc\"\n");
    const auto shader = folder.shader_of(
        "#version 450\n#include \"one.inc\"\n#include \"lost.inc\"\n#include lost.inc\n");
    CHECK(folder.refusal(shader) ==
          "one.inc:2: error: can't include 'gone.inc' (gone.inc): file not found\n"
          "a.slang:3: error: can't include 'lost.inc' (lost.inc): file not found\n"
          "a.slang:4: error: expected #include \"file\"");
    CHECK(folder.has_seen("gone.inc"));
    CHECK(folder.has_seen("lost.inc"));
    CHECK(folder.has_seen("a.slang"));
}

TEST_CASE("circular slang includes are reported with their chain") {
    SlangFolder folder;
    folder.write("one.inc", "#include \"./two.inc\"\n");
    folder.write("two.inc", "#include \"one.inc\"\n");
    CHECK(folder.refusal(folder.shader_of("#version 450\n#include \"one.inc\"\n")) ==
          "two.inc:1: error: circular #include: one.inc -> two.inc -> one.inc");
    std::filesystem::create_symlink(folder / "one.inc", folder / "link.inc");
    folder.write("two.inc", "#include \"link.inc\"\n");
    CHECK(folder.refusal(folder.shader("a.slang")).find("circular #include") != std::string::npos);
}

TEST_CASE("slang includes are nested at most 64 files deep") {
    SlangFolder folder;
    // a.slang is the first file, 62.inc the 64th.
    for (int i = 0; i < 62; ++i)
        folder.write(fmt::format("{}.inc", i), fmt::format("#include \"{}.inc\"\n", i + 1));
    folder.write("62.inc", "deep\n");
    CHECK(body_of(folder, "#include \"0.inc\"\n") == "deep|");
    folder.write("62.inc", "#include \"63.inc\"\n");
    folder.write("63.inc", "too deep\n");
    CHECK(folder.refusal(folder.shader("a.slang")) ==
          "62.inc:1: error: includes are nested deeper than the limit of 64 levels");
}

TEST_CASE("a shader with its includes is limited to 8 MiB") {
    SlangFolder folder;
    folder.write("mega.inc", std::string((1 << 20) - 1, 'x') + "\n");
    std::string text = "#version 450\n";
    for (int i = 0; i < 7; ++i)
        text += "#include \"mega.inc\"\n";
    CHECK(folder.shader_of(text).has_value());
    text += "#include \"mega.inc\"\n";
    CHECK(folder.refusal(folder.shader_of(text)) ==
          "mega.inc:1: error: the shader with its includes is larger than the limit of 8 MiB");
}

TEST_CASE("exponentially growing includes are limited") {
    SlangFolder folder;
    for (int i = 0; i < 40; ++i)
        folder.write(fmt::format("{}.inc", i),
                     fmt::format("#include \"{0}.inc\"\n#include \"{0}.inc\"\n", i + 1));
    folder.write("40.inc", "");
    CHECK(folder.refusal(folder.shader_of("#version 450\n#include \"0.inc\"\n"))
              .find("the shader has more includes than the limit of 16384") != std::string::npos);
}

TEST_CASE("a slang file is read once, and limited to 4 MiB") {
    SlangFolder folder;
    SlangFiles files;
    const auto file = folder.write("a.inc", "first\n");
    const SlangText* first = *files.read(file);
    folder.write("a.inc", "second\n");
    CHECK(*files.read(file) == first);
    CHECK(first->text == "first\n");
    CHECK(files.seen() == std::vector{file});

    const auto large = folder.write("large.inc", std::string((4 << 20) + 1, ' '));
    const auto refused = files.read(large);
    REQUIRE_FALSE(refused.has_value());
    CHECK(refused.error().front().message == "the file is larger than the limit of 4 MiB");
}
