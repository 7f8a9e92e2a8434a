#include "base/file.h"
#include "formats/preset/media_format.h"
#include "formats/settings/keys_format.h"
#include "formats/settings/playlist_format.h"
#include "formats/settings/remote_settings_format.h"
#include "formats/settings/session_format.h"
#include "formats/settings/sound_settings_format.h"

#include <doctest/doctest.h>

namespace fs = std::filesystem;

TEST_CASE("settings that earlier versions wrote are read") {
    int versions = 0;
    for (const auto& version :
         fs::directory_iterator(AFTERGLOW_SOURCE_DIR "/tests/inputs/versions")) {
        CAPTURE(version.path());
        ++versions;
        const auto text = [&](const char* name) {
            return read_text(version.path() / name).value();
        };
        const auto keys = parse_keys(text("keys.json"), "keys.json");
        REQUIRE(keys.has_value());
        CHECK(keys->front().key == "Ctrl+K");
        const auto playlist = parse_playlist(text("playlist.json"), "playlist.json");
        REQUIRE(playlist.has_value());
        CHECK(playlist->presets.size() == 2);
        CHECK(playlist->is_shuffled);
        const auto remote = parse_remote_settings(text("remote.json"), "remote.json");
        REQUIRE(remote.has_value());
        CHECK(remote->osc_port == 9100);
        const auto sound = parse_sound_settings(text("sound.json"), "sound.json");
        REQUIRE(sound.has_value());
        CHECK(sound->rate == 96000);
        const auto media = parse_media(text("media.json"), "media.json");
        REQUIRE(media.has_value());
        CHECK(media->front().digest == "1a2b3c4d");
        const auto session = parse_session(text("session.json"), "session.json");
        REQUIRE(session.has_value());
        CHECK(session->current.preset.look == "phosphor");
    }
    CHECK(versions > 0);
}
