// Edits of the list of passes. The expected texts are written by hand.
#include "formats/look/pass_edit.h"

#include "problems_of.h"

#include <doctest/doctest.h>

namespace {
const std::string chain = R"({ "format": "afterglow-look",  "version": 1,
  "passes": [
    { "name": "beam",   "fragment": "beam.frag", "format": "rgba32f", "scale": 0.5 },
    { "name": "glow", "fragment": "blur.frag", "inputs": { "image": "beam", "previous": "glow@1" } },
    {
      "name": "last", "fragment": "last.frag",
      "inputs": {
        "sharp": { "from": "beam", "filter": "nearest" },
        "soft": { "wrap": "border", "from": "glow" },
        "before": "glow@2"
      }
    }
  ] }
)";

std::string replaced(std::string text, std::string_view before, std::string_view after) {
    const std::size_t at = text.find(before);
    REQUIRE(at != std::string::npos);
    REQUIRE(text.find(before, at + 1) == std::string::npos);
    return text.replace(at, before.size(), after);
}

std::string error_of(const Result<PassEdit>& edit) {
    REQUIRE_FALSE(edit.has_value());
    return to_string(edit.error().front());
}
}  // namespace

TEST_CASE("an added pass reads the one before it, and later passes read the added one") {
    const auto edit = with_pass_added(chain, {"tint", "tint.frag", "beam"}, "look.json");
    REQUIRE_MESSAGE(edit.has_value(), problems_of(edit));
    std::string expected = replaced(
        chain, "\"scale\": 0.5 },\n",
        "\"scale\": 0.5 },\n    { \"name\": \"tint\", \"fragment\": \"tint.frag\", "
        "\"scale\": 0.5, \"format\": \"rgba32f\", \"inputs\": { \"image\": \"beam\" } },\n");
    expected = replaced(expected, "{ \"image\": \"beam\", \"previous\"",
                        "{ \"image\": \"tint\", \"previous\"");
    expected =
        replaced(expected, "{ \"from\": \"beam\", \"filter\"", "{ \"from\": \"tint\", \"filter\"");
    CHECK(edit->text == expected);
    CHECK(edit->rewired == std::vector<std::string>{"glow", "last"});
}

TEST_CASE("earlier frames of a pass are still read from it after a pass was added") {
    const auto edit = with_pass_added(chain, {"tint", "tint.frag", "glow"}, "look.json");
    REQUIRE(edit.has_value());
    CHECK(edit->text.find("\"before\": \"glow@2\"") != std::string::npos);
    CHECK(edit->text.find("\"previous\": \"glow@1\"") != std::string::npos);
    CHECK(edit->text.find("\"from\": \"tint\"") != std::string::npos);
}

TEST_CASE("a pass added at the end becomes the picture") {
    const auto edit = with_pass_added(chain, {"tint", "tint.frag", "last"}, "look.json");
    REQUIRE(edit.has_value());
    CHECK(edit->text == replaced(chain, "    }\n  ] }",
                                 "    },\n    { \"name\": \"tint\", \"fragment\": \"tint.frag\", "
                                 "\"inputs\": { \"image\": \"last\" } }\n  ] }"));
    CHECK(edit->rewired.empty());
}

TEST_CASE("a single pass on its own line gets a successor on the next line") {
    const std::string text =
        "{ \"passes\": [\n    { \"name\": \"a\", \"fragment\": \"a.frag\" }\n]}";
    const auto edit = with_pass_added(text, {"b", "b.frag", "a"}, "look.json");
    REQUIRE(edit.has_value());
    CHECK(edit->text ==
          "{ \"passes\": [\n    { \"name\": \"a\", \"fragment\": \"a.frag\" },\n    "
          "{ \"name\": \"b\", \"fragment\": \"b.frag\", \"inputs\": { \"image\": \"a\" "
          "} }\n]}");
}

TEST_CASE(
    "a pass is not added under an invalid or taken name, or where its input can't be copied") {
    const auto add = [](const std::string& text, const char* name, const char* after) {
        return error_of(with_pass_added(text, {name, "x.frag", after}, "look.json"));
    };
    CHECK(add(chain, "glow", "beam") == "look.json: error: the name 'glow' is already used");
    CHECK(add(chain, "a b", "beam").starts_with("look.json: error: 'a b' can't be the name"));
    CHECK(add(chain, "source", "beam").starts_with("look.json: error: 'source' can't be"));
    CHECK(add(chain, "tint", "none") == "look.json:2: error: pass 'none' is missing");
    CHECK(add(replaced(chain, "rgba32f", "r32i"), "tint", "beam")
              .starts_with("look.json:3: error: 'beam' has an integer format"));
    CHECK(add(replaced(chain, "\"scale\": 0.5", "\"onto\": { \"pass\": \"glow\" }"), "tint",
              "beam") ==
          "look.json:3: error: 'beam' is drawn onto 'glow'. Add the pass after 'glow'.");
}

TEST_CASE("readers of a removed pass read its first input, as many frames ago") {
    const auto edit = with_pass_removed(chain, "glow", "look.json");
    REQUIRE_MESSAGE(edit.has_value(), problems_of(edit));
    std::string expected = replaced(
        chain,
        ",\n    { \"name\": \"glow\", \"fragment\": \"blur.frag\", \"inputs\": { \"image\": "
        "\"beam\", \"previous\": \"glow@1\" } }",
        "");
    expected = replaced(expected, "\"from\": \"glow\"", "\"from\": \"beam\"");
    expected = replaced(expected, "\"glow@2\"", "\"beam@2\"");
    CHECK(edit->text == expected);
    CHECK(edit->rewired == std::vector<std::string>{"last"});
    CHECK(edit->unused_shaders == std::vector<std::string>{"blur.frag"});
}

TEST_CASE("a shader that another pass uses stays") {
    const auto edit =
        with_pass_removed(replaced(chain, "last.frag", "blur.frag"), "glow", "look.json");
    REQUIRE(edit.has_value());
    CHECK(edit->unused_shaders.empty());
}

TEST_CASE("an image that takes the place of a pass has no earlier frames") {
    const std::string text = R"({ "images": { "card": "card.png" }, "passes": [
  { "name": "a", "fragment": "a.frag", "inputs": { "x": "card" } },
  { "name": "b", "fragment": "b.frag", "inputs": { "x": "a@3" } } ] })";
    const auto edit = with_pass_removed(text, "a", "look.json");
    REQUIRE(edit.has_value());
    CHECK(edit->text == R"({ "images": { "card": "card.png" }, "passes": [
  { "name": "b", "fragment": "b.frag", "inputs": { "x": "card" } } ] })");
}

TEST_CASE("a pass without inputs that others read, a host and the only pass are not removed") {
    CHECK(error_of(with_pass_removed(chain, "beam", "look.json")) ==
          "look.json:4: error: 'glow' reads 'beam', and 'beam' has no input that could take its "
          "place. Give 'glow' another input first.");
    CHECK(error_of(with_pass_removed(
              replaced(chain, "\"scale\": 0.5", "\"onto\": { \"pass\": \"glow\" }"), "glow",
              "look.json")) ==
          "look.json:3: error: 'beam' is drawn onto 'glow'. Remove 'onto' from "
          "'beam' first.");
    CHECK(error_of(with_pass_removed(R"({ "passes": [ { "name": "a" } ] })", "a", "look.json")) ==
          "look.json:1: error: 'a' is the only pass, and a look needs one");
    CHECK(error_of(with_pass_removed("{ \"passes\": 3 }", "a", "look.json")) ==
          "look.json: error: the list 'passes' is missing");
}

TEST_CASE("moving a pass swaps it with its neighbour in the chain") {
    const std::string text = R"({ "passes": [
  { "name": "a", "fragment": "a.frag", "inputs": { "x": "source" } },
  { "name": "b", "fragment": "b.frag", "inputs": { "x": "a", "y": "source@1", "z": "b@1" } },
  { "name": "c", "fragment": "c.frag", "inputs": { "x": "b", "y": { "from": "a" } } }
] })";
    const std::string swapped = R"({ "passes": [
  { "name": "b", "fragment": "b.frag", "inputs": { "x": "source", "y": "source@1", "z": "b@1" } },
  { "name": "a", "fragment": "a.frag", "inputs": { "x": "b" } },
  { "name": "c", "fragment": "c.frag", "inputs": { "x": "a", "y": { "from": "b" } } }
] })";
    const auto later = with_pass_moved(text, "a", PassMove::later, "look.json");
    REQUIRE_MESSAGE(later.has_value(), problems_of(later));
    CHECK(later->text == swapped);
    const auto earlier = with_pass_moved(text, "b", PassMove::earlier, "look.json");
    REQUIRE(earlier.has_value());
    CHECK(earlier->text == swapped);
    const auto back = with_pass_moved(swapped, "a", PassMove::earlier, "look.json");
    REQUIRE(back.has_value());
    CHECK(back->text == text);
}

TEST_CASE("passes that don't read each other are exchanged as they are") {
    const std::string text =
        R"({ "passes": [ { "name": "a" }, { "name": "b", "inputs": { "x": "a@1" } }, { "name": "c" } ] })";
    const auto edit = with_pass_moved(text, "b", PassMove::earlier, "look.json");
    REQUIRE(edit.has_value());
    CHECK(
        edit->text ==
        R"({ "passes": [ { "name": "b", "inputs": { "x": "a@1" } }, { "name": "a" }, { "name": "c" } ] })");
    CHECK(edit->rewired.empty());
}

TEST_CASE("a pass is not moved past the ends, or before a pass that has nothing to exchange") {
    CHECK(error_of(with_pass_moved(chain, "beam", PassMove::earlier, "look.json")) ==
          "look.json:3: error: 'beam' is already the first pass");
    CHECK(error_of(with_pass_moved(chain, "last", PassMove::later, "look.json")) ==
          "look.json:5: error: 'last' is already the last pass");
    CHECK(error_of(with_pass_moved(chain, "glow", PassMove::earlier, "look.json")) ==
          "look.json:4: error: 'glow' reads 'beam', which has no input. It must stay after it.");
}

TEST_CASE("a renamed look keeps all other bytes") {
    const auto text =
        with_look_named(R"({ "name": "Old",  "about": "text", "passes": [] })", "New", "look.json");
    REQUIRE(text.has_value());
    CHECK(*text == R"({ "name": "New",  "about": "", "passes": [] })");
}
