#include "signals/audio.h"

#include "base/text.h"
#include "signals/channel_map.h"
#include "signals/mapped_sound.h"
#include "signals/settings.h"
#include "signals/sound_scope.h"
#include "signals/sound_spectrum.h"

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

SoundPlug plug_of(const Settings& settings, const ScopeKnobs& knobs) {
    return {.channels = channels_of(settings),
            .is_swapped = knobs.is_swapped,
            .coupling = {knobs.channels[0].coupling, knobs.channels[1].coupling},
            .level = settings.number("level"),
            .has_auto_gain = settings.is("auto_gain", "on"),
            .upsample = settings.whole("upsample")};
}

SpectrumKnobs spectrum_knobs(const Settings& settings) {
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
    const SpectrumKnobs knobs = spectrum_knobs(settings);
    if (knobs.low_hertz >= knobs.high_hertz)
        return fail({{}, 0, "high must be above low"});
    if (knobs.floor_decibels >= knobs.ceiling_decibels)
        return fail({{}, 0, "ceiling must be above floor"});
    SoundPlug plug{.channels = channels_of(settings),
                   .is_swapped = settings.is("channel", "right"),
                   .level = settings.number("level"),
                   .has_auto_gain = settings.is("auto_gain", "on"),
                   .upsample = 1};
    if (settings.is("channel", "both"))
        plug.channels = SoundChannels::mean;
    return std::make_unique<SoundSpectrum>(std::move(sound), plug, knobs);
}

/// The sound's channels, two at a time.
using Open = std::function<std::shared_ptr<const SampleStream>(const StreamChannels&)>;

// Which channels are what of the beam has a say in xy alone.
Result<std::unique_ptr<Signal>> make_mapped(const Settings& settings, const Open& open,
                                            int channels) {
    const ChannelMap map = channel_map(settings);
    if (auto good = check_channels(map, channels); !good)
        return fail(good.error());
    const ScopeKnobs knobs = scope_knobs(settings);
    const SoundPlug plug = plug_of(settings, knobs);
    auto place = std::make_unique<SoundScope>(open({map.x, map.y}), plug, knobs);
    if (map.is_plain())
        return place;
    return std::make_unique<MappedSound>(
        std::move(place), MappedSound::Streams{open({map.intensity, map.r}), open({map.g, map.b})},
        map, plug.upsample);
}

Result<std::unique_ptr<Signal>> make_shown(const Settings& settings, const Open& open,
                                           int channels) {
    if (settings.is("mode", "xy"))
        return make_mapped(settings, open, channels);
    if (settings.is("mode", "spectrum") || settings.is("mode", "radial"))
        return make_spectrum(settings, open({}));
    const ScopeKnobs knobs = scope_knobs(settings);
    return std::make_unique<SoundScope>(open({}), plug_of(settings, knobs), knobs);
}

Result<std::unique_ptr<Signal>> make_audio(const Settings& settings, const SignalMedia& media) {
    const auto& sound = media.sound;
    if (media.drawing || media.scene)
        return fail({{},
                     0,
                     media.drawing ? "audio: takes a sound; an SVG is drawn by drawing:FILE"
                                   : "audio: takes a sound; a scene is drawn by scene:FILE"});
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
    const auto open = [&](const StreamChannels& channels) {
        return stream_of(sound, part, channels);
    };
    return make_shown(settings, open, sound->channels);
}

Result<std::unique_ptr<Signal>> make_microphone(const Settings& settings,
                                                const SignalMedia& media) {
    if (!media.live)
        return fail(
            {{}, 0, "microphone: there is no live sound here; audio:FILE shows a sound file"});
    const auto open = [&](const StreamChannels& channels) {
        return stream_of(media.live, media.live_first, channels);
    };
    return make_shown(settings, open, media.live->channels());
}

std::vector<SettingFacts> settings_of_all_modes() {
    return {choice_setting(
                "mode", "Shown as",
                "xy: left across, right up, and nothing taken away from it; one channel alone "
                "draws the diagonal. waveform: over time. spectrum: how loud each frequency "
                "is. radial: the spectrum around a ring that jumps on each beat.",
                {"xy", "waveform", "spectrum", "radial"}),
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
             .limit = {1, 16},
             .used_while = {"mode", {"xy", "waveform"}}},
            {.key = "channel",
             .label = "Channel",
             .help = "What is drawn; both: two traces over time, left as channel 1 and right as "
                     "channel 2, and the mean in a spectrum.",
             .type = SettingType::word,
             .words = {"mean", "left", "right", "both"},
             .initial_word = "mean",
             .used_while = {"mode", {"waveform", "spectrum", "radial"}}}};
}

std::vector<SettingFacts> file_settings() {
    return {{.key = "file",
             .label = "File",
             .help = "A sound: WAV, FLAC, OGG or MP3.",
             .type = SettingType::text},
            choice_setting("loop", "Loop", "on: from the end on to the start.", {"on", "off"}),
            {.key = "start",
             .label = "Start",
             .unit = "s",
             .help = "Where in the sound time 0 is, and where a loop begins again.",
             .low = 0,
             .high = 600,
             .limit = {0, 86400}}};
}

std::vector<SettingFacts> spectrum_settings() {
    SettingFacts size =
        choice_setting("fft", "FFT size",
                       "Samples a spectrum is made of: more tell tones apart, fewer are quicker.",
                       {"256", "512", "1024", "2048", "4096", "8192", "16384", "32768"});
    size.initial_word = "2048";
    return in_group("Spectrum", {"mode", {"spectrum", "radial"}},
                    {size,
                     {.key = "smoothing",
                      .label = "Smoothing",
                      .unit = "s",
                      .help = "Time constant with which the levels follow the sound.",
                      .low = 0,
                      .high = 1,
                      .initial = 0.08,
                      .limit = {0, 5}},
                     {.key = "floor",
                      .label = "Floor",
                      .unit = "dB",
                      .help = "The level at the bottom, 0 dB being a sine of full scale.",
                      .low = -120,
                      .high = -20,
                      .initial = -80,
                      .limit = {-200, 100}},
                     {.key = "ceiling",
                      .label = "Ceiling",
                      .unit = "dB",
                      .help = "The level at the top.",
                      .low = -60,
                      .high = 12,
                      .limit = {-200, 100}},
                     {.key = "low",
                      .label = "Lowest",
                      .unit = "Hz",
                      .help = "The frequency at the left; the scale is logarithmic.",
                      .low = 10,
                      .high = 1000,
                      .initial = 20,
                      .logarithmic = true,
                      .limit = {1, 100000}},
                     {.key = "high",
                      .label = "Highest",
                      .unit = "Hz",
                      .help = "The frequency at the right.",
                      .low = 1000,
                      .high = 24000,
                      .initial = 20000,
                      .logarithmic = true,
                      .limit = {1, 100000}}});
}

std::vector<SettingFacts> ring_settings() {
    return in_group("Ring", {"mode", {"radial"}},
                    {{.key = "radius",
                      .label = "Radius",
                      .help = "Of the ring where the level is at the floor; 1 reaches the edge.",
                      .initial = 0.4,
                      .limit = {0, 1}},
                     {.key = "pulse",
                      .label = "Beat pulse",
                      .unit = "radii",
                      .help = "How far a beat throws the ring out.",
                      .initial = 0.3,
                      .limit = {0, 4}},
                     {.key = "beat_threshold",
                      .label = "Beat threshold",
                      .unit = "times the mean",
                      .help = "A beat is bass with so many times the energy of the last second's.",
                      .low = 1,
                      .high = 8,
                      .initial = 2,
                      .limit = {0.1, 1000}},
                     {.key = "beat_decay",
                      .label = "Beat decay",
                      .unit = "s",
                      .help = "Time constant with which the ring comes back.",
                      .low = 0.02,
                      .high = 1,
                      .initial = 0.2,
                      .logarithmic = true,
                      .limit = {0.001, 10}}});
}

std::vector<SettingFacts> shown_settings() {
    std::vector<SettingFacts> settings = settings_of_all_modes();
    settings.push_back(fit_setting({"mode", {"xy"}}));
    for (auto part : {scope_settings({.yt_words = {"waveform"},
                     .scope_words = {"xy", "waveform"},
                     .seconds_per_division = 0.002,
                     .shortest_division = 1e-4}),
                      channel_settings({}, {"mode", {"xy"}}), spectrum_settings(), ring_settings()})
        settings.insert(settings.end(), part.begin(), part.end());
    return settings;
}
}  // namespace

SignalKind audio_kind() {
    std::vector<SettingFacts> settings = file_settings();
    for (SettingFacts& setting : shown_settings())
        settings.push_back(std::move(setting));
    return {.kind = "audio",
            .label = "Sound file",
            .help = "A sound on the screen, every sample drawn exactly once.",
            .settings = std::move(settings),
            .file_setting = "file",
            .bare_setting = "file",
            .make = make_audio};
}

SignalKind microphone_kind() {
    return {.kind = "microphone",
            .label = "Live sound",
            .help =
                "What comes in at the sound device, or what another program plays. Only in the "
                "window.",
            .settings = shown_settings(),
            .is_live = true,
            .make = make_microphone};
}
