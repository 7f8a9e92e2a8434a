#include "formats/effect/global_values.h"

#include <doctest/doctest.h>

namespace {
struct Taken {
    std::string text;
    std::string settings;
    bool operator==(const Taken&) const = default;
};

Taken taken(std::string text, std::set<std::string, std::less<>> late) {
    std::string settings = take_late_values(text, std::move(late));
    return {text, settings};
}
}  // namespace

TEST_CASE("values of global variables that depend on a uniform are set later") {
    CHECK(taken("float ratio = size.x /\n size.y;\n", {"size"}) ==
          Taken{"float ratio           \n       ;\n", "    ratio = size.x /\n size.y;\n"});
    CHECK(taken("const vec2 a[2] = vec2[2](size, size), b = vec2(1.0);", {"size"}) ==
          Taken{"      vec2 a[2]                      , b            ;",
                "    a = vec2[2](size, size);\n    b = vec2(1.0);\n"});
}

TEST_CASE("other variables, functions and macros can depend on it") {
    const std::string text =
        "#define HALF (size * 0.5)\n"
        "float area(vec2 of) { float now = size.x; return of.x * now; }\n"
        "vec2 a = HALF; float b = area(vec2(1.0)), c = 2.0; vec2 d = a;\n";
    CHECK(taken(text, {"size"}).settings ==
          "    a = HALF;\n    b = area(vec2(1.0));\n    c = 2.0;\n    d = a;\n");
}

TEST_CASE("constant values, locals and functions stay") {
    const std::string text =
        "const float pi = 3.14; float a[2] = {1.0, 2.0}; struct S { float x; } s;\n"
        "void main() { float size_now = size; if (size > 1.0) { a[0] = size; } }\n";
    CHECK(taken(text, {"size"}) == Taken{text, ""});
}
