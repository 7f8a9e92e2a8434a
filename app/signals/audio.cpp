#include "signals/audio.h"

#include "base/text.h"
#include "signals/settings.h"
#include "signals/sound_scope.h"

#include <cmath>

namespace {
SoundChannels channels_of(const Settings& settings) {
    if (settings.is("mode", "xy") || settings.is("channel", "both"))
        return SoundChannels::both;
    if (settings.is("channel", "mean"))
        return SoundChannels::mean;
    return settings.is("channel", "left") ? SoundChannels::left : SoundChannels::right;
}

SoundPlug plug_of(const Settings& settings, const ScopeKnobs& knobs) {
    return {.channels = channels_of(settings),
            .is_swapped = knobs.is_swapped,
            .coupling = {knobs.channels[0].coupling, knobs.channels[1].coupling},
            .level = settings.number("level"),
            .has_auto_gain = settings.is("auto_gain", "on"),
            .upsample = settings.whole("upsample")};
}

Result<std::unique_ptr<Signal>> make_audio(const Settings& settings, const SignalMedia& media) {
    const auto& sound = media.sound;
    if (!sound || sound->rate <= 0 || sound->frame_count() == 0)
        return fail({{}, 0, "audio: there is no sound to show"});
    const double start = std::round(settings.number("start") * sound->rate);
    if (start >= static_cast<double>(sound->frame_count()))
        return fail({{},
                     0,
                     "audio: start is " + format_number(settings.number("start")) +
                         " s, but the sound is only " + format_number(sound->seconds()) +
                         " s long"});
    const SoundPart part{static_cast<std::int64_t>(start), settings.is("loop", "on")};
    const ScopeKnobs knobs = scope_knobs(settings);
    return std::make_unique<SoundScope>(sound, part, plug_of(settings, knobs), knobs);
}

std::vector<SettingFacts> settings_of_all_modes() {
    return {{.key = "file",
             .label = "File",
             .help = "A sound: WAV, FLAC, OGG or MP3.",
             .type = SettingType::text},
            choice_setting(
                "mode", "Shown as",
                "xy: left across, right up, and nothing taken away from it; one channel alone "
                "draws the diagonal. waveform: over time.",
                {"xy", "waveform"}),
            {.key = "level",
             .label = "Level",
             .help = "1: full scale reaches the edge.",
             .low = 0,
             .high = 4,
             .initial = 1,
             .limit = {0, 100}},
            choice_setting("auto_gain", "Auto gain",
                           "on: the peak of the last second just fits, at most 40 dB are added.",
                           {"off", "on"}),
            {.key = "upsample",
             .label = "Upsampling",
             .unit = "times",
             .help = "Points per sample; the path goes through all samples.",
             .low = 1,
             .high = 16,
             .step = 1,
             .initial = 4,
             .limit = {1, 16}},
            choice_setting("loop", "Loop", "on: from the end on to the start.", {"on", "off"}),
            {.key = "start",
             .label = "Start",
             .unit = "s",
             .help = "Where in the sound time 0 is, and where a loop begins again.",
             .low = 0,
             .high = 600,
             .limit = {0, 86400}}};
}
}  // namespace

SignalKind audio_kind() {
    std::vector<SettingFacts> settings = settings_of_all_modes();
    settings.push_back(choice_setting("channel", "Channel",
                                      "What is drawn over time: one trace, or both channels, left "
                                      "as channel 1 and right as channel 2.",
                                      {"mean", "left", "right", "both"}));
    settings.back().used_while = {"mode", {"waveform"}};
    for (SettingFacts& setting : scope_settings({.yt_words = {"waveform"},
                                 .scope_words = {"xy", "waveform"},
                                 .seconds_per_division = 0.002,
                                 .shortest_division = 1e-4}))
        settings.push_back(std::move(setting));
    return {.kind = "audio",
            .label = "Sound file",
            .help = "A sound on the screen, every sample drawn exactly once.",
            .settings = std::move(settings),
            .file_setting = "file",
            .bare_setting = "file",
            .make = make_audio};
}
