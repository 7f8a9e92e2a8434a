#include "lab/storage/remote_store.h"

#include "base/file.h"
#include "formats/settings/remote_settings_format.h"
#include "io/files/atomic_file.h"

namespace {
std::filesystem::path remote_file_in(const Roots& roots) {
    return roots.state / "remote.json";
}

Result<RemoteSettings> stored_settings(const Roots& roots) {
    const std::filesystem::path file = remote_file_in(roots);
    std::error_code error;
    if (!std::filesystem::exists(file, error))
        return RemoteSettings{};
    const auto text = read_text(file);
    return text ? parse_remote_settings(*text, file) : fail(text.error());
}
}  // namespace

Result<RemoteSettings> RemoteStore::load() {
    auto settings = stored_settings(m_roots);
    if (settings && m_roots.instance > 1)
        settings->listens_to_osc = false;
    if (settings)
        m_saved = *settings;
    return settings;
}

Result<void> RemoteStore::save(const RemoteSettings& settings) {
    auto stored = stored_settings(m_roots);
    if (!stored)
        return fail(stored.error());
    const auto take = [&](auto RemoteSettings::*field) {
        if (settings.*field != m_saved.*field)
            (*stored).*field = settings.*field;
    };
    if (m_roots.instance <= 1)
        take(&RemoteSettings::listens_to_osc);
    take(&RemoteSettings::osc_port);
    take(&RemoteSettings::osc_reach);
    take(&RemoteSettings::osc_reply_port);
    take(&RemoteSettings::listens_to_midi);
    take(&RemoteSettings::has_soft_takeover);
    take(&RemoteSettings::midi);
    take(&RemoteSettings::midi_commands);
    m_saved = settings;
    return write_atomically(remote_file_in(m_roots), remote_settings_to_json(*stored));
}
