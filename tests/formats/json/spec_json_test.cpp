#include "formats/json/spec_json.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

namespace {
std::optional<Spec> read(std::string_view text, Diagnostics& problems) {
    const std::filesystem::path file = "a.json";
    return read_spec(parse_json(text, file).value(), file, problems);
}
}  // namespace

TEST_CASE("a signal is written to JSON and read back unchanged") {
    Diagnostics problems;
    const auto spec = read(R"({"kind": "lissajous", "x": 3, "y": 2})", problems);
    REQUIRE(spec.has_value());
    CHECK(*spec == Spec{"lissajous", {{"x", 3.0}, {"y", 2.0}}});
    CHECK(json_of(*spec).dump() == R"({"kind":"lissajous","x":3.0,"y":2.0})");
    CHECK(problems.empty());
}

TEST_CASE("unknown signals and settings are errors at their lines") {
    Diagnostics problems;
    CHECK_FALSE(read("\n{\"kind\": \"lissajos\"}", problems).has_value());
    CHECK_FALSE(read("\n\n{\"kind\": \"lissajous\", \"q\": 1}", problems).has_value());
    CHECK_FALSE(read("\n\n\n{\"kind\": \"lissajous\", \"x\": []}", problems).has_value());
    CHECK_FALSE(read("\n\n\n\n3", problems).has_value());
    REQUIRE(problems.size() == 4);
    for (int i = 0; i < 4; ++i)
        CHECK(problems[static_cast<std::size_t>(i)].line == i + 2);
    CHECK(problems[0].message.find("'lissajous'") != std::string::npos);
}
