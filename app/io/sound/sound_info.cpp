#include "io/sound/sound_info.h"

#include <sndfile.h>

Result<SoundInfo> load_sound_info(const std::filesystem::path& file) {
    SF_INFO info = {};
    SNDFILE* opened = sf_open(file.c_str(), SFM_READ, &info);
    if (!opened)
        return fail({file, 0, sf_strerror(nullptr)});
    sf_close(opened);
    const bool has_length = info.frames > 0 && info.frames < SF_COUNT_MAX && info.samplerate > 0;
    return SoundInfo{has_length ? static_cast<double>(info.frames) / info.samplerate : 0.0,
                     info.samplerate, info.channels};
}
