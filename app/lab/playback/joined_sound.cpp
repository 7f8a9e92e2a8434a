#include "lab/playback/joined_sound.h"

#include "io/sound/sound_file.h"

#include <fmt/format.h>

#include <utility>

namespace {
Sound as_stereo(const Sound& mono) {
    Sound stereo{mono.rate, 2, {}};
    stereo.samples.reserve(2 * mono.samples.size());
    for (const float sample : mono.samples)
        stereo.samples.insert(stereo.samples.end(), {sample, sample});
    return stereo;
}
}  // namespace

Result<void> append_sound(Sound& sound, const Sound& next) {
    if (next.rate != sound.rate)
        return fail(
            {{},
             0,
             fmt::format(
                 "the sample rate is {} Hz, but {} Hz in the first sound. Convert one of them.",
                 next.rate, sound.rate)});
    if (sound.channels == 1 && next.channels == 2)
        sound = as_stereo(sound);
    const Sound fitted = sound.channels == 2 && next.channels == 1 ? as_stereo(next) : next;
    if (fitted.channels != sound.channels)
        return fail({{},
                     0,
                     fmt::format("the sound has {} channels, but the first sound has {}. Convert "
                                 "one of them.",
                                 next.channels, sound.channels)});
    if (sound.samples.size() + fitted.samples.size() > max_sound_samples)
        return fail({{}, 0, "is too long to join. Render the sounds separately."});
    sound.samples.insert(sound.samples.end(), fitted.samples.begin(), fitted.samples.end());
    return {};
}

Result<Sound> load_joined_sound(const std::vector<std::filesystem::path>& files,
                                Diagnostics* notes) {
    Sound joined;
    for (const std::filesystem::path& file : files) {
        auto next = load_sound(file, nullptr, notes);
        if (!next)
            return fail(next.error());
        if (joined.channels == 0) {
            joined = std::move(*next);
            continue;
        }
        if (auto done = append_sound(joined, *next); !done)
            return fail({file, 0, done.error().front().message});
    }
    return joined;
}
