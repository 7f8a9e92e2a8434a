#include "formats/mpv_export/mpv_check.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

namespace {
std::string fault_of(const std::string& text) {
    const auto checked = check_mpv_shader(text);
    return checked ? "" : checked.error().front().message;
}

std::string block(const std::string& lines, const std::string& color) {
    return fmt::format(
        "//!HOOK MAIN\n//!BIND HOOKED\n//!DESC Own block\n{}vec4 hook() {{ return {}; }}\n", lines,
        color);
}
}  // namespace

TEST_CASE("a block reads the picture, saved targets, pictures and parameters") {
    CHECK(fault_of("// a comment\n" + block("//!SAVE first\n", "texture(HOOKED_raw, HOOKED_pos)") +
                   "//!TEXTURE table\n//!SIZE 1 1\n//!FORMAT rgba8\n00000000\n"
                   "//!PARAM gain\n//!TYPE float\n1.0\n" +
                   block("//!BIND first\n//!BIND table\n",
                         "first_size.x * gain * texture(table, first_pos)")) == "");
}

TEST_CASE("an error names the block, the reason and an alternative") {
    const std::string fault = fault_of(block("", "texture(HOOKED_raw, nowhere)"));
    CHECK(fault.find("'Own block' does not compile") != fault.npos);
    CHECK(fault.find("nowhere") != fault.npos);
    CHECK(fault.find("--to web") != fault.npos);
}

TEST_CASE("a texture must be saved by an earlier block") {
    CHECK(fault_of(block("//!BIND later\n", "vec4(1.0)") + block("//!SAVE later\n", "vec4(1.0)"))
              .find("reads 'later', which no block saves") != std::string::npos);
}

TEST_CASE("an unknown line is an error, and so is a file without blocks") {
    CHECK(fault_of(block("//!WAIT 3\n", "vec4(1.0)")).find("'//!WAIT'") != std::string::npos);
    CHECK(fault_of("vec4 hook() { return vec4(1.0); }\n").find("no blocks") != std::string::npos);
}

TEST_CASE("a block reads 15 saved textures at most") {
    std::string text;
    std::string binds;
    for (int i = 0; i < 15; ++i) {
        text += block(fmt::format("//!SAVE t{}\n", i), "vec4(1.0)");
        binds += fmt::format("//!BIND t{}\n", i);
    }
    CHECK(fault_of(text + block(binds, "vec4(1.0)")).find("mpv allows 15") != std::string::npos);
    binds.erase(0, binds.find('\n') + 1);
    CHECK(fault_of(text + block(binds, "vec4(1.0)")) == "");
}
