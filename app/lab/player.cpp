#include "lab/player.h"

#include "io/sound_file.h"
#include "signals/kinds.h"

#include <algorithm>
#include <utility>

namespace fs = std::filesystem;

namespace {
/// The sound without its first seconds: what a signal that starts there draws, and loops over.
std::shared_ptr<const Sound> part_from(const std::shared_ptr<const Sound>& sound, double seconds) {
    const auto frames = static_cast<std::size_t>(std::max(0.0, seconds) * sound->rate);
    if (frames == 0)
        return sound;
    const std::size_t first =
        std::min(frames, sound->frame_count()) * static_cast<std::size_t>(sound->channels);
    auto part = std::make_shared<Sound>(Sound{sound->rate, sound->channels, {}});
    part->samples.assign(sound->samples.begin() + static_cast<std::ptrdiff_t>(first),
                         sound->samples.end());
    return part;
}
}  // namespace

Result<void> Player::set_signal(const Spec& spec, const fs::path& folder) {
    auto complete = completed(spec);
    if (!complete)
        return fail(complete.error());
    const SignalKind& kind = *find_kind(complete->kind);
    std::shared_ptr<const Sound> sound;
    fs::path file;
    if (!kind.file_setting.empty()) {
        file = folder / std::get<std::string>(complete->settings.at(kind.file_setting));
        sound = m_sound;
        if (!sound || file != m_sound_file) {
            auto loaded = load_sound(file);
            if (!loaded)
                return fail(loaded.error());
            sound = std::make_shared<const Sound>(std::move(*loaded));
        }
    }
    auto signal = make_signal(*complete, {sound});
    if (!signal)
        return fail(signal.error());
    m_signal = std::move(*signal);
    const bool is_new_sound = sound != m_sound;
    m_sound = std::move(sound);
    m_sound_file = std::move(file);
    if (m_is_heard)
        play_sound(*complete, is_new_sound);
    return {};
}

// The loudspeaker follows the signal. Without a device the wall clock runs instead.
void Player::play_sound(const Spec& spec, bool is_new_sound) {
    m_silence.clear();
    if (m_sound && !m_output) {
        auto output = SoundOutput::open();
        if (output)
            m_output = std::move(*output);
        else
            m_silence = output.error().front().message;
    }
    if (!m_output)
        return;
    const double start = m_sound ? std::get<double>(spec.settings.at("start")) : 0.0;
    const bool is_new = is_new_sound || start != m_heard_from;
    m_heard_from = start;
    if (is_new)
        m_output->play(m_sound ? part_from(m_sound, start) : nullptr);
    if (!m_sound)
        return;
    m_output->set_loop(spec.settings.at("loop") == Spec::Setting("on"));
    m_output->set_level(m_level);
    m_output->set_speed(m_speed);
    if (is_new)
        seek(m_time);
    m_is_playing ? m_output->play() : m_output->pause();
}

bool Player::is_sound_the_clock() const {
    return m_sound && m_output && !m_output->has_stalled();
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

// Seconds of the signal that have gone by. A heard sound is the clock: its position says so.
double Player::played_seconds(double wall_seconds) {
    if (!is_sound_the_clock())
        return wall_seconds * m_speed;
    const double position = m_output->position_seconds();
    return std::max(0.0, position - std::exchange(m_heard, position));
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
    // A window that was held up does not ask for more than this at once; time is then lost, not
    // light.
    constexpr double longest_frame = 0.25;
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
    const double played = std::min(played_seconds(wall_seconds), longest_frame);
    if (played <= 0.0)
        return std::nullopt;
    return moved_to(m_time + played);
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
