#include "glsl/annotations/hint.h"
#include "glsl/compile/check.h"
#include "glsl/compile/compiler_log.h"
#include "glsl/limits/bounds.h"
#include "glsl/shader_texts.h"
#include "glsl/text/declarations.h"
#include "glsl/text/include.h"
#include "in_a_moment.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

namespace {
Hints hints_of(const std::string& comment) {
    Diagnostics errors;
    Hints hints = parse_hints({{comment, 1}}, stage_of("a.frag", ""), errors);
    CHECK(to_string(errors) == "");
    return hints;
}

std::string errors_of(const std::string& text) {
    const auto checked = check_program(fullscreen_vertex_stage(), stage_of("a.frag", text));
    REQUIRE_FALSE(checked.has_value());
    return to_string(checked.error());
}
}  // namespace

TEST_CASE("a very long row of stars in a comment is parsed fast") {
    const std::string comment = "\n" + times(500'000, "*") + "\n * @unit \"px\"";
    Hints hints;
    CHECK(is_done_in_a_moment([&] { hints = hints_of(comment); }));
    REQUIRE(hints.size() == 1);
    CHECK(hints[0].words == std::vector<std::string>{"px"});
    CHECK(hints[0].at.line == 3);
}

TEST_CASE("an annotation text may continue over very many lines") {
    const std::string lines = times(300'000, "  all of this\n");
    Hints hints;
    CHECK(is_done_in_a_moment([&] { hints = hints_of("@help \"" + lines + "\""); }));
    CHECK((hints.at(0).words.at(0) == times(300'000, "all of this ")));
}

TEST_CASE("a comment applies to at most 64 names of its line") {
    const std::string text = "uniform float " + times(20'000, "a, ") + "b; // @range 0 1\n";
    const std::vector<Declaration> found = find_declarations(text);
    REQUIRE(found.size() == 20'001);
    CHECK(found[63].comments.size() == 1);
    CHECK(found[64].comments.empty());
}

TEST_CASE("an unclosed string in very many comment lines is scanned once") {
    const std::string text = "uniform float a; // @label \"x\n" + times(300'000, "//\n");
    std::vector<Declaration> found;
    CHECK(is_done_in_a_moment([&] { found = find_declarations(text); }));
    CHECK(found.at(0).comments.size() == 300'001);
}

TEST_CASE(
    "macros with very many parameters or definitions are scanned fast, and rejected if too long") {
    const std::string many = "#define F(" + times(200'000, "a,") + "a) " + times(200'000, "G(a) ");
    std::optional<LimitViolation> fault;
    CHECK(is_done_in_a_moment(
        [&] { fault = find_limit_violation(many + "\n#define G(x) x\nfloat b = F(1);\n"); }));
    REQUIRE(fault.has_value());
    CHECK(fault->line == 3);
    const std::string again =
        times(100'000, "#define A 1\n") + "float b = " + times(16'000, "A ") + ";\n";
    CHECK(is_done_in_a_moment([&] { fault = find_limit_violation(again); }));
    CHECK_FALSE(fault.has_value());
}

TEST_CASE("includes of only whitespace also count towards the size limit") {
    const TemporaryFolder folder;
    folder.write("blank.glsl", std::string(std::size_t{3} << 20, ' '));
    const auto file = folder.write("a.frag", times(4000, "#include \"blank.glsl\"\n"));
    std::vector<std::filesystem::path> files;
    const auto stage = load_stage(file, {}, files);
    REQUIRE_FALSE(stage.has_value());
    CHECK(stage.error().front().message.find("larger than the limit") != std::string::npos);
}

TEST_CASE("only the first 256 errors of the compiler are listed") {
    std::string log = "WARNING: 0:1: 'a' : odd\n";
    for (int line = 1; line <= 300; ++line)
        log += fmt::format("ERROR: 0:{}: 'x' : wrong\n", line);
    const std::vector<CompilerMessage> messages = parse_compiler_log(log);
    CHECK(messages.size() == 1 + 256 + 1);
    CHECK(messages.back().text == "more than 256 errors; only the first 256 are listed");
}

TEST_CASE("more varyings than the limit are rejected") {
    std::string varyings = "#version 410 core\nout vec4 color;\n";
    for (int i = 0; i < 257; ++i)
        varyings += fmt::format("in float v{};\n", i);
    CHECK(errors_of(varyings + "void main() { color = vec4(1); }\n")
              .find("the shader has 257 varyings; the limit is 256") != std::string::npos);
}
