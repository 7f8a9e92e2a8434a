#include "lab/editor/editor.h"

#include "base/file.h"
#include "base/text.h"
#include "io/files/atomic_file.h"
#include "io/system/process.h"
#include "lab/editor/split_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace {
std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value ? std::string(trim(value)) : std::string();
}

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

// The path of an existing program is not split at its blanks. `origin`: "$VISUAL".
Result<std::vector<std::string>> words_of(const std::string& origin, const std::string& editor) {
    std::error_code error;
    if (std::filesystem::is_regular_file(editor, error))
        return std::vector{editor};
    auto words = split_command(editor);
    if (!words || words->empty() || words->front().empty())
        return fail({{},
                     0,
                     fmt::format("{} is not a valid command: {}. Close its quotes, as in "
                                 "'\"/opt/My Editor/ed\" -w'.",
                                 origin, editor)});
    return std::move(*words);
}

std::string replaced(std::string text, std::string_view name, const std::string& value) {
    for (auto at = text.find(name); at != std::string::npos;
         at = text.find(name, at + value.size()))
        text.replace(at, name.size(), value);
    return text;
}

// An absolute path cannot be mistaken for an option or a command such as "+!ls".
std::vector<std::string> with_location(std::vector<std::string> command, const Location& location) {
    const std::string name = std::filesystem::path(command.front()).filename();
    const std::string file = std::filesystem::absolute(location.file).string();
    const int line = std::max(1, location.line);
    if (std::ranges::any_of(command, [](const std::string& word) {
            return word.find("{file}") != std::string::npos;
        })) {
        for (std::string& word : command)
            word = replaced(replaced(word, "{line}", std::to_string(line)), "{file}", file);
        return command;
    }
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

std::filesystem::path editor_file_in(const Roots& roots) {
    return roots.state / "editor.txt";
}

// A pass inside a JSON file has a path below that file. Opens the file at line 1, because the line
// in the pass differs.
Location location_on_disk(const Location& location) {
    std::error_code error;
    const std::filesystem::path whole = location.file.parent_path();
    return std::filesystem::is_regular_file(whole, error) ? Location{whole, 1} : location;
}
}  // namespace

std::vector<EditorInfo> installed_editors() {
    // In a terminal unless the program opens its own window.
    const std::vector<EditorInfo> known{
        {"Visual Studio Code", "code --goto {file}:{line}"},
        {"VSCodium", "codium --goto {file}:{line}"},
        {"Sublime Text", "subl {file}:{line}"},
        {"Zed", "zed {file}:{line}"},
        {"Kate", "kate --line {line} {file}"},
        {"Text Editor", "gnome-text-editor {file}"},
        {"gedit", "gedit {file} +{line}"},
        {"Mousepad", "mousepad --line={line} {file}"},
        {"Geany", "geany --line {line} {file}"},
        {"Emacs", "emacs +{line} {file}"},
        {"GVim", "gvim +{line} {file}"},
        {"Neovim", "x-terminal-emulator -e nvim +{line} {file}"},
        {"Vim", "x-terminal-emulator -e vim +{line} {file}"},
        {"Helix", "x-terminal-emulator -e hx {file}:{line}"},
        {"micro", "x-terminal-emulator -e micro {file}:{line}"},
        {"nano", "x-terminal-emulator -e nano +{line} {file}"},
    };
    std::vector<EditorInfo> found;
    for (const EditorInfo& editor : known) {
        const auto words = split_command(editor.command);
        const bool is_in_terminal = words->front() == "x-terminal-emulator";
        if (is_in_path(words->at(is_in_terminal ? 2 : 0)) &&
            (!is_in_terminal || is_in_path(words->front())))
            found.push_back(editor);
    }
    return found;
}

Result<std::vector<std::string>> editor_command(const Location& asked, const std::string& chosen) {
    if (asked.file.empty())
        return fail({{}, 0, "this look has no shader file to open"});
    const Location location = location_on_disk(asked);
    std::vector<std::pair<std::string, std::string>> commands{{"the chosen editor", chosen}};
    for (const char* name : {"VISUAL", "EDITOR"})
        commands.emplace_back(fmt::format("${}", name), variable(name));
    for (const auto& [origin, command] : commands) {
        if (command.empty())
            continue;
        auto words = words_of(origin, command);
        if (!words)
            return fail(words.error());
        return with_location(std::move(*words), location);
    }
    return with_location({"xdg-open"}, location);
}

std::string load_editor(const Roots& roots) {
    return std::string(trim(read_text(editor_file_in(roots)).value_or("")));
}

Result<void> save_editor(const Roots& roots, const std::string& command) {
    return write_atomically(editor_file_in(roots), command + '\n');
}
