#include "formats/slang/settings.h"

#include "base/text.h"
#include "formats/slang/slang_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace fs = std::filesystem;

namespace {
constexpr std::size_t max_open_settings = 16;
constexpr int max_settings_includes = 256;
constexpr std::size_t max_settings_references = 256;
constexpr std::string_view blanks = " \t\r\n\f\v";

struct Line {
    std::string_view key;
    std::string_view value;
};

// The quoted text at the start of `text`, or its first word without a final ';'. Unclosed quotes
// extend to the end of the line.
std::string_view value_of(std::string_view text) {
    if (text.starts_with('"'))
        return trim(text.substr(1, text.find('"', 1) - 1));
    text = text.substr(0, text.find_first_of(blanks));
    return text.substr(0, text.find_last_not_of(';') + 1);
}

// Removes a comment that starts with '#' outside quotes.
std::string_view without_comment(std::string_view line) {
    bool is_quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"')
            is_quoted = !is_quoted;
        else if (line[i] == '#' && !is_quoted)
            return line.substr(0, i);
    }
    return line;
}

std::optional<Line> key_and_value(std::string_view line) {
    const std::size_t key_end = line.find_first_of(" \t=");
    if (key_end == 0 || key_end == std::string_view::npos)
        return std::nullopt;
    const std::string_view rest = trim(line.substr(key_end));
    if (!rest.starts_with('='))
        return std::nullopt;
    return Line{line.substr(0, key_end), value_of(trim(rest.substr(1)))};
}

// The argument after `word` on a line that starts with it.
std::optional<std::string_view> argument_of(std::string_view line, std::string_view word) {
    if (!line.starts_with(word))
        return std::nullopt;
    const std::string_view rest = line.substr(word.size());
    if (rest.empty() || (blanks.find(rest.front()) == rest.npos && rest.front() != '"'))
        return std::nullopt;
    return value_of(trim(rest));
}

class SettingsReader {
public:
    SettingsReader(SlangFiles& files, Diagnostics& warnings)
        : m_files(files), m_warnings(warnings) {}

    Result<SlangSettings> read(const fs::path& file) {
        m_read.file = file;
        const auto text = m_files.read(file);
        if (!text)
            return fail(text.error());
        add(**text);
        if (!m_errors.empty())
            return fail(std::move(m_errors));
        return std::move(m_read);
    }

private:
    void add(const SlangText& text) {
        m_open.push_back(&text);
        Location at{text.file, 0};
        bool is_in_block = false;
        for (const std::string_view whole : split_lines(text.text)) {
            ++at.line;
            const std::string_view line = trim(whole);
            is_in_block = is_in_block || line.starts_with("/*");
            if (!line.empty() && !line.starts_with("//"))
                add_line(line, at, is_in_block);
            if (line.find("*/") != line.npos)
                is_in_block = false;
        }
        m_open.pop_back();
    }

    void add_line(std::string_view line, const Location& at, bool is_in_block) {
        if (const auto path = argument_of(line, "#reference"))
            add_reference(*path, at);
        else if (const auto included = argument_of(line, "#include"))
            include(*included, at);
        else if (line.starts_with('#'))
            return;
        else if (const auto pair = key_and_value(without_comment(line)))
            add_setting(*pair, at);
        else if (!is_in_block)
            warn(at, "expected 'key = value'; this line is ignored");
    }

    void add_reference(std::string_view path, const Location& at) {
        if (m_read.references.size() < max_settings_references)
            m_read.references.push_back({{}, readable_text(path), at});
        else if (!std::exchange(m_has_too_many_references, true))
            refuse(at, fmt::format("the preset has more references than the limit of {}",
                                   max_settings_references));
    }

    void add_setting(const Line& line, const Location& at) {
        SlangSetting setting{readable_text(line.key), readable_text(line.value), at};
        const auto [found, is_new] = m_read.indices.emplace(setting.key, m_read.settings.size());
        if (is_new) {
            m_read.settings.push_back(std::move(setting));
            return;
        }
        const SlangSetting& first = m_read.settings[found->second];
        if (first.value != setting.value)
            warn(at, fmt::format("'{}' is already set to '{}' on line {}; this line is ignored",
                                 setting.key, first.value, first.declared.line));
    }

    void include(std::string_view path, const Location& at) {
        if (std::string fault = fault_of_slang_path(path); !fault.empty())
            return refuse(at, std::move(fault));
        const fs::path wanted = sibling_path(at.file, path);
        const auto text = m_files.read(wanted);
        if (!text)
            refuse(at, fmt::format("can't include '{}': {}", readable_text(path),
                                   text.error().front().message));
        else if (std::ranges::find(m_open, *text) != m_open.end())
            refuse(at, "circular #include");
        else if (m_open.size() >= max_open_settings)
            refuse(at, fmt::format("includes are nested deeper than the limit of {} levels",
                                   max_open_settings));
        else if (++m_included > max_settings_includes)
            refuse(at, fmt::format("the preset has more includes than the limit of {}",
                                   max_settings_includes));
        else if (std::string fault = m_files.count_settings(**text); !fault.empty())
            refuse(at, std::move(fault));
        else if (m_errors.empty())
            add(**text);
    }

    void refuse(const Location& at, std::string message) {
        add_new(m_errors, {at.file, at.line, std::move(message)});
    }

    void warn(const Location& at, std::string message) {
        add_new(m_warnings, {at.file, at.line, std::move(message), Severity::warning});
    }

    SlangFiles& m_files;
    Diagnostics& m_warnings;
    SlangSettings m_read;
    std::vector<const SlangText*> m_open;
    Diagnostics m_errors;
    int m_included = 0;
    bool m_has_too_many_references = false;
};
}  // namespace

const SlangSetting* SlangSettings::find(const std::string& key) const {
    const auto found = indices.find(key);
    return found == indices.end() ? nullptr : &settings[found->second];
}

Result<SlangSettings> read_slang_settings(const fs::path& file, SlangFiles& files,
                                          Diagnostics& warnings) {
    return SettingsReader(files, warnings).read(file);
}

std::optional<bool> read_slang_boolean(const SlangSetting& setting, Diagnostics& warnings) {
    std::string word = to_lower(setting.value);
    while (word.ends_with(';'))
        word.pop_back();
    if (word == "true" || word == "1")
        return true;
    if (word == "false" || word == "0")
        return false;
    add_new(warnings,
            {setting.declared.file, setting.declared.line,
             fmt::format("'{}' must be true or false, got '{}'", setting.key, setting.value),
             Severity::warning});
    return std::nullopt;
}

double read_slang_number(const SlangSetting& setting, Diagnostics& warnings) {
    const auto number = leading_number(setting.value);
    if (!number)
        add_new(warnings, {setting.declared.file, setting.declared.line,
                           fmt::format("'{}' must be a number, got '{}'; 0 is used", setting.key,
                                       setting.value),
                           Severity::warning});
    std::string note = decimal_comma_note(setting.key, setting.value);
    if (number && !note.empty())
        add_new(warnings,
                {setting.declared.file, setting.declared.line, std::move(note), Severity::warning});
    return number.value_or(0.0);
}
