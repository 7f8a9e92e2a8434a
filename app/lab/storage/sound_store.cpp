#include "lab/storage/sound_store.h"

#include "base/file.h"
#include "formats/settings/sound_settings_format.h"
#include "io/files/atomic_file.h"

namespace {
std::filesystem::path sound_file_in(const Roots& roots) {
    return roots.state / "sound.json";
}
}  // namespace

Result<SoundSettings> load_sound_settings(const Roots& roots) {
    const std::filesystem::path file = sound_file_in(roots);
    std::error_code error;
    if (!std::filesystem::exists(file, error))
        return SoundSettings{};
    const auto text = read_text(file);
    if (!text)
        return fail(text.error());
    return parse_sound_settings(*text, file);
}

Result<void> save_sound_settings(const Roots& roots, const SoundSettings& settings) {
    return write_atomically(sound_file_in(roots), sound_settings_to_json(settings));
}
