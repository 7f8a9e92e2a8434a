#include "formats/fragment/varyings.h"
#include "formats/glsl/modern_glsl.h"
#include "formats/isf/header.h"
#include "formats/json/json_document.h"
#include "glsl/text/include.h"
#include "in_a_moment.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

TEST_CASE("very many duplicate keys are parsed fast") {
    std::string text = "{";
    for (int i = 0; i < 80'000; ++i)
        text += fmt::format("\"k{}\": 1, \"a\": {},\n", i, i);
    text += "\"end\": 0}";
    std::optional<JsonValue> read;
    CHECK(is_done_in_a_moment([&] {
        if (auto value = parse_json(text, "a.json", DuplicateKeys::last_wins))
            read = std::move(*value);
    }));
    REQUIRE(read.has_value());
    CHECK(read->children.size() == 80'002);
    CHECK(find_member(*read, "a")->number == 79'999.0);
    const auto refused = parse_json(text, "a.json");
    REQUIRE_FALSE(refused.has_value());
    CHECK(refused.error().size() == 257);
}

TEST_CASE("a free name is searched once for all occurrences of a word") {
    std::string text = "sample_ sample_x ";
    for (int i = 2; i < 20'000; ++i)
        text += fmt::format("sample_x{} ", i);
    std::string modern;
    CHECK(is_done_in_a_moment([&] { modern = modern_glsl(text + times(200'000, "sample ")); }));
    CHECK((modern == text + times(200'000, "sample_x20000 ")));
}

TEST_CASE("very many varyings are found fast, each once") {
    std::string names;
    for (int i = 0; i < 300'000; ++i)
        names += fmt::format(", a{}", i);
    std::vector<FragmentVarying> found;
    CHECK(is_done_in_a_moment([&] { found = find_varyings("varying vec2 a0" + names + ";"); }));
    CHECK(found.size() == 300'000);
    const std::string odd = "varying vec2 " + times(300'000, "a ") + "b" + times(300'000, ", b");
    CHECK(is_done_in_a_moment([&] { found = find_varyings(odd + ";"); }));
    CHECK(found.size() == 2);
    Diagnostics warnings;
    vertex_stage_for(std::vector(5000, FragmentVarying{"mat3", "m"}), builtin_stage("\n"),
                     warnings);
    CHECK(warnings.size() == 1);
}

TEST_CASE("the numbers of passes, inputs, values and imports in an ISF header are limited") {
    const auto refusal = [](const std::string& json) {
        const auto header = read_isf_header("/*{\n" + json + "}*/\n", "a.fs");
        return header ? std::string() : to_string(header.error());
    };
    const auto inputs = [](int count) {
        std::string all;
        for (int i = 0; i < count; ++i)
            all += fmt::format("{}{{\"NAME\": \"i{}\", \"TYPE\": \"float\"}}", i ? "," : "", i);
        return "\"INPUTS\": [" + all + "]";
    };
    CHECK(refusal("\"PASSES\": [" + times(63, "{},") + "{}]") == "");
    CHECK(refusal("\"PASSES\": [" + times(64, "{},") + "\n{}]") ==
          "a.fs:3: error: the header has 65 passes; the limit is 64\n");
    CHECK(refusal(inputs(1024)) == "");
    CHECK(refusal(inputs(1025)) ==
          "a.fs:2: error: the header has 1025 inputs; the limit is 1024\n");
    CHECK(refusal("\"IMPORTED\": [" + times(64, "{},") + "{}]") ==
          "a.fs:2: error: the header imports 65 pictures; the limit is 64\n");
    CHECK(refusal("\"INPUTS\": [{\"NAME\": \"a\", \"TYPE\": \"long\", \"VALUES\": [" +
                  times(1024, "0,") + "0]}]") ==
          "a.fs:2: error: 'VALUES' has 1025 numbers; the limit is 1024\n");
}

TEST_CASE("a number out of range for GLSL is an error at its line") {
    const auto refusal = [](const std::string& type, const std::string& number) {
        const auto header = read_isf_header("/*{\"INPUTS\": [{\"NAME\": \"a\", \"TYPE\": \"" +
                                                type + "\",\n\"MAX\": " + number + "}]}*/\n",
                                            "a.fs");
        return header ? std::string() : to_string(header.error());
    };
    CHECK(refusal("float", "3e38") == "");
    CHECK(refusal("float", "4e38") == "a.fs:2: error: 4e+38 is out of range for a GLSL float\n");
    CHECK(refusal("float", "1e999") == "a.fs:2: error: the number is too large\n");
    CHECK(refusal("long", "2147483647") == "");
    CHECK(refusal("long", "2147483648") ==
          "a.fs:2: error: 2147483648 is out of range for a GLSL int\n");
}
