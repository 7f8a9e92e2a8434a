#include "formats/look/manifest_edit.h"

#include "io/temporary_folder.h"

#include <doctest/doctest.h>

namespace {
const std::string edited_manifest = R"({ "format": "afterglow-look",  "version": 1,
  "passes": [
    { "name": "beam",   "format": "rgba16f", "blend": "add" },
    { "name": "glow", "scale": 0.5, "scale_of": "source", "inputs": { "current": "beam", "previous": "glow@1" } },
    {
      "name": "last",
      "size": [320, "$HEIGHT"],
      "inputs": {
        "a": { "from": "glow",  "wrap": "repeat" },
        "b": { "filter": "linear", "from": "beam" }
      }
    }
  ] }
)";

std::string edited(const PassOverrides& overrides) {
    const auto text = with_overrides_written(edited_manifest, overrides, "look.json");
    REQUIRE(text.has_value());
    return *text;
}

// The manifest with one replacement. `before` must occur exactly once.
std::string with(std::string text, std::string_view before, std::string_view after) {
    const std::size_t at = text.find(before);
    REQUIRE(at != std::string::npos);
    REQUIRE(text.find(before, at + 1) == std::string::npos);
    return text.replace(at, before.size(), after);
}
}  // namespace

TEST_CASE("a manifest without changes keeps every byte") {
    CHECK(edited({}) == edited_manifest);
    CHECK(edited({{"beam", {}}, {"not there", {}}}) == edited_manifest);
}

TEST_CASE("an existing format is replaced, and a missing one is added") {
    CHECK(edited({{"beam", {Format::rgba32f, {}, {}}}}) ==
          with(edited_manifest, "\"format\": \"rgba16f\"", "\"format\": \"rgba32f\""));
    CHECK(edited({{"glow", {Format::r8, {}, {}}}}) ==
          with(edited_manifest, "\"glow@1\" } }", "\"glow@1\" }, \"format\": \"r8\" }"));
    CHECK(edited({{"last", {Format::r8, {}, {}}}}) ==
          with(edited_manifest, "\"from\": \"beam\" }\n      }",
               "\"from\": \"beam\" }\n      },\n      \"format\": \"r8\""));
}

TEST_CASE("a scale replaces the previous size") {
    CHECK(edited({{"beam", {{}, 0.25, {}}}}) ==
          with(edited_manifest, "\"blend\": \"add\" }", "\"blend\": \"add\", \"scale\": 0.25 }"));
    CHECK(edited({{"glow", {{}, 2.0, {}}}}) == with(edited_manifest,
                                                    "\"scale\": 0.5, \"scale_of\": \"source\"",
                                                    "\"scale\": 2, \"scale_of\": \"viewport\""));
    CHECK(edited({{"last", {{}, 0.5, {}}}}) ==
          with(edited_manifest, "\"size\": [320, \"$HEIGHT\"]", "\"scale\": 0.5"));
}

TEST_CASE("a filter is written into every input that reads the pass") {
    CHECK(edited({{"beam", {{}, {}, Filter::nearest}}}) ==
          with(with(edited_manifest, "\"current\": \"beam\"",
                    "\"current\": { \"from\": \"beam\", \"filter\": \"nearest\" }"),
               "\"filter\": \"linear\"", "\"filter\": \"nearest\""));
    CHECK(edited({{"glow", {{}, {}, Filter::nearest}}}) ==
          with(with(edited_manifest, "\"glow@1\"",
                    "{ \"from\": \"glow@1\", \"filter\": \"nearest\" }"),
               "\"wrap\": \"repeat\" }", "\"wrap\": \"repeat\",  \"filter\": \"nearest\" }"));
}

TEST_CASE("several changes are written together") {
    const std::string text =
        edited({{"beam", {Format::r8, 0.5, Filter::nearest}}, {"last", {Format::rgba8, 1.0, {}}}});
    for (const char* part :
         {"\"format\": \"r8\", \"blend\": \"add\", \"scale\": 0.5 }", "\"scale\": 1,",
          "\"format\": \"rgba8\"", "\"filter\": \"nearest\", \"from\": \"beam\""})
        CHECK(text.find(part) != std::string::npos);
    // Writing the same changes again changes nothing.
    const auto again = with_overrides_written(
        text, {{"beam", {Format::r8, 0.5, Filter::nearest}}, {"last", {Format::rgba8, 1.0, {}}}},
        "look.json");
    CHECK(again == text);
}

TEST_CASE("an edit that cannot be written is an error") {
    const auto error_of = [](std::string_view text, const PassOverrides& overrides) {
        const auto result = with_overrides_written(text, overrides, "look.json");
        REQUIRE_FALSE(result.has_value());
        return to_string(result.error().front());
    };
    CHECK(error_of(edited_manifest, {{"baem", {Format::r8, {}, {}}}}) ==
          "look.json:2: error: can't save the pass settings: pass 'baem' is missing");
    CHECK(error_of("{}", {}) ==
          "look.json: error: can't save the pass settings: the list 'passes' is missing");
    CHECK(error_of("{", {}).starts_with("look.json:1: error: invalid JSON"));
    CHECK(with_overrides_written(R"({"passes": [1, {"name": 2, "inputs": 3}, {"inputs": [4]}]})",
                                 {}, "look.json")
              .has_value());
}

TEST_CASE("a file is edited in place, and its byte order mark and line ends stay") {
    const TemporaryFolder folder;
    const std::string text = "\xef\xbb\xbf{\"passes\": [\r\n{\"name\": \"a\"}]}\r\n";
    const auto file = folder.write("look.json", text);
    REQUIRE(write_overrides(file, {{"a", {Format::r8, {}, {}}}}));
    CHECK(content_of(file) ==
          "\xef\xbb\xbf{\"passes\": [\r\n{\"name\": \"a\", \"format\": \"r8\"}]}\r\n");
    CHECK_FALSE(write_overrides(folder / "none.json", {}).has_value());
}

TEST_CASE("a manifest that is a link to outside the look's folder is not written") {
    const TemporaryFolder folder;
    const std::string text = R"({"passes": [{"name": "a"}]})";
    const auto outside = folder.write("store/look.json", text);
    std::filesystem::create_directory(folder / "look");
    std::filesystem::create_symlink(outside, folder / "look/look.json");
    const auto written = write_overrides(folder / "look/look.json", {{"a", {Format::r8, {}, {}}}});
    REQUIRE_FALSE(written.has_value());
    CHECK(written.error().front().message.find("outside the look's folder") != std::string::npos);
    CHECK(content_of(outside) == text);
}
