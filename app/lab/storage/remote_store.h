#pragma once

#include "lab/storage/roots.h"
#include "model/devices/remote_settings.h"

/// The stored settings of remote control; the defaults if the file does not exist. Only the first
/// window listens to OSC when it starts, because others would need another port. Saving in another
/// window does not change that.
Result<RemoteSettings> load_remote_settings(const Roots& roots);
Result<void> save_remote_settings(const Roots& roots, const RemoteSettings& settings);
