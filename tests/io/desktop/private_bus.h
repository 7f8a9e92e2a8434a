#pragma once

#include "io/system/child_process.h"
#include "io/system/environment.h"
#include "io/temporary_folder.h"

#include <cstdlib>
#include <optional>
#include <string>

/// A session bus of its own, by a dbus-daemon that ends with it. It starts no services, so that no
/// portal of the machine takes part. $DBUS_SESSION_BUS_ADDRESS names it during its lifetime.
class PrivateBus {
public:
    PrivateBus() {
        const auto config = m_folder.write("bus.conf", R"(<busconfig>
  <type>session</type>
  <listen>unix:tmpdir=/tmp</listen>
  <policy context="default">
    <allow send_destination="*"/>
    <allow receive_sender="*"/>
    <allow own="*"/>
  </policy>
</busconfig>
)");
        auto daemon = ChildProcess::start({"dbus-daemon", "--config-file=" + config.string(),
                                           "--nofork", "--nopidfile", "--print-address=1"});
        if (!daemon)
            return;
        m_daemon.emplace(std::move(*daemon));
        std::string address;
        for (char letter = 0; m_daemon->read(&letter, 1) == 1 && letter != '\n';)
            address += letter;
        set_environment("DBUS_SESSION_BUS_ADDRESS", address.c_str());
        m_is_running = !address.empty();
    }
    ~PrivateBus() {
        m_daemon.reset();
        set_environment("DBUS_SESSION_BUS_ADDRESS", "disabled:");
    }
    PrivateBus(const PrivateBus&) = delete;
    PrivateBus& operator=(const PrivateBus&) = delete;

    bool is_running() const { return m_is_running; }
    /// Ends the bus.
    void end() { m_daemon.reset(); }

private:
    TemporaryFolder m_folder;
    std::optional<ChildProcess> m_daemon;
    bool m_is_running = false;
};
