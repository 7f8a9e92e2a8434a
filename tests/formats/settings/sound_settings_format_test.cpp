#include "formats/settings/sound_settings_format.h"

#include <doctest/doctest.h>

TEST_CASE("audio settings are written and read back unchanged") {
    const SoundSettings settings{.output = "Speakers \"left\"",
                                 .input = "Monitor of Null",
                                 .rate = 96000,
                                 .buffer = 256,
                                 .picture_delay_ms = 37.5,
                                 .beam_level = 0.25};
    CHECK(parse_sound_settings(sound_settings_to_json(settings), "sound.json").value() == settings);
}

TEST_CASE("invalid audio settings are rejected with their line") {
    const auto wrong = parse_sound_settings(
        "{\n \"format\": \"afterglow-sound\", \"version\": 1,\n \"buffer\": 3\n}", "sound.json");
    REQUIRE_FALSE(wrong.has_value());
    CHECK(wrong.error().front().line == 3);
    CHECK_FALSE(parse_sound_settings("", "sound.json").has_value());
    CHECK_FALSE(parse_sound_settings("[]", "sound.json").has_value());
}
