#include "formats/json/json_text.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <limits>

using Json = nlohmann::ordered_json;

TEST_CASE("a document is written with one key per line, and short lists on one line") {
    const Json document{{"b", "te\"xt"},
                        {"a", {1.0, 0.1, true}},
                        {"e", Json::object()},
                        {"o", {{"x", 1e-7}}},
                        {"l", {{{"k", 1}}, {{"k", 2}}}}};
    CHECK(
        json_text(document) ==
        "{\n  \"b\": \"te\\\"xt\",\n  \"a\": [1, 0.1, true],\n  \"e\": {},\n  \"o\": {\n    \"x\": "
        "1e-07\n"
        "  },\n  \"l\": [\n    {\n      \"k\": 1\n    },\n    {\n      \"k\": 2\n    }\n  ]\n}\n");
    CHECK(compact_json_text(document) ==
          R"({"b":"te\"xt","a":[1,0.1,true],"e":{},"o":{"x":1e-07},"l":[{"k":1},{"k":2}]})");
}

TEST_CASE(
    "numbers are written in the shortest form that parses to the same value, and are valid JSON") {
    for (const double number : {0.94, 1.0 / 3, 5e-324, 1.7976931348623157e308, -0.0, 12345678901.5})
        CHECK(Json::parse(compact_json_text(Json(number))).get<double>() == number);
    CHECK(compact_json_text(Json(0.94)) == "0.94");
    CHECK(compact_json_text(Json(3.0)) == "3");
    const double infinity = std::numeric_limits<double>::infinity();
    CHECK(compact_json_text(Json(-infinity)) == "-1.7976931348623157e+308");
    CHECK(compact_json_text(Json(infinity - infinity)) == "0");
    CHECK(compact_json_text(Json("\xff")) == "\"\xef\xbf\xbd\"");
}
