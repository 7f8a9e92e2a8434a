#include "lab/playback/played_signal.h"

#include "signals/audio/channel_map.h"
#include "signals/audio/loudness.h"
#include "signals/audio/sound_texels.h"
#include "signals/beam/beam_stream.h"
#include "signals/signal/settings.h"
#include "signals/signal_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace {
bool is_live_kind(const Spec& spec) {
    const SignalKind* kind = find_kind(spec.kind);
    return kind && kind->is_live;
}

bool is_sent_kind(const Spec& spec) {
    const SignalKind* kind = find_kind(spec.kind);
    return kind && kind->is_sent;
}

std::string path_of(const Spec& complete) {
    const auto path = complete.settings.find("path");
    return path == complete.settings.end() ? "" : std::get<std::string>(path->second);
}
}  // namespace

Result<void> PlayedSignal::open_input(const Spec& complete, const AudioDevices& devices,
                                      double time) {
    if (is_live_kind(complete) && m_pace == BeamInput::Pace::live) {
        const int channels = std::max(channel_map(Settings(complete)).last(), 2);
        return m_live_input.open(devices, channels, time);
    }
    return is_sent_kind(complete) ? open_feed(complete, time) : Result<void>();
}

// Offline drawing waits for the sender, so that the same input always gives the same picture.
Result<void> PlayedSignal::open_feed(const Spec& complete, double time) {
    if (m_feed && m_feed->spec() == complete)
        return {};
    if (m_feed && path_of(m_feed->spec()) == path_of(complete))
        m_feed.reset();  // two cannot share a path
    auto feed = BeamFeed::open(complete, m_pace, time);
    if (!feed)
        return fail(feed.error());
    m_feed = std::move(*feed);
    m_feed->beam()->set_timeout(m_sender_timeout);
    return {};
}

Result<std::unique_ptr<Signal>> PlayedSignal::make(const Spec& complete,
                                                   const SignalFile& sound) const {
    SignalMedia media{.sound = sound.sound, .scene = sound.scene, .drawing = sound.drawing};
    if (is_live_kind(complete) && m_pace == BeamInput::Pace::live) {
        media.live = m_live_input.sound();
        media.live_first = m_live_input.first_frame();
    }
    if (is_sent_kind(complete))
        media.sent = m_feed->beam();
    return make_signal(complete, media);
}

Result<void> PlayedSignal::set(Spec complete, SignalFile sound) {
    std::unique_ptr<Signal> signal;
    if (!complete.kind.empty()) {
        auto made = make(complete, sound);
        if (!made)
            return fail(made.error());
        signal = std::move(*made);
    }
    if (!is_live_kind(complete))
        m_live_input.close();  // records only while the signal is drawn
    if (!is_sent_kind(complete))
        m_feed.reset();
    m_signal = std::move(signal);
    m_sound = std::move(sound);
    m_spec = std::move(complete);
    measure();
    return {};
}

bool PlayedSignal::is_current(const Spec& complete, const SignalFile& sound) const {
    return m_signal && complete == m_spec && sound == m_sound && !is_live_kind(m_spec) &&
           !is_sent_kind(m_spec);
}

bool PlayedSignal::is_live() const {
    return is_live_kind(m_spec);
}

void PlayedSignal::seek(double time) {
    if (m_feed)
        m_feed->beam()->start_at(time);
    if (!m_live_input.is_open())
        return;
    m_live_input.start_at(time);
    if (auto made = make(m_spec, m_sound))
        m_signal = std::move(*made);
    measure();
}

void PlayedSignal::measure() {
    m_loudness.reset();
    m_sound_texels.reset();
    m_sound_stream.reset();
    if (!m_signal)
        return;
    std::shared_ptr<const SampleStream> sound;
    if (m_sound.sound) {
        const SoundTrack played = track();
        const auto frame_at = [&](double seconds) {
            return std::llround(seconds * played.sound->rate);
        };
        m_sound_stream = stream_of(played.sound, {frame_at(played.start_seconds), played.loops,
                                                  frame_at(played.end_seconds)});
        sound = m_sound_stream;
    } else if (m_live_input.is_open()) {
        sound = stream_of(m_live_input.sound(), m_live_input.first_frame());
    } else if (is_sent_kind(m_spec)) {
        return;
    }
    if (sound)
        m_loudness = std::make_shared<SoundLoudness>(sound);
    else
        m_loudness = std::make_shared<BeamLoudness>(m_signal);
    m_sound_texels = std::make_shared<SoundStreamTexels>(
        sound ? sound : std::make_shared<const BeamStream>(m_signal));
}

std::unique_ptr<Signal> PlayedSignal::copy() const {
    auto made = m_signal ? make(m_spec, m_sound) : nullptr;
    return made ? std::move(*made) : nullptr;
}

Beam PlayedSignal::trace(const TimeSpan& span) const {
    Beam beam;
    if (m_signal)
        m_signal->trace(span, beam);
    return beam;
}

double PlayedSignal::sound_seconds() const {
    const SoundTrack played = track();
    if (!played.sound)
        return 0.0;
    const double sound = played.sound->seconds();
    const double end = played.end_seconds > 0.0 ? std::min(played.end_seconds, sound) : sound;
    return std::max(0.0, end - played.start_seconds);
}

SoundTrack PlayedSignal::track() const {
    if (!m_sound.sound)
        return {};
    return {.sound = m_sound.sound,
            .start_seconds = std::get<double>(m_spec.settings.at("start")),
            .loops = m_spec.settings.at("loop") == Spec::Setting("on"),
            .end_seconds = std::get<double>(m_spec.settings.at("end"))};
}
