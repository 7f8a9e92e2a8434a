// The part of Lab that lets other programs turn parameters.
#include "lab/lab.h"
#include "lab/remote_store.h"

void Lab::set_remote_settings(const RemoteSettings& settings) {
    const bool is_other = settings != m_remote || settings.listens_to_osc != m_osc.is_listening();
    m_remote = settings;
    if (is_other)
        succeeded(m_osc.listen(settings.listens_to_osc ? settings.osc_port : 0));
    succeeded(save_remote_settings(m_library.roots(), settings));
}

void Lab::open_remote() {
    const auto settings = load_remote_settings(m_library.roots());
    if (!succeeded(settings))
        return;
    m_remote = *settings;
    if (m_remote.listens_to_osc)
        succeeded(m_osc.listen(m_remote.osc_port));
}

void Lab::listen(double wall_seconds) {
    m_listened_seconds += wall_seconds;
    const std::size_t refused = m_osc.refused();
    m_osc.update(m_document ? &*m_document : nullptr, m_listened_seconds);
    constexpr const char* subject = "OSC";
    if (m_osc.refused() > refused)
        say("OSC: " + m_osc.problem(), true, subject);
}
