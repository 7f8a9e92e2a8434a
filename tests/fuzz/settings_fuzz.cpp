// The user's own files: session, keys, devices, playlist. The first letter of a text selects the
// file.

#include "formats/settings/keys_format.h"
#include "formats/settings/playlist_format.h"
#include "formats/settings/remote_settings_format.h"
#include "formats/settings/session_format.h"
#include "formats/settings/sound_settings_format.h"
#include "fuzz/fuzz_files.h"

void fuzz_one(std::string_view input) {
    if (input.empty())
        return;
    const std::string_view text = input.substr(1);
    switch (input.front()) {
        case 'k':
            return require_round_trip(text, parse_keys, keys_to_json);
        case 's':
            return require_round_trip(text, parse_sound_settings, sound_settings_to_json);
        case 'r':
            return require_round_trip(text, parse_remote_settings, remote_settings_to_json);
        case 'l':
            return require_round_trip(text, parse_playlist, playlist_to_json);
        default:
            return require_round_trip(text, parse_session, session_to_json);
    }
}
