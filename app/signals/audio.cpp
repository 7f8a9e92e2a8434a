#include "signals/audio.h"

#include "base/text.h"
#include "signals/auto_gain.h"
#include "signals/points.h"
#include "signals/settings.h"
#include "signals/sweep_plan.h"
#include "signals/upsampler.h"

#include <array>
#include <cmath>
#include <optional>

namespace {
enum class Trace { both, mean, left, right };

float level_of(Trace trace, StereoSample sample) {
    switch (trace) {
        case Trace::left:
            return sample.left;
        case Trace::right:
            return sample.right;
        case Trace::both:
        case Trace::mean:
            break;
    }
    return 0.5f * (sample.left + sample.right);
}

Trace trace_of(const Settings& settings) {
    if (settings.is("mode", "xy"))
        return Trace::both;
    if (settings.is("channel", "mean"))
        return Trace::mean;
    return settings.is("channel", "left") ? Trace::left : Trace::right;
}

class Audio : public Signal {
public:
    Audio(const std::shared_ptr<const Sound>& sound, const Settings& settings,
          const SoundPart& part)
        : m_samples(sound, part, settings.whole("upsample")),
          m_rate(static_cast<double>(sound->rate) * settings.number("upsample")),
          m_loops(part.loops),
          m_level(static_cast<float>(settings.number("level"))),
          m_trace(trace_of(settings)),
          m_charge(charge_of_point(m_rate)),
          m_sweeps(sweeps_of(settings, sound->rate)) {
        if (settings.is("auto_gain", "on"))
            m_gain.emplace(m_samples, part, sound->rate);
    }

    double seconds() const override {
        return m_loops ? Signal::seconds() : static_cast<double>(end()) / m_rate;
    }

    void trace(const TimeSpan& span, Beam& beam) const override {
        PointStream stream{.rate = m_rate};
        if (!m_loops)
            stream.count = end();
        Reader reader(m_samples, instants_in(span, m_rate).end);
        std::size_t hint = 0;
        trace_points(span, stream, beam, [&](std::int64_t k) {
            const StereoSample sample = scaled(reader.at(k), k);
            return m_trace == Trace::both ? across_and_up(sample) : swept(sample, k, hint);
        });
    }

private:
    // Up-samples ahead in blocks, up to `last`, as the points are asked for in rising order.
    class Reader {
    public:
        Reader(const Upsampler& sound, std::int64_t last) : m_sound(sound), m_last(last) {}

        StereoSample at(std::int64_t k) {
            if (k >= m_end) {
                const auto count = std::min(m_last - k, static_cast<std::int64_t>(m_block.size()));
                m_sound.read(k, std::span(m_block).first(static_cast<std::size_t>(count)));
                m_first = k;
                m_end = k + count;
            }
            return m_block[static_cast<std::size_t>(k - m_first)];
        }

    private:
        const Upsampler& m_sound;
        std::int64_t m_last;
        std::int64_t m_first = 0;
        std::int64_t m_end = 0;
        std::array<StereoSample, 2048> m_block;
    };

    std::int64_t end() const { return m_samples.length() * m_samples.factor(); }

    SweepPlan sweeps_of(const Settings& settings, int rate) const {
        const double samples = std::round(settings.number("window") * m_rate);
        const auto length = std::max<std::int64_t>(static_cast<std::int64_t>(samples), 2);
        if (m_trace == Trace::both || settings.is("trigger", "off"))
            return SweepPlan(length);
        return SweepPlan::triggered(m_samples, length, std::max(rate / 10, 1),
                                    [this](StereoSample s) { return level_of(m_trace, s); });
    }

    StereoSample scaled(StereoSample sample, std::int64_t k) const {
        float gain = m_level;
        if (m_gain)
            gain *= m_gain->at(static_cast<double>(k % end()) / m_samples.factor());
        return {sample.left * gain, sample.right * gain};
    }

    BeamPoint across_and_up(StereoSample sample) const {
        return {sample.left, sample.right, static_cast<float>(m_charge)};
    }

    BeamPoint swept(StereoSample sample, std::int64_t k, std::size_t& hint) const {
        const float y = level_of(m_trace, sample);
        const SweepPlace place = m_sweeps.place_of(k, hint);
        if (place.is_waiting)
            return {-1.0f, y, 0.0f};
        const SweepPoint point = sweep_point(place.place, m_sweeps.length(), m_charge);
        return {point.x, y, point.intensity};
    }

    Upsampler m_samples;
    double m_rate;  // up-sampled samples a second
    bool m_loops;
    float m_level;
    Trace m_trace;
    double m_charge;
    SweepPlan m_sweeps;
    std::optional<AutoGain> m_gain;
};

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
    return std::make_unique<Audio>(sound, settings, part);
}

SettingFacts choice(std::string key, std::string label, std::string help,
                    std::vector<std::string> words) {
    const std::string first = words.front();
    return {.key = std::move(key),
            .label = std::move(label),
            .help = std::move(help),
            .type = SettingType::word,
            .words = std::move(words),
            .initial_word = first};
}

std::vector<SettingFacts> settings_of_both_modes() {
    return {{.key = "file",
             .label = "File",
             .help = "A sound: WAV, FLAC, OGG or MP3.",
             .type = SettingType::text},
            choice("mode", "Shown as",
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
            choice("auto_gain", "Auto gain",
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
            choice("loop", "Loop", "on: from the end on to the start.", {"on", "off"}),
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
    std::vector<SettingFacts> settings = settings_of_both_modes();
    settings.push_back({.key = "window",
                        .label = "Window",
                        .unit = "s",
                        .help = "Time across the screen; waveform only.",
                        .low = 0.001,
                        .high = 0.2,
                        .initial = 0.02,
                        .logarithmic = true,
                        .limit = {0.001, 10}});
    settings.push_back(
        choice("trigger", "Trigger",
               "rising: a sweep waits, dark, for the sound to rise through 0, at most "
               "0.1 s; waveform only.",
               {"off", "rising"}));
    settings.push_back(
        choice("channel", "Channel", "What is drawn; waveform only.", {"mean", "left", "right"}));
    return {.kind = "audio",
            .label = "Sound file",
            .help = "A sound on the screen, every sample drawn exactly once.",
            .settings = std::move(settings),
            .file_setting = "file",
            .bare_setting = "file",
            .make = make_audio};
}
