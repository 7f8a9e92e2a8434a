#include "formats/json/json_document.h"

#include <doctest/doctest.h>

#include <random>

namespace {
using Kind = JsonValue::Kind;

JsonValue parsed(std::string_view text) {
    auto value = parse_json(text, "a.json");
    REQUIRE(value.has_value());
    return std::move(*value);
}

std::string json_error(std::string_view text) {
    const auto value = parse_json(text, "a.json");
    REQUIRE_FALSE(value.has_value());
    REQUIRE(value.error().size() == 1);
    return to_string(value.error().front());
}

// Parsing the bytes of each value gives the same value; its line is that of its first byte.
void check_locations(const JsonValue& value, std::string_view text) {
    const std::string_view own = text.substr(value.begin, value.end - value.begin);
    const JsonValue again = parsed(own);
    CHECK(again.kind == value.kind);
    CHECK(again.number == value.number);
    CHECK(again.text == value.text);
    CHECK(again.children.size() == value.children.size());
    CHECK(again.end == own.size());
    const std::string_view before = text.substr(0, value.key_begin);
    CHECK(value.line == 1 + std::count(before.begin(), before.end(), '\n'));
    if (!value.key.empty())
        CHECK(text.substr(value.key_begin + 1, value.key.size()) == value.key);
    for (const JsonValue& child : value.children)
        check_locations(child, text);
}
}  // namespace

TEST_CASE("a document is parsed with kinds, keys and order") {
    const JsonValue root = parsed(R"({"b": [1, -2.5e1, true, null], "a": {"x": "té\n"}})");
    REQUIRE(root.is(Kind::object));
    REQUIRE(root.children.size() == 2);
    CHECK(root.children[0].key == "b");
    const JsonValue& list = root.children[0];
    REQUIRE(list.children.size() == 4);
    CHECK(list.children[1].number == -25.0);
    CHECK(list.children[2].boolean);
    CHECK(list.children[3].is(Kind::null));
    const JsonValue* object = find_member(root, "a");
    REQUIRE(object);
    CHECK(find_member(*object, "x")->text == "t\xc3\xa9\n");
    CHECK(find_member(root, "x") == nullptr);
    CHECK(find_member(list, "x") == nullptr);
}

TEST_CASE("every value has its line and byte range") {
    const std::string text =
        "\n{ \"format\" : 1e3\t,\n  \"list\": [ 12,3\n,4.5 ,\n\n-6],\"none\":[],\r\n"
        " \"o\":{\"t\":\"a\\\"b,:\"\n}  , \"nested\": [[1],\n[2,{\"k\":null}]],\"last\":7}\n\n";
    check_locations(parsed(text), text);
    check_locations(parsed("12"), "12");
    check_locations(parsed("  -0.5 "), "  -0.5 ");
    const JsonValue root = parsed(text);
    CHECK(find_member(root, "format")->line == 2);
    CHECK(find_member(root, "list")->line == 3);
    CHECK(find_member(root, "list")->children[3].line == 6);
    CHECK(find_member(root, "last")->line == 9);
}

TEST_CASE("errors are reported at their line, without internal names of the parser") {
    CHECK(json_error("{\n  \"a\": 1,\n  \"b\" 2\n}") ==
          "a.json:3: error: invalid JSON: unexpected number literal; expected ':'");
    CHECK(json_error("{\n  \"a\": 1,\n}\n") ==
          "a.json:3: error: invalid JSON: unexpected '}'; expected string literal");
    CHECK(json_error("{\n  \"a\": 1\n\n\n")
              .starts_with("a.json:2: error: invalid JSON: unexpected end of input"));
    CHECK(json_error("[1]\n]") ==
          "a.json:2: error: invalid JSON: unexpected ']'; expected end of input");
    CHECK(json_error("[1,\nnan]").starts_with("a.json:2: error: invalid JSON: "));
    CHECK(json_error("[\"\xff\"]").starts_with("a.json:1: error: invalid JSON: "));
    CHECK(json_error("[1,\n1e999]") == "a.json:2: error: the number is too large");
    CHECK(json_error("") == "a.json:1: error: the file is empty");
    CHECK(json_error(" \n ") == "a.json:1: error: the file is empty");
    CHECK(json_error("{\"a\": 1,\n\"b\": {\"a\": 2},\n\"a\": 3}") ==
          "a.json:3: error: duplicate key 'a'");
}

TEST_CASE("the last of duplicate keys counts if that is allowed") {
    const auto json = parse_json("{\"a\": 1, \"b\": {\"c\": 2, \"c\": 3}, \"a\": 4}", "a.json",
                                 DuplicateKeys::last_wins);
    REQUIRE(json.has_value());
    CHECK(json->children.size() == 2);
    CHECK(find_member(*json, "a")->number == 4.0);
    CHECK(find_member(*find_member(*json, "b"), "c")->number == 3.0);
}

TEST_CASE("depth, number of values and size are limited") {
    const auto nested = [](std::size_t depth) {
        return std::string(depth, '[') + std::string(depth, ']');
    };
    CHECK(parse_json(nested(128), "a.json").has_value());
    CHECK(json_error(nested(129)) == "a.json:1: error: nested too deeply; the limit is 128 levels");
    CHECK(json_error(nested(1000000)) ==
          "a.json:1: error: nested too deeply; the limit is 128 levels");
    std::string many = "[0";
    for (int i = 0; i < 1000001; ++i)
        many += ",0";
    CHECK(json_error(many + "]") == "a.json:1: error: too many values; the limit is 1000000");
    CHECK(json_error(std::string((std::size_t{16} << 20) + 1, ' '))
              .starts_with("a.json: error: the text is too large"));
}

TEST_CASE("a truncated or randomly changed document is parsed or rejected with file and line") {
    const std::string text =
        "{\n  \"format\": \"x\",\n  \"list\": [1, -2.5, true, null, \"\\u00e9\"],\n  \"o\": "
        "{\"k\": {}}\n}\n";
    for (std::size_t size = 0; size + 2 < text.size(); ++size) {
        const auto value = parse_json(std::string_view(text).substr(0, size), "a.json");
        REQUIRE_FALSE(value.has_value());
        CHECK(value.error().front().line >= 1);
    }
    std::mt19937 random(99);
    for (int trial = 0; trial < 20000; ++trial) {
        std::string damaged = text;
        for (int change = 0; change < 1 + trial % 3; ++change)
            damaged[random() % damaged.size()] = static_cast<char>(random());
        const auto value = parse_json(damaged, "a.json");
        if (value)
            check_locations(*value, damaged);
        else
            CHECK((value.error().front().line >= 1 && value.error().front().line <= 9));
    }
}
