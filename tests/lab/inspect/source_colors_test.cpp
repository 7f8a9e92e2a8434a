#include "lab/inspect/source_colors.h"

#include "base/text.h"

#include <doctest/doctest.h>

#include <string>

namespace {
/// One letter per byte: k keyword, t type, f call, n number, c comment, d directive, . plain.
std::string kinds_of(std::string_view line, bool starts_in_comment = false) {
    std::string kinds;
    std::size_t end = 0;
    for (const CodeSpan& span : code_spans(line, starts_in_comment)) {
        CHECK(span.begin == end);
        end = span.end;
        kinds.append(span.end - span.begin, ".ktfncd"[static_cast<int>(span.kind)]);
    }
    CHECK(end == line.size());
    return kinds;
}
}  // namespace

TEST_CASE("words, numbers, comments and directives have their own colours") {
    CHECK(kinds_of("uniform vec3 tint; // c") == "kkkkkkk.tttt.......cccc");
    CHECK(kinds_of("  x = sin(1.5e-3);") == "......fff.nnnnnn..");
    CHECK(kinds_of("if (a) discard;") == "kk.....kkkkkkk.");
    CHECK(kinds_of("#define A vec3(1)") == "ddddddddddddddddd");
    CHECK(kinds_of("a */ int b", true) == "cccc.ttt..");
    CHECK(kinds_of("all of it", true) == "ccccccccc");
    CHECK(kinds_of("a /* b */ c") == "..ccccccc..");
    CHECK(kinds_of("") == "");
}

TEST_CASE("a block comment continues on the following lines") {
    const std::string text = "a /* b\nc\n*/ d // e /*\nf /* g */ h\n";
    CHECK(lines_in_comments(split_lines(text)) == std::vector<bool>{false, true, true, false});
}
