#pragma once

#include "lab/messages/messages.h"
#include "lab/offline/prepared_look.h"
#include "lab/storage/background_work.h"

#include <filesystem>
#include <optional>
#include <string>

/// Where to send a look.
struct SendSettings {
    std::size_t program = 0;  // index of running_programs()
    std::string address;
    bool follows = false;  // send again after each edit
};

/// Exports a look to a folder for temporary files, and tells a running program to load it. The
/// folder keeps the last two exports, because programs can read them later.
Result<void> send_look(const PreparedLook& prepared, Extent size, const SendSettings& settings,
                       const std::filesystem::path& folder);

/// Sends a copy of the document on a background thread, also after each edit: at most four times a
/// second, until it fails.
class LookSender {
public:
    /// `folder`: for temporary files.
    explicit LookSender(std::filesystem::path folder) : m_folder(std::move(folder)) {}

    void send(const Document& document, const PassSwitches& switches, Extent size,
              const SendSettings& settings);
    void stop_following() { m_settings.follows = false; }
    bool is_following() const { return m_settings.follows; }
    const SendSettings& settings() const { return m_settings; }
    const BackgroundWork<bool>& work() const { return m_work; }

    /// Call it in every update. `document` null: no look is open. `wall_seconds`: since the
    /// last update.
    void update(const Document* document, const PassSwitches& switches, Extent size,
                Messages& messages, double wall_seconds);
    /// Whether an export runs or waits.
    bool is_busy() const { return m_work.is_running() || m_is_waiting; }

private:
    bool has_changed(const Document& document, const PassSwitches& switches) const;

    std::filesystem::path m_folder;
    SendSettings m_settings;
    BackgroundWork<bool> m_work;
    double m_age = 0.0;          // of the last export, s
    std::optional<Look> m_look;  // as sent last
    DocumentState m_state;
    PassSwitches m_switches;
    bool m_is_waiting = false;
    bool m_is_reported = true;  // the outcome
};
