#include "base/source_excerpt.h"

#include "base/text.h"

#include <doctest/doctest.h>

namespace {
std::string shown(std::string_view text, int line, std::string_view message) {
    return to_string(excerpt_of(split_lines(text), line, message));
}

std::string marked(std::string_view line, std::string_view message) {
    const SourceExcerpt excerpt = excerpt_of({line}, 1, message);
    return std::string(excerpt.line().substr(excerpt.begin, excerpt.end - excerpt.begin));
}
}  // namespace

TEST_CASE("an excerpt shows a line on each side and a mark below the name") {
    constexpr std::string_view text =
        "void main() {\n\tfloat a = params.gian;\n\tcolor = vec4(a);\n}\n";
    CHECK(shown(text, 2, "'gian' is not a field of 'params'") ==
          "    1 | void main() {\n"
          "    2 |     float a = params.gian;\n"
          "      |                      ^~~~\n"
          "    3 |     color = vec4(a);\n");
    CHECK(shown(text, 1, "no name") ==
          "    1 | void main() {\n"
          "    2 |     float a = params.gian;\n");
    CHECK(shown(text, 4, "unexpected '}'") ==
          "    3 |     color = vec4(a);\n"
          "    4 | }\n"
          "      | ^\n");
    CHECK(shown(text, 5, "").empty());
    CHECK(shown(text, 0, "").empty());
    CHECK(shown("", 1, "'a'") == "");
}

TEST_CASE("common indentation is left out") {
    CHECK(shown("  {\n\n    x = y;\n", 3, "'y'") ==
          "    2 |\n"
          "    3 | x = y;\n"
          "      |     ^\n");
}

TEST_CASE("the mark is a whole name, or a sign that occurs once") {
    CHECK(marked("gain2 = gain * again;", "'gain' is undeclared") == "gain");
    CHECK(excerpt_of({"gain2 = gain * again;"}, 1, "'gain'").begin == 8);
    CHECK(marked("a == b = c;", "'=': cannot convert") == "=");
    CHECK(excerpt_of({"a == b = c;"}, 1, "'=': x").begin == 7);
    CHECK(marked("a = b; c = d;", "'=': cannot convert") == "");
    CHECK(marked("x = other;", "'absent' or 'other'") == "other");
    CHECK(marked("it's", "don't") == "");
    CHECK(marked("a = b;", "pass 'a': 'b' is undeclared") == "b");
    CHECK(marked("a = b;", "pass 'a") == "");
    CHECK(marked("\t\"a\" 1", "missing ':' (column 6)") == "1");
    CHECK(marked("short", "broken (column 60)") == "");
}

TEST_CASE("long, hostile and international lines stay readable") {
    const std::string padding(5000, ' ');
    const std::string line = "f(" + padding + "wrong" + padding + ")";
    const SourceExcerpt excerpt = excerpt_of({line}, 1, "'wrong'");
    CHECK(excerpt.line().size() < 220);
    CHECK(excerpt.line().substr(excerpt.begin, excerpt.end - excerpt.begin) == "wrong");
    CHECK(shown("\x1b[2J bad\xff", 1, "'bad'") ==
          "    1 | \\x1b[2J bad\\xff\n"
          "      |         ^~~\n");
    CHECK(shown("/* é */ bad", 1, "'bad'") ==
          "    1 | /* é */ bad\n"
          "      |         ^~~\n");
}
