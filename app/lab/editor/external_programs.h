#pragma once

#include "lab/editor/editor.h"
#include "lab/messages/messages.h"
#include "lab/storage/roots.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

/// Opens files in the user's editor and folders in the file manager. A program that cannot be
/// started, or fails soon after its start, gives a notice that offers other ways.
class ExternalPrograms {
public:
    ExternalPrograms(Messages& messages, Roots roots);

    void open_in_editor(const Location& location);
    void open_folder(const std::filesystem::path& folder);
    /// In the browser.
    void open_page(const std::filesystem::path& page);

    /// The chosen command with {file} and {line}; "": that of the environment or the desktop.
    const std::string& editor() const { return m_editor; }
    /// Suggestions.
    const std::vector<EditorInfo>& installed() const { return m_installed; }
    /// Stores the choice.
    void choose_editor(const std::string& command);

    /// Called on another thread when a program ends.
    void set_wake(std::function<void()> wake) { m_wake = std::move(wake); }
    /// Reports programs that have failed. Call it in every update.
    void update();

private:
    struct Ended;  // shared with the threads that wait for programs
    struct Started {
        std::string program;
        Location location;           // of a file in the editor
        std::filesystem::path path;  // of a folder or page
        std::chrono::steady_clock::time_point time;
        std::shared_ptr<Ended> ended;
    };

    void start(const std::vector<std::string>& command, Location location,
               std::filesystem::path path);
    void report(const Started& started, const std::string& reason);

    Messages& m_messages;
    Roots m_roots;
    std::string m_editor;
    std::vector<EditorInfo> m_installed = installed_editors();
    std::function<void()> m_wake;
    std::vector<Started> m_started;
};
