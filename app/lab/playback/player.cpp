#include "lab/playback/player.h"

#include "model/devices/live_sound.h"
#include "signals/audio/channel_map.h"
#include "signals/audio/loudness.h"
#include "signals/audio/sound_texels.h"
#include "signals/beam/beam_stream.h"
#include "signals/signal/settings.h"
#include "signals/signal_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace {
bool has_same_media(const PlayedSound& one, const PlayedSound& other) {
    return one.file == other.file && one.sound == other.sound && one.scene == other.scene &&
           one.drawing == other.drawing;
}
}  // namespace

Result<void> Player::set_signal(const Spec& spec, PlayedSound sound) {
    std::unique_ptr<Signal> signal;
    double start = 0.0;
    bool loops = false;
    Spec complete;
    if (!spec.kind.empty()) {
        auto checked = completed(spec);
        if (!checked)
            return fail(checked.error());
        complete = std::move(*checked);
        const SignalKind& kind = *find_kind(complete.kind);
        const bool is_the_same = m_signal && complete == m_spec && has_same_media(sound, m_sound);
        const bool is_heard =
            m_silence.empty() && m_settings.plays_beam == static_cast<bool>(m_playout);
        if (is_the_same && is_heard && !kind.is_live && !kind.is_sent)
            return {};  // such as after an edit of the look
        auto made = make(complete, sound);
        if (!made)
            return fail(made.error());
        signal = std::move(*made);
        if (sound.sound) {
            start = std::get<double>(complete.settings.at("start"));
            loops = complete.settings.at("loop") == Spec::Setting("on");
        }
    }
    if (spec.kind.empty() || !find_kind(spec.kind)->is_live)
        m_capture.reset();  // records only while the signal is drawn
    if (spec.kind.empty() || !find_kind(spec.kind)->is_sent)
        m_feed.reset();
    const bool is_new_sound = sound.sound != m_sound.sound || start != m_start;
    m_signal = std::move(signal);
    m_sound = std::move(sound);
    m_spec = std::move(complete);
    m_start = start;
    m_silence.clear();
    listen();
    if (m_devices) {
        play_beam();
        play_sound(loops, is_new_sound);
    }
    return {};
}

void Player::listen() {
    m_loudness.reset();
    m_sound_texels.reset();
    m_heard_stream.reset();
    if (!m_signal)
        return;
    std::shared_ptr<const SampleStream> sound;
    if (m_sound.sound) {
        const auto first = std::llround(m_start * m_sound.sound->rate);
        const bool loops = m_spec.settings.at("loop") == Spec::Setting("on");
        sound = stream_of(m_sound.sound, {first, loops});
        m_heard_stream = sound;
    } else if (m_capture) {
        sound = stream_of(m_capture->sound(), m_live_first);
    } else if (find_kind(m_spec.kind)->is_sent) {
        return;
    }
    if (sound)
        m_loudness = std::make_shared<SoundLoudness>(sound);
    else
        m_loudness = std::make_shared<BeamLoudness>(m_signal);
    m_sound_texels = std::make_shared<SoundStreamTexels>(
        sound ? sound : std::make_shared<const BeamStream>(m_signal));
}

// The beam replaces the sound output. Without a device, playback continues silently.
void Player::play_beam() {
    if (!m_settings.plays_beam || !m_signal) {
        m_playout.reset();
        return;
    }
    if (!m_playout) {
        auto output = m_devices->open_beam_output(m_settings);
        if (!output) {
            m_silence = output.error().front().message;
            m_settings.plays_beam = false;
            return;
        }
        m_output.reset();
        m_playout = std::make_unique<BeamPlayout>(std::move(*output));
        m_playout->set_level(m_settings.beam_level);
    }
    const SignalKind& kind = *find_kind(m_spec.kind);
    if (auto signal = make(m_spec, m_sound))
        m_playout->set_signal(std::move(*signal), !kind.is_live && !kind.is_sent);
}

Result<std::unique_ptr<Signal>> Player::make(const Spec& complete, const PlayedSound& sound) {
    SignalMedia media{.sound = sound.sound, .scene = sound.scene, .drawing = sound.drawing};
    if (m_devices && find_kind(complete.kind)->is_live && m_is_input_muted) {
        const int channels = std::max(channel_map(Settings(complete)).last(), 2);
        media.live = std::make_shared<const LiveSound>(48000, channels);  // silence
    } else if (m_devices && find_kind(complete.kind)->is_live) {
        if (const auto open = open_capture(complete); !open)
            return fail(open.error());
        media.live = m_capture->sound();
        media.live_first = m_live_first;
    }
    if (find_kind(complete.kind)->is_sent) {
        if (const auto open = open_feed(complete); !open)
            return fail(open.error());
        media.sent = m_feed->beam();
    }
    return make_signal(complete, media);
}

namespace {
std::string place_of(const Spec& complete) {
    const auto path = complete.settings.find("path");
    return path == complete.settings.end() ? "" : std::get<std::string>(path->second);
}
}  // namespace

// Offline drawing waits for the sender, so that the same input always gives the same picture.
Result<void> Player::open_feed(const Spec& complete) {
    if (m_feed && m_feed->spec() == complete)
        return {};
    if (m_feed && place_of(m_feed->spec()) == place_of(complete))
        m_feed.reset();  // two cannot share a path
    const auto pace = m_devices ? BeamInput::Pace::live : BeamInput::Pace::waiting;
    auto feed = BeamFeed::open(complete, pace, m_time);
    if (!feed)
        return fail(feed.error());
    m_feed = std::move(*feed);
    m_feed->beam()->set_patience(m_sender_patience);
    return {};
}

std::string Player::silence() const {
    if (m_feed)
        if (std::string complaint = m_feed->complaint(); !complaint.empty())
            return complaint;
    return draws_muted_input() ? "Live sound is muted" : m_silence;
}

bool Player::draws_muted_input() const {
    return m_is_input_muted && m_signal && find_kind(m_spec.kind)->is_live;
}

Result<void> Player::mute_input(bool is_muted) {
    if (m_is_input_muted == is_muted)
        return {};
    m_is_input_muted = is_muted;
    if (is_muted)
        m_capture.reset();
    if (!m_signal || !find_kind(m_spec.kind)->is_live)
        return {};
    return set_signal(Spec(m_spec));
}

Result<void> Player::open_capture(const Spec& complete) {
    const int channels = std::max(channel_map(Settings(complete)).last(), 2);
    if (m_capture && channels <= m_channels)
        return {};
    auto capture = m_devices->open_capture(m_settings, channels);
    if (!capture) {
        m_silence = capture.error().front().message;
        return fail(capture.error());
    }
    m_capture = std::move(*capture);
    m_channels = channels;
    begin_live();
    return {};
}

// Maps the current position of the live sound to the current time.
void Player::begin_live() {
    const double ahead = m_capture->position_seconds() - m_time;
    m_live_first = std::llround(ahead * m_capture->sound()->rate());
}

Result<void> Player::set_sound_settings(const SoundSettings& settings) {
    SoundSettings as_they_are = settings;
    as_they_are.picture_delay_ms = m_settings.picture_delay_ms;
    as_they_are.beam_level = m_settings.beam_level;
    if (m_playout)
        m_playout->set_level(settings.beam_level);
    const bool needs_devices = m_devices && as_they_are != m_settings;
    m_settings = settings;
    if (!needs_devices)
        return {};
    m_output.reset();
    m_capture.reset();
    m_playout.reset();
    PlayedSound sound = std::exchange(m_sound, {});  // so that it counts as new for the new device
    return set_signal(m_spec, std::move(sound));
}

std::vector<SoundDevice> Player::sound_devices() const {
    return m_devices ? m_devices->list() : std::vector<SoundDevice>();
}

double Player::sound_seconds() const {
    return m_sound.sound ? std::max(0.0, m_sound.sound->seconds() - m_start) : 0.0;
}

// Updates the sound output for the signal. Without a device, the wall clock is used.
void Player::play_sound(bool loops, bool is_new_sound) {
    if (m_sound.sound && !m_output && !m_playout) {
        auto output = m_devices->open_output(m_settings);
        if (output)
            m_output = std::move(*output);
        else if (m_silence.empty())
            m_silence = output.error().front().message;
    }
    if (!m_output)
        return;
    if (is_new_sound)
        m_output->play(m_sound.sound, m_start);
    if (!m_sound.sound)
        return;
    m_output->set_loop(loops);
    m_output->set_level(m_level);
    m_output->set_speed(m_speed);
    if (is_new_sound)
        seek(m_time);
    m_is_playing ? m_output->play() : m_output->pause();
}

bool Player::is_sound_the_clock() const {
    return m_sound.sound && m_output && !m_output->has_stalled();
}

void Player::play() {
    m_is_playing = true;
    if (m_output)
        m_output->play();
}

void Player::pause() {
    m_is_playing = false;
    if (m_output)
        m_output->pause();
    if (m_playout)
        m_playout->rest();
}

void Player::restart() {
    m_frame = 0;
    m_past.clear();
    seek(0.0);
}

void Player::seek(double seconds) {
    m_time = std::max(0.0, seconds);
    if (m_output)
        m_output->seek(m_time);
    m_heard = m_time;
    if (m_playout)
        m_playout->rest();
    if (m_feed)
        m_feed->beam()->start_at(m_time);
    if (!m_capture)
        return;
    begin_live();
    if (auto made = make(m_spec, m_sound))
        m_signal = std::move(*made);
    listen();
    if (m_playout)
        play_beam();  // its signal starts at another position
}

void Player::seek_with_past(double seconds, std::size_t frames) {
    constexpr double span = 1.0 / 60.0;
    seek(seconds);
    const auto since_start = static_cast<std::int64_t>(m_time / span);
    const auto most = static_cast<std::int64_t>(std::min(frames, frames_remembered));
    const std::int64_t count = std::min(since_start, most);
    m_past.clear();
    m_frame = since_start - count;
    for (std::int64_t left = count; left > 0; --left) {
        const auto ago = static_cast<double>(left) * span;
        m_past.push_back({++m_frame, {m_time - ago, m_time - ago + span}});
    }
}

void Player::go_back_to(std::int64_t frame) {
    if (m_past.empty() || frame < m_past.front().number || frame > m_past.back().number)
        return;
    while (m_past.back().number > frame)
        m_past.pop_back();
    m_frame = frame;
    seek(m_past.back().span.end);
}

void Player::set_speed(double speed) {
    m_speed = std::clamp(speed, 0.01, 4.0);
    if (m_output)
        m_output->set_speed(m_speed);
}

void Player::set_level(double level) {
    m_level = std::clamp(level, 0.0, 2.0);
    if (m_output)
        m_output->set_level(m_level);
}

// The elapsed time of the signal. While a sound plays, its position is the clock.
double Player::played_seconds(double wall_seconds) {
    if (!is_sound_the_clock())
        return wall_seconds * m_speed;
    const double position = m_output->position_seconds() - 0.001 * m_settings.picture_delay_ms;
    const double later = std::max(position, m_heard);  // waits if the picture is delayed
    return later - std::exchange(m_heard, later);
}

// Reports a stalled device once. The picture continues with the wall clock.
void Player::notice_lost_devices() {
    if (!m_silence.empty())
        return;
    if (m_playout && m_playout->has_stalled())
        m_silence = fmt::format("Audio device \"{}\" stopped. The beam isn't sent any more.",
                                m_playout->device_name());
    else if (m_capture && m_capture->has_stalled())
        m_silence = fmt::format("No input from \"{}\"", m_capture->device_name());
    else if (m_sound.sound && m_output && m_output->has_stalled())
        m_silence =
            fmt::format("Audio device \"{}\" stopped. Playing silently.", m_output->device_name());
}

// Skips input that was received during a pause or a stall.
std::optional<PlayedFrame> Player::advance_live(double wall_seconds) {
    if (m_capture->has_stalled())
        return moved_to(m_time + std::min(wall_seconds, m_longest_frame));
    const double delay = std::max(0.001 * m_settings.picture_delay_ms, 0.0);
    const double position = m_capture->position_seconds() - delay;
    const double end = position - static_cast<double>(m_live_first) / m_capture->sound()->rate();
    if (end <= m_time)
        return std::nullopt;
    m_time = std::max(m_time, end - m_longest_frame);
    return moved_to(end);
}

PlayedFrame Player::moved_to(double end) {
    const PlayedFrame frame{++m_frame, {m_time, end}};
    m_time = end;
    m_past.push_back(frame);
    if (m_past.size() > frames_remembered)
        m_past.pop_front();
    return frame;
}

std::optional<PlayedFrame> Player::advance(double wall_seconds) {
    auto frame = advance_picture(wall_seconds);
    if (m_playout && m_is_playing)
        m_playout->follow(m_time, m_speed);
    return frame;
}

std::optional<PlayedFrame> Player::advance_picture(double wall_seconds) {
    notice_lost_devices();
    if (m_is_stepping) {
        m_is_stepping = false;
        const PlayedFrame frame = moved_to(m_time + 1.0 / 60.0);
        if (m_output)
            m_output->seek(m_time);
        m_heard = m_time;
        return frame;
    }
    if (!m_is_playing)
        return std::nullopt;
    if (m_capture)
        return advance_live(wall_seconds);
    const double played = shown_seconds(played_seconds(wall_seconds), wall_seconds);
    if (played <= 0.0)
        return std::nullopt;
    return moved_to(m_time + played);
}

void Player::set_longest_frame(double seconds) {
    m_longest_frame = std::clamp(seconds, 1.0 / 240.0, longest_frame);
}

// Limits the frame to its longest duration. A playing sound continues; other time is lost.
double Player::shown_seconds(double played, double wall_seconds) {
    if (played <= 0.0)
        return 0.0;
    const double shown = std::min(played, m_longest_frame);
    const double share = shown / played;
    const double of_two = std::max(share, std::exchange(m_last_share, share));
    constexpr double lately_seconds = 0.5;
    m_shown_share += std::min(wall_seconds / lately_seconds, 1.0) * (of_two - m_shown_share);
    if (leaves_out())
        m_time += played - shown;
    return shown;
}

PlayedFrame Player::advance_fixed(double fps) {
    const TimeSpan span = frame_span(m_frame + 1, fps);
    m_time = span.start;
    return moved_to(span.end);
}

Beam Player::trace(const TimeSpan& span) const {
    Beam beam;
    if (m_signal)
        m_signal->trace(span, beam);
    return beam;
}
