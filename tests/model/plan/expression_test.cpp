#include "model/plan/expression.h"

#include <doctest/doctest.h>

namespace {
double value(const char* text) {
    const auto result = evaluate(text, {{"WIDTH", 640.0}, {"pixels_2", 3.0}});
    REQUIRE(result.has_value());
    return *result;
}

std::string problem(const std::string& text) {
    const auto result = evaluate(text, {{"WIDTH", 640.0}});
    REQUIRE_FALSE(result.has_value());
    return result.error().front().message;
}
}  // namespace

TEST_CASE("multiplication precedes addition, and both are left-associative") {
    CHECK(value("2 + 3 * 4") == 14.0);
    CHECK(value("(2 + 3) * 4") == 20.0);
    CHECK(value("10 - 4 - 3") == 3.0);
    CHECK(value("24 / 4 / 2") == 3.0);
    CHECK(value("-2 * -3") == 6.0);
    CHECK(value("7 % 4") == 3.0);
    CHECK(value("2--3") == 5.0);
}

TEST_CASE("names start with a dollar sign, and functions are followed by brackets") {
    CHECK(value("$WIDTH / 4") == 160.0);
    CHECK(value("floor($WIDTH / $pixels_2)") == 213.0);
    CHECK(value("ceil(0.1) + round(2.5) + abs(-4) + sqrt(9)") == 11.0);
    CHECK(value("max(1, 2) * min(3, 4) + pow(2, 5)") == 38.0);
    CHECK(value("finite(3) + finite(1 / 0) + finite(-1 / 0) + finite(sqrt(-1))") == 3.0);
}

TEST_CASE("a condition selects one of two values, and conditions nest") {
    CHECK(value("$WIDTH > 100 ? 10 : 20") == 10.0);
    CHECK(value("$WIDTH < 100 ? 10 : 20 + 1") == 21.0);
    CHECK(value("1 >= 1 ? 2 <= 1 ? 3 : 4 : 5") == 4.0);
    CHECK(value("0 ? 1 : 0 ? 2 : 3") == 3.0);
    CHECK(value("(3 == 3) + (3 != 3) * 4") == 1.0);
    CHECK(value("max($WIDTH > 1 ? 7 : 8, 2)") == 7.0);
    CHECK(value("$WIDTH > 0 ? 640 / $WIDTH : 1 / 0") == 1.0);
    CHECK(value("pow(2, floor(log2($WIDTH)))") == 512.0);
    CHECK(problem("1 ? 2") == "missing ':'");
    std::string chain;
    for (int i = 0; i < 10000; ++i)
        chain += "1 ? ";
    CHECK(problem(chain) == "the '? :' conditions are nested too deeply");
}

TEST_CASE("logical operators give 1 or 0, and bind like those of C") {
    CHECK(value("2 && 3") == 1.0);
    CHECK(value("2 && 0") == 0.0);
    CHECK(value("0 || 0.5") == 1.0);
    CHECK(value("0 || 0") == 0.0);
    CHECK(value("!0 + !7") == 1.0);
    CHECK(value("1 || 1 && 0") == 1.0);
    CHECK(value("(1 || 1) && 0") == 0.0);
    CHECK(value("0 == 1 || 2 > 1 ? 5 : 6") == 5.0);
    CHECK(value("!(1 > 2)") == 1.0);
}

TEST_CASE("an expression that cannot be parsed gives a specific error") {
    CHECK(problem("$HEIGHT") == "unknown name '$HEIGHT'");
    CHECK(problem("sin(1)") == "unknown function 'sin'");
    CHECK(problem("(1 + 2") == "missing ')'");
    CHECK(problem("max(1)") == "missing ','");
    CHECK(problem("1 2") == "unexpected '2'");
    CHECK(problem("") == "expected a number, a name or '('");
    CHECK(problem("1 / 0") == "'1 / 0' is not a finite number");
    CHECK(problem("$") == "unknown name '$'");
    CHECK(problem("\xff\x01") == "expected a number, a name or '('");
}

TEST_CASE("very deep nesting is an error, not a crash") {
    CHECK(problem(std::string(100000, '(')) == "the expression is nested too deeply");
    CHECK(problem(std::string(100000, '-')) == "the expression is nested too deeply");
}
