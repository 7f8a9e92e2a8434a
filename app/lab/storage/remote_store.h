#pragma once

#include "lab/storage/roots.h"
#include "model/devices/remote_settings.h"

/// The stored settings of remote control, in remote.json.
class RemoteStore {
public:
    explicit RemoteStore(const Roots& roots) : m_roots(roots) {}

    /// The defaults if the file does not exist. Only the first window listens to OSC when it
    /// starts, because others would need another port.
    Result<RemoteSettings> load();
    /// Saves what has changed since the last load() or save(). Another window may have saved other
    /// settings in the meantime, and only the first window saves whether it listens to OSC. Fails
    /// if the file has errors.
    Result<void> save(const RemoteSettings& settings);

private:
    const Roots& m_roots;
    RemoteSettings m_saved;
};
