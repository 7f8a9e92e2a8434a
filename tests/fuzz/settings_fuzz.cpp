// The user's own files: session, keys, devices, playlist. The first letter of a text selects the
// file.

#include "formats/settings/keys_format.h"
#include "formats/settings/playlist_format.h"
#include "formats/settings/remote_settings_format.h"
#include "formats/settings/session_format.h"
#include "formats/settings/sound_settings_format.h"
#include "fuzz/fuzz_files.h"

namespace {
// What is read must be written so that it reads the same.
template <class Read, class Written>
void check(std::string_view text, const Read& read, const Written& written) {
    const auto first = read(text, "settings.json");
    if (!first)
        return require_reasons(first.error());
    const std::string once = written(*first);
    const auto again = read(once, "again.json");
    require(again.has_value(), "written settings can be read");
    require(written(*again) == once, "settings stay the same");
}
}  // namespace

void fuzz_one(std::string_view input) {
    if (input.empty())
        return;
    const std::string_view text = input.substr(1);
    switch (input.front()) {
        case 'k':
            return check(text, parse_keys, keys_to_json);
        case 's':
            return check(text, parse_sound_settings, sound_settings_to_json);
        case 'r':
            return check(text, parse_remote_settings, remote_settings_to_json);
        case 'l':
            return check(text, parse_playlist, playlist_to_json);
        default:
            return check(text, parse_session, session_to_json);
    }
}
