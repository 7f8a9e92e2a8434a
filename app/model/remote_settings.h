#pragma once

/// What other programs may turn; the user's settings, in no preset.
struct RemoteSettings {
    bool listens_to_osc = false;
    int osc_port = 9000;

    bool operator==(const RemoteSettings&) const = default;
};
