#pragma once

#include "lab/storage/roots.h"
#include "model/devices/remote_settings.h"

/// What the user said about remote control at the last use; the defaults at the first.
Result<RemoteSettings> load_remote_settings(const Roots& roots);
Result<void> save_remote_settings(const Roots& roots, const RemoteSettings& settings);
