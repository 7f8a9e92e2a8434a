#include "lab/storage/editor.h"

#include "base/text.h"
#include "io/system/process.h"
#include "lab/storage/split_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace {
std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value ? std::string(trim(value)) : std::string();
}

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

// The path of an existing program is not split at its blanks.
Result<std::vector<std::string>> editor_command(const char* variable_name,
                                                const std::string& editor) {
    std::error_code error;
    if (std::filesystem::is_regular_file(editor, error))
        return std::vector{editor};
    auto words = split_command(editor);
    if (!words || words->empty() || words->front().empty())
        return fail({{},
                     0,
                     fmt::format("${} is not a valid command: {}. Close its quotes, as in "
                                 "'\"/opt/My Editor/ed\" -w'.",
                                 variable_name, editor)});
    return std::move(*words);
}

// An absolute path cannot be mistaken for an option or a command such as "+!ls".
std::vector<std::string> with_location(std::vector<std::string> command, const Location& location) {
    const std::string name = std::filesystem::path(command.front()).filename();
    const std::string file = std::filesystem::absolute(location.file).string();
    const int line = std::max(1, location.line);
    if (is_one_of(name, {"code", "codium", "code-insiders", "cursor"})) {
        command.emplace_back("--goto");
        command.push_back(fmt::format("{}:{}", file, line));
    } else if (is_one_of(name, {"subl", "zed", "hx", "helix", "micro", "atom"})) {
        command.push_back(fmt::format("{}:{}", file, line));
    } else if (name == "xdg-open") {
        command.push_back(file);
    } else {
        command.push_back(fmt::format("+{}", line));
        command.push_back(file);
    }
    if (is_one_of(name, {"vi", "vim", "nvim", "nano", "micro", "hx", "helix", "joe", "ne", "mg"}))
        command.insert(command.begin(), {"x-terminal-emulator", "-e"});
    return command;
}

// A pass inside a JSON file has a path below that file. Opens the file at line 1, because the line
// in the pass differs.
Location location_on_disk(const Location& location) {
    std::error_code error;
    const std::filesystem::path whole = location.file.parent_path();
    return std::filesystem::is_regular_file(whole, error) ? Location{whole, 1} : location;
}
}  // namespace

Result<std::vector<std::string>> editor_command(const Location& asked) {
    if (asked.file.empty())
        return fail({{}, 0, "there is no shader file to open"});
    const Location location = location_on_disk(asked);
    for (const char* name : {"VISUAL", "EDITOR"})
        if (const std::string editor = variable(name); !editor.empty()) {
            auto words = editor_command(name, editor);
            if (!words)
                return fail(words.error());
            return with_location(std::move(*words), location);
        }
    return with_location({"xdg-open"}, location);
}

Result<void> open_in_editor(const Location& location) {
    const auto command = editor_command(location);
    if (!command)
        return fail(command.error());
    if (const int error = start_detached(*command); error != 0)
        return fail({location.file, location.line,
                     fmt::format("can't start '{}': {}. Set $VISUAL to your editor.",
                                 command->front(), std::strerror(error))});
    return {};
}

Result<void> open_folder(const std::filesystem::path& folder) {
    if (const int error = start_detached({"xdg-open", folder.string()}); error != 0)
        return fail({folder, 0, fmt::format("can't start xdg-open: {}", std::strerror(error))});
    return {};
}
