#include "lab/editor/external_programs.h"

#include "io/system/process.h"
#include "lab/editor/editor.h"
#include "lab/window/window_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <utility>

namespace fs = std::filesystem;

namespace {
constexpr auto start_time = std::chrono::seconds(10);  // a later failure is not one of the start

MenuEntry copy_button(const fs::path& path) {
    return {.name = "Copy path",
            .commands = {[path = path.string()](WindowState& window) { window.copied = path; }}};
}

MenuEntry folder_button(const fs::path& folder) {
    return {.name = "Open folder",
            .commands = {[folder](ExternalPrograms& programs) { programs.open_folder(folder); }}};
}

MenuEntry choose_button() {
    return {.name = "Choose editor", .commands = {[](WindowState& window) {
                                         window.dialog = {.kind = Dialog::Kind::palette,
                                                          .text = "Editor: "};
                                     }}};
}
}  // namespace

struct ExternalPrograms::Ended {
    std::atomic<int> status = -1;  // -1: it runs
};

ExternalPrograms::ExternalPrograms(Messages& messages, Roots roots)
    : m_messages(messages), m_roots(std::move(roots)), m_editor(load_editor(m_roots)) {}

void ExternalPrograms::choose_editor(const std::string& command) {
    m_editor = command;
    if (m_messages.succeeded(save_editor(m_roots, command)))
        m_messages.say(command.empty() ? "Files open in the desktop's editor"
                                       : fmt::format("Files open with: {}", command));
}

void ExternalPrograms::open_in_editor(const Location& location) {
    const auto command = editor_command(location, m_editor);
    if (command)
        return start(*command, location, location.file.parent_path());
    if (location.file.empty())
        return m_messages.say(command.error().front());
    m_messages.ask(command.error().front().message, {choose_button()});
}

void ExternalPrograms::open_folder(const fs::path& folder) {
    start({"xdg-open", folder.string()}, {}, folder);
}

void ExternalPrograms::open_page(const fs::path& page) {
    m_messages.say(fmt::format("Opening {} in your browser", page.filename().string()));
    start({"xdg-open", page.string()}, {}, page);
}

void ExternalPrograms::start(const std::vector<std::string>& command, Location location,
                             fs::path path) {
    Started started{command.front(), std::move(location), std::move(path),
                    std::chrono::steady_clock::now(), std::make_shared<Ended>()};
    const int error = start_detached(command, [ended = started.ended, wake = m_wake](int status) {
        ended->status = status;
        if (wake)
            wake();
    });
    if (error != 0)
        return report(started, error == ENOENT ? "" : std::strerror(error));
    m_started.push_back(std::move(started));
}

void ExternalPrograms::update() {
    const auto now = std::chrono::steady_clock::now();
    std::vector<Started> all = std::exchange(m_started, {});
    for (Started& started : all) {
        const int status = started.ended->status;
        if (status > 0)
            report(started, fmt::format("exited with status {}", status));
        else if (status < 0 && now - started.time < start_time)
            m_started.push_back(std::move(started));
    }
}

// `reason` "": the program was not found.
void ExternalPrograms::report(const Started& started, const std::string& reason) {
    const bool is_editor = !started.location.file.empty();
    const fs::path& path = is_editor ? started.location.file : started.path;
    const std::string text = reason.empty()
                                 ? fmt::format("{} was not found, so {} can't be opened.",
                                               started.program, path.filename().string())
                                 : fmt::format("{} could not open {}: {}.", started.program,
                                               path.filename().string(), reason);
    if (!is_editor)
        return m_messages.ask(text + " Copy its path.", {copy_button(path)});
    m_messages.ask(text + " Choose an editor.", {choose_button(), folder_button(started.path),
                                                 copy_button(started.location.file)});
}
