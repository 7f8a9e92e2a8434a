#include "formats/json/value_json.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using Json = nlohmann::ordered_json;

TEST_CASE("a value is written as a number, a list or a path") {
    CHECK(json_of(Value(2.5)) == Json(2.5));
    CHECK(json_of(Value({1.0, 2.0})) == Json({1.0, 2.0}));
    CHECK(json_of(Value::of_path("a/b.png")) == Json("a/b.png"));
}

TEST_CASE("a switch is written as true or false") {
    Parameter parameter;
    parameter.type = {Scalar::boolean};
    CHECK(json_of(Value(1.0), &parameter) == Json(true));
    CHECK(json_of(Value({0.0, 2.0}), &parameter) == Json({false, true}));
    parameter.type = {Scalar::integer};
    CHECK(json_of(Value(1.0), &parameter).is_number());
}

TEST_CASE("an invalid value is an error at its line") {
    const std::filesystem::path file = "a.json";
    const JsonValue document =
        parse_json("{\"n\": 1, \"b\": true, \"l\": [1, false], \"t\": \"x\",\n\"bad\": [[1]]}",
                   file)
            .value();
    Diagnostics problems;
    ObjectReader reader(document, file, problems);
    CHECK(read_value(*reader.find("n"), reader) == Value(1.0));
    CHECK(read_value(*reader.find("b"), reader) == Value(1.0));
    CHECK(read_value(*reader.find("l"), reader) == Value({1.0, 0.0}));
    CHECK(read_value(*reader.find("t"), reader) == Value::of_path("x"));
    CHECK_FALSE(read_value(*reader.find("bad"), reader).has_value());
    CHECK(to_string(problems).starts_with("a.json:2: error: 'bad' must be a number"));
}
