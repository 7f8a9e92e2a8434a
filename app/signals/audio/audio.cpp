#include "signals/audio/audio.h"

#include "base/text.h"
#include "signals/audio/channel_map.h"
#include "signals/audio/mapped_sound.h"
#include "signals/audio/sound_scope.h"
#include "signals/audio/sound_spectrum.h"
#include "signals/signal/settings.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>

namespace {
SoundChannels channels_of(const Settings& settings) {
    if (settings.is("mode", "xy") || settings.is("channel", "both"))
        return SoundChannels::both;
    if (settings.is("channel", "mean"))
        return SoundChannels::mean;
    return settings.is("channel", "left") ? SoundChannels::left : SoundChannels::right;
}

SoundInputSettings plug_of(const Settings& settings, const ScopeControls& controls) {
    return {.channels = channels_of(settings),
            .is_swapped = controls.is_swapped,
            .coupling = {controls.channels[0].coupling, controls.channels[1].coupling},
            .level = settings.number("level"),
            .has_auto_gain = settings.is("auto_gain", "on"),
            .upsample = settings.whole("upsample")};
}

SpectrumControls spectrum_controls(const Settings& settings) {
    return {.size = std::stoi(std::string(settings.word("fft"))),
            .smoothing_seconds = settings.number("smoothing"),
            .low_hertz = settings.number("low"),
            .high_hertz = settings.number("high"),
            .floor_decibels = settings.number("floor"),
            .ceiling_decibels = settings.number("ceiling"),
            .is_radial = settings.is("mode", "radial"),
            .radius = settings.number("radius"),
            .pulse = settings.number("pulse"),
            .beat_threshold = settings.number("beat_threshold"),
            .beat_decay_seconds = settings.number("beat_decay")};
}

Result<std::unique_ptr<Signal>> make_spectrum(const Settings& settings,
                                              std::shared_ptr<const SampleStream> sound) {
    const SpectrumControls controls = spectrum_controls(settings);
    if (controls.low_hertz >= controls.high_hertz)
        return fail({{}, 0, "'high' must be above 'low'"});
    if (controls.floor_decibels >= controls.ceiling_decibels)
        return fail({{}, 0, "'ceiling' must be above 'floor'"});
    SoundInputSettings plug{.channels = channels_of(settings),
                            .is_swapped = settings.is("channel", "right"),
                            .level = settings.number("level"),
                            .has_auto_gain = settings.is("auto_gain", "on"),
                            .upsample = 1};
    if (settings.is("channel", "both"))
        plug.channels = SoundChannels::mean;
    return std::make_unique<SoundSpectrum>(std::move(sound), plug, controls);
}

/// Opens two channels of the sound.
using Open = std::function<std::shared_ptr<const SampleStream>(const StreamChannels&)>;

// Only xy mode maps channels to properties of the beam.
Result<std::unique_ptr<Signal>> make_mapped(const Settings& settings, const Open& open,
                                            int channels) {
    const ChannelMap map = channel_map(settings);
    if (auto good = check_channels(map, channels); !good)
        return fail(good.error());
    const ScopeControls controls = scope_controls(settings);
    const SoundInputSettings plug = plug_of(settings, controls);
    auto scope = std::make_unique<SoundScope>(open({map.x, map.y}), plug, controls);
    if (map.is_plain())
        return scope;
    return std::make_unique<MappedSound>(
        std::move(scope), MappedSound::Streams{open({map.intensity, map.r}), open({map.g, map.b})},
        map, plug.upsample);
}

Result<std::unique_ptr<Signal>> make_shown(const Settings& settings, const Open& open,
                                           int channels) {
    if (settings.is("mode", "xy"))
        return make_mapped(settings, open, channels);
    if (settings.is("mode", "spectrum") || settings.is("mode", "radial"))
        return make_spectrum(settings, open({}));
    const ScopeControls controls = scope_controls(settings);
    return std::make_unique<SoundScope>(open({}), plug_of(settings, controls), controls);
}

Result<std::unique_ptr<Signal>> make_audio(const Settings& settings, const SignalMedia& media) {
    const auto& sound = media.sound;
    if (media.drawing || media.scene)
        return fail({{},
                     0,
                     media.drawing
                         ? "audio: expected a sound file, got an SVG. Use drawing:FILE instead."
                         : "audio: expected a sound file, got a scene. Use scene:FILE instead."});
    if (!sound || sound->rate <= 0 || sound->frame_count() == 0)
        return fail({{}, 0, "audio: no sound to draw"});
    const double start = std::round(settings.number("start") * sound->rate);
    if (start >= static_cast<double>(sound->frame_count()))
        return fail({{},
                     0,
                     fmt::format("audio: 'start' is {} s, but the sound is only {} s long",
                                 format_number(settings.number("start")),
                                 format_number(sound->seconds()))});
    const double end = std::round(settings.number("end") * sound->rate);
    if (end > 0.0 && end <= start)
        return fail({{},
                     0,
                     fmt::format("audio: 'end' is {} s, but 'start' is {} s. Use a later end, or 0 "
                                 "for the end of the sound.",
                                 format_number(settings.number("end")),
                                 format_number(settings.number("start")))});
    const SoundPart part{static_cast<std::int64_t>(start), settings.is("loop", "on"),
                         static_cast<std::int64_t>(end)};
    const auto open = [&](const StreamChannels& channels) {
        return stream_of(sound, part, channels);
    };
    return make_shown(settings, open, sound->channels);
}

Result<std::unique_ptr<Signal>> make_microphone(const Settings& settings,
                                                const SignalMedia& media) {
    if (!media.live)
        return fail(
            {{},
             0,
             "microphone: live sound only works in the window. Use audio:FILE for a sound file."});
    const auto open = [&](const StreamChannels& channels) {
        return stream_of(media.live, media.live_first, channels);
    };
    return make_shown(settings, open, media.live->channels());
}

std::vector<SettingInfo> settings_of_all_modes() {
    return {choice_setting(
                "mode", "Mode",
                "xy: left channel horizontal, right channel vertical, unfiltered. A mono sound "
                "draws a diagonal. waveform: level over time. spectrum: level of each frequency. "
                "radial: spectrum around a ring that pulses with the beat.",
                {"xy", "waveform", "spectrum", "radial"}),
            {.key = "level",
             .label = "Level",
             .help = "At 1, full scale reaches the edge.",
             .low = 0,
             .high = 4,
             .initial = 1,
             .limit = {0, 100}},
            choice_setting(
                "auto_gain", "Auto gain",
                "on: scales the peak of the last second to the edge, with at most 40 dB of gain.",
                {"off", "on"}),
            {.key = "upsample",
             .label = "Upsampling",
             .unit = "×",
             .help = "Points per sample. The path passes through every sample.",
             .low = 1,
             .high = 16,
             .step = 1,
             .initial = 4,
             .limit = {1, 16},
             .condition = {"mode", {"xy", "waveform"}}},
            {.key = "channel",
             .label = "Channel",
             .help = "Sound channel to draw. both: in a waveform, left as channel 1 and right as "
                     "channel 2. In a spectrum, their mean.",
             .type = SettingType::word,
             .words = {"mean", "left", "right", "both"},
             .initial_word = "mean",
             .condition = {"mode", {"waveform", "spectrum", "radial"}}}};
}

std::vector<SettingInfo> file_settings() {
    return {{.key = "file",
             .label = "File",
             .help = "A sound file: WAV, FLAC, OGG or MP3.",
             .type = SettingType::text},
            choice_setting("loop", "Loop", "on: starts again at the end.", {"on", "off"}),
            {.key = "start",
             .label = "Start",
             .unit = "s",
             .help = "Position in the sound at time 0. Loops also restart here.",
             .low = 0,
             .high = 600,
             .limit = {0, 86400}},
            {.key = "end",
             .label = "End",
             .unit = "s",
             .help = "Position in the sound where playback ends or loops. 0: the end of the file.",
             .low = 0,
             .high = 600,
             .limit = {0, 86400}}};
}

std::vector<SettingInfo> spectrum_settings() {
    SettingInfo size = choice_setting(
        "fft", "FFT size", "Samples per spectrum. More separate close tones, fewer react faster.",
        {"256", "512", "1024", "2048", "4096", "8192", "16384", "32768"});
    size.initial_word = "2048";
    return in_group("Spectrum", {"mode", {"spectrum", "radial"}},
                    {size,
                     {.key = "smoothing",
                      .label = "Smoothing",
                      .unit = "s",
                      .help = "Time constant of the levels.",
                      .low = 0,
                      .high = 1,
                      .initial = 0.08,
                      .limit = {0, 5}},
                     {.key = "floor",
                      .label = "Floor",
                      .unit = "dB",
                      .help = "Level at the bottom of the screen. 0 dB is a full-scale sine.",
                      .low = -120,
                      .high = -20,
                      .initial = -80,
                      .limit = {-200, 100}},
                     {.key = "ceiling",
                      .label = "Ceiling",
                      .unit = "dB",
                      .help = "Level at the top of the screen.",
                      .low = -60,
                      .high = 12,
                      .limit = {-200, 100}},
                     {.key = "low",
                      .label = "Lowest frequency",
                      .unit = "Hz",
                      .help = "Frequency at the left edge. The scale is logarithmic.",
                      .low = 10,
                      .high = 1000,
                      .initial = 20,
                      .logarithmic = true,
                      .limit = {1, 100000}},
                     {.key = "high",
                      .label = "Highest frequency",
                      .unit = "Hz",
                      .help = "Frequency at the right edge.",
                      .low = 1000,
                      .high = 24000,
                      .initial = 20000,
                      .logarithmic = true,
                      .limit = {1, 100000}}});
}

std::vector<SettingInfo> ring_settings() {
    return in_group(
        "Ring", {"mode", {"radial"}},
        {{.key = "radius",
          .label = "Radius",
          .help = "Radius of the ring at the floor level. 1 reaches the edge.",
          .initial = 0.4,
          .limit = {0, 1}},
         {.key = "pulse",
          .label = "Beat pulse",
          .unit = "× radius",
          .help = "How far a beat expands the ring.",
          .initial = 0.3,
          .limit = {0, 4}},
         {.key = "beat_threshold",
          .label = "Beat threshold",
          .unit = "× mean",
          .help = "Bass energy that counts as a beat, relative to the mean of the last second.",
          .low = 1,
          .high = 8,
          .initial = 2,
          .limit = {0.1, 1000}},
         {.key = "beat_decay",
          .label = "Beat decay",
          .unit = "s",
          .help = "Time constant of the ring's return to its radius.",
          .low = 0.02,
          .high = 1,
          .initial = 0.2,
          .logarithmic = true,
          .limit = {0.001, 10}}});
}

std::vector<SettingInfo> shown_settings() {
    std::vector<SettingInfo> settings = settings_of_all_modes();
    settings.push_back(fit_setting({"mode", {"xy"}}));
    for (auto part : {scope_settings({.yt_modes = {"waveform"},
                     .scope_modes = {"xy", "waveform"},
                     .seconds_per_division = 0.002,
                     .shortest_division = 1e-4}),
                      channel_settings({}, {"mode", {"xy"}}), spectrum_settings(), ring_settings()})
        settings.insert(settings.end(), part.begin(), part.end());
    return settings;
}
}  // namespace

SignalKind audio_kind() {
    std::vector<SettingInfo> settings = file_settings();
    for (SettingInfo& setting : shown_settings())
        settings.push_back(std::move(setting));
    return {.kind = "audio",
            .label = "Sound file",
            .help = "Draws a sound file. Every sample is drawn exactly once.",
            .settings = std::move(settings),
            .file_setting = "file",
            .bare_setting = "file",
            .make = make_audio};
}

SignalKind microphone_kind() {
    return {.kind = "microphone",
            .label = "Live sound",
            .help =
                "Draws live sound from an audio input or from another program. Works only in the "
                "window.",
            .settings = shown_settings(),
            .is_live = true,
            .make = make_microphone};
}
