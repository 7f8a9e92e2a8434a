#include "formats/slang/parameters.h"

#include "formats/slang/slang_text.h"

#include <doctest/doctest.h>

namespace {
SlangParameter read_line(const std::string& text) {
    const auto parameter = parse_slang_parameter(text, {"a.slang", 3});
    REQUIRE(parameter.has_value());
    return *parameter;
}
}  // namespace

TEST_CASE("a slang parameter accepts numbers in every C format") {
    CHECK(read_line("a \"A\" 1 .5 -1e-3 +2.50") ==
          SlangParameter{"a", "A", 1.0, 0.5, -0.001, 2.5, {"a.slang", 3}});
    CHECK(read_line("a\t\"A\"  0.0\t0.0  10.0 0.5 // twelve 12").step == 0.5);
}

TEST_CASE("a slang parameter's label may be empty, or contain spaces, legends and other scripts") {
    CHECK(read_line("row-0 \"\" 0 0 0 1").text.empty());
    CHECK(read_line("a \"  [ x = 1 | y = 2 ]  \" 0 0 1 1").text == "  [ x = 1 | y = 2 ]  ");
    CHECK(read_line("a \"\xe2\x98\x85 \xb9\" 0 0 1 1").text == "\xe2\x98\x85 \xc2\xb9");
}

TEST_CASE("a slang parameter without a step has one tenth of its range") {
    CHECK(read_line("a \"A\" 1 0 5").step == 0.5);
    CHECK(read_line("a \"A\" 1 0 5 // 0.1").step == 0.5);
    CHECK(read_line("a \"A\" 1 0 5 0").step == 0.0);
}

TEST_CASE("a number in a slang file is parsed from its start") {
    CHECK(leading_number("1.0;") == 1.0);
    CHECK(leading_number(" -2 ") == -2.0);
    CHECK(leading_number("0'.000000") == 0.0);
    CHECK(leading_number("2.5f") == 2.5);
    CHECK_FALSE(leading_number("").has_value());
    CHECK_FALSE(leading_number("true").has_value());
    CHECK_FALSE(leading_number("inf").has_value());
    CHECK_FALSE(leading_number("nan").has_value());
    CHECK_FALSE(leading_number("1e999").has_value());
}

TEST_CASE("text that is not UTF-8 is read as Latin-1") {
    CHECK(readable_text("plain") == "plain");
    CHECK(readable_text("\xc3\xa9") == "\xc3\xa9");                      // e acute as UTF-8
    CHECK(readable_text("\xe9") == "\xc3\xa9");                          // and as Latin-1
    CHECK(readable_text("\xe2\x82") == "\xc3\xa2\xc2\x82");              // truncated
    CHECK(readable_text("\xc0\x80") == "\xc3\x80\xc2\x80");              // overlong
    CHECK(readable_text("\xed\xa0\x80") == "\xc3\xad\xc2\xa0\xc2\x80");  // a surrogate
    CHECK(readable_text("\xf0\x9f\x8e\xae") == "\xf0\x9f\x8e\xae");
    CHECK(readable_text("\xf4\x90\x80\x80") == "\xc3\xb4\xc2\x90\xc2\x80\xc2\x80");
}
