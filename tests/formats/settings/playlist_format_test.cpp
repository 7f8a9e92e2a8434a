#include "formats/settings/playlist_format.h"

#include <doctest/doctest.h>

namespace {
std::string playlist_errors(const std::string& members) {
    const auto playlist = parse_playlist(
        "{\"format\": \"afterglow-playlist\", \"version\": 1,\n" + members + "}", "list.json");
    REQUIRE_FALSE(playlist.has_value());
    return to_string(playlist.error());
}
}  // namespace

TEST_CASE("a playlist reads back from its text") {
    const Playlist playlist{.presets = {"Amber P3", "user:mine", "/tmp/a \"b\".json"},
                            .every = 12.5,
                            .unit = Playlist::Unit::seconds,
                            .morph_seconds = 0.0,
                            .is_shuffled = true};
    CHECK(parse_playlist(playlist_to_json(playlist), "list.json") == playlist);
    CHECK(parse_playlist(playlist_to_json({}), "list.json") == Playlist{});
}

TEST_CASE("errors in a playlist are reported at their lines") {
    CHECK(playlist_errors("\"presets\": [1],\n\"every\": 0,\n\"unit\": "
                          "\"beats\",\n\"loop\": 1") ==
          "list.json:2: error: expected a text in quotes, got 1\n"
          "list.json:3: error: 'every' must be between 0.125 and 10000, got 0\n"
          "list.json:4: error: unknown value 'beats' for 'unit'; use one of: "
          "bars, seconds\n"
          "list.json:5: error: unknown key 'loop'\n");
    CHECK(playlist_errors("\"every\": 4").find("'presets' is missing") != std::string::npos);
}
