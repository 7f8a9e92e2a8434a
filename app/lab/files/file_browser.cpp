#include "lab/files/file_browser.h"

#include "lab/storage/display_name.h"

#include <fmt/format.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace {
using ChoiceKind = FileChoice::Kind;

FileChoice chosen_path(const fs::path& path, const FileRules& rules) {
    std::error_code error;
    const bool is_look = rules.opens_looks && fs::exists(path / "look.json", error);
    if (is_folder(path) && !is_look)
        return {ChoiceKind::enter_folder, path};
    return {ChoiceKind::choose, path};
}

FileChoice failed(std::string problem) {
    return {ChoiceKind::fail, {}, std::move(problem)};
}

// A name from a message, with the folder if it is not the listed one.
std::string missing_text(const TypedPath& typed) {
    return fmt::format("\"{}\" was not found in {}.", typed.name, display_folder(typed.folder));
}

FileChoice saved_path(const FileBrowser& browser, const TypedPath& typed, const FileRules& rules) {
    const NameCheck check = check_file_name(typed.name, rules.names());
    if (!check.is_valid)
        return check.problem.empty() ? FileChoice() : failed(check.problem);
    const fs::path file = typed.folder / with_extension(typed.name, rules.names());
    std::error_code error;
    if (is_folder(file))
        return {ChoiceKind::enter_folder, file};
    if (fs::exists(file, error) && browser.replaced != file)
        return {ChoiceKind::ask_to_replace, file,
                fmt::format("\"{}\" already exists. Replace it?", file.filename().string())};
    return {ChoiceKind::choose, file};
}
}  // namespace

TypedPath shown_path(const FileBrowser& browser) {
    return parse_typed_path(browser.text, browser.folder, home_folder());
}

FileFilter filter_of(const FileBrowser& browser, const FileRules& rules, const FileOrder& order,
                     bool shows_hidden) {
    return {.typed = rules.is_saving ? std::string() : shown_path(browser).name,
            .order = order,
            .shows_hidden = shows_hidden};
}

std::string highlighted(const FileBrowser& browser, const FileRules& rules,
                        const std::vector<FolderEntry>& rows) {
    if (std::ranges::find(rows, browser.selected, &FolderEntry::name) != rows.end())
        return browser.selected;
    const bool has_match = !rules.is_saving && !rows.empty() && !shown_path(browser).name.empty();
    return has_match ? rows.front().name : std::string();
}

void type_text(FileBrowser& browser, std::string text) {
    browser.text = std::move(text);
    browser.selected.clear();
    browser.problem.clear();
    browser.replaced.clear();
    browser.is_accepting = false;
    browser.shows_selection = true;
}

void select_row(FileBrowser& browser, const FileRules& rules, const FolderEntry& row) {
    if (rules.is_saving && !row.is_folder) {
        browser.folder = shown_path(browser).folder;
        type_text(browser, row.name);
    }
    browser.selected = row.name;
    browser.problem.clear();
    browser.replaced.clear();
    browser.shows_selection = false;
}

void move_selection(FileBrowser& browser, const FileRules& rules,
                    const std::vector<FolderEntry>& rows, int by) {
    if (rows.empty() || by == 0)
        return;
    const auto last = static_cast<std::ptrdiff_t>(rows.size()) - 1;
    const auto current =
        std::ranges::find(rows, highlighted(browser, rules, rows), &FolderEntry::name);
    const std::ptrdiff_t next =
        current == rows.end() ? (by > 0 ? 0 : last)
                              : std::clamp(current - rows.begin() + by, std::ptrdiff_t{0}, last);
    select_row(browser, rules, rows[static_cast<std::size_t>(next)]);
    browser.shows_selection = true;
}

void enter_folder(FileBrowser& browser, const FileRules& rules, const fs::path& folder) {
    const TypedPath typed = shown_path(browser);
    std::string kept = rules.is_saving && typed.file() != folder ? typed.name : std::string();
    browser = FileBrowser{.folder = folder.lexically_normal(), .text = std::move(kept)};
}

FileChoice accepted(const FileBrowser& browser, const FileRules& rules,
                    const std::vector<FolderEntry>& rows) {
    const TypedPath typed = shown_path(browser);
    const auto row = std::ranges::find(rows, browser.selected, &FolderEntry::name);
    if (!browser.selected.empty() && row != rows.end() && (row->is_folder || !rules.is_saving))
        return accepted_row(browser, rules, *row);
    if (!is_folder(typed.folder))
        return failed(fmt::format("The folder {} was not found.", display_folder(typed.folder)));
    if (typed.name.empty())
        return browser.text.empty() ? FileChoice() : chosen_path(typed.folder, rules);
    if (rules.is_saving)
        return is_folder(typed.file()) ? FileChoice{ChoiceKind::enter_folder, typed.file()}
                                       : saved_path(browser, typed, rules);
    std::error_code error;
    if (fs::exists(typed.file(), error))
        return chosen_path(typed.file(), rules);
    if (!rows.empty())
        return accepted_row(browser, rules, rows.front());
    return failed(missing_text(typed));
}

bool needs_rows(const FileBrowser& browser, const FileRules& rules) {
    std::error_code error;
    return !browser.selected.empty() ||
           (!rules.is_saving && !fs::exists(shown_path(browser).file(), error));
}

FileChoice accepted_row(const FileBrowser& browser, const FileRules& rules,
                        const FolderEntry& row) {
    const TypedPath typed = shown_path(browser);
    if (rules.is_saving && !row.is_folder)
        return saved_path(browser, {typed.folder, row.name}, rules);
    std::error_code error;
    if (!fs::exists(typed.folder / row.name, error))
        return failed(missing_text({typed.folder, row.name}));
    return chosen_path(typed.folder / row.name, rules);
}

NameCheck check_typed_name(const FileBrowser& browser, const FileRules& rules) {
    const TypedPath typed = shown_path(browser);
    if (!rules.is_saving || typed.name.empty() || is_folder(typed.file()))
        return {.is_valid = !browser.text.empty() || !browser.selected.empty()};
    NameCheck check = check_file_name(typed.name, rules.names());
    if (!check.suggestion.empty()) {
        const std::size_t slash = browser.text.rfind('/');
        const std::size_t start = slash == std::string::npos ? 0 : slash + 1;
        check.suggestion = browser.text.substr(0, start) + check.suggestion;
    }
    return check;
}

void apply_choice(FileBrowser& browser, const FileRules& rules, const FileChoice& choice) {
    browser.is_accepting = false;
    if (choice.kind == ChoiceKind::enter_folder)
        return enter_folder(browser, rules, choice.path);
    browser.problem = choice.problem;
    browser.replaced = choice.kind == ChoiceKind::ask_to_replace ? choice.path : fs::path();
}
