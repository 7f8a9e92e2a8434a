#include "lab/playback/audio_control.h"

#include "lab/storage/sound_store.h"

#include <utility>

AudioControl::AudioControl(Player& player, const Roots& roots, Messages& messages)
    : m_player(player), m_roots(roots), m_messages(messages) {
    if (const auto settings = load_sound_settings(m_roots); m_messages.succeeded(settings))
        m_messages.succeeded(m_player.set_sound_settings(*settings));
}

void AudioControl::set_settings(const SoundSettings& settings) {
    m_messages.succeeded(m_player.set_sound_settings(settings));
    m_messages.succeeded(save_sound_settings(m_roots, settings));
}

void AudioControl::update() {
    const PlayedSignal& signal = m_player.signal();
    if (m_player.devices().plays_in_real_time())
        m_warned.clear();
    std::string error = m_player.error();
    if (error == m_reported)
        return;
    constexpr const char* subject = "sound device";
    m_reported = std::move(error);
    if (m_reported.empty())
        return m_messages.withdraw(subject);
    if (!signal.is_live()) {
        if (std::exchange(m_warned, m_reported) != m_reported)
            m_messages.warn(m_reported, subject);
        return;
    }
    if (!signal.live_input().is_muted())
        return m_messages.say(m_reported, true, subject);
    const auto unmute = [this] { m_messages.succeeded(m_player.mute_input(false)); };
    m_messages.ask(m_reported, {{.name = "Unmute", .commands = {unmute}}}, subject, false);
}
