#include "lab/files/typed_path.h"

#include "base/file_uri.h"
#include "base/text.h"

#include <algorithm>
#include <cstdlib>

namespace fs = std::filesystem;

namespace {
// Without the quotes of a path that was copied from a terminal.
std::string_view unquoted(std::string_view text) {
    text = trim(text);
    const bool is_quoted = text.size() >= 2 && text.front() == text.back() &&
                           (text.front() == '\'' || text.front() == '"');
    return is_quoted ? text.substr(1, text.size() - 2) : text;
}

// The beginning that two names share, ignoring case.
std::size_t shared_length(const std::string& one, const std::string& other) {
    const std::string a = to_lower(one);
    const std::string b = to_lower(other);
    return static_cast<std::size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
}

// The start of a UTF-8 character at or before `at`.
std::size_t character_start(const std::string& text, std::size_t at) {
    while (at > 0 && at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U)
        --at;
    return at;
}

// The start of the name in a typed text.
std::size_t name_start(const std::string& text) {
    const std::size_t slash = text.rfind('/');
    return slash == std::string::npos ? 0 : slash + 1;
}
}  // namespace

fs::path home_folder() {
    const char* home = std::getenv("HOME");
    return home && *home == '/' ? fs::path(home) : fs::path("/");
}

TypedPath parse_typed_path(std::string_view text, const fs::path& folder, const fs::path& home) {
    std::string path(unquoted(text));
    if (const fs::path of_uri = path_of_uri(path); !of_uri.empty())
        path = of_uri.string();
    if (path == "~" || path.starts_with("~/"))
        path = home.string() + (path == "~" ? "/" : path.substr(1));
    const std::size_t start = name_start(path);
    TypedPath typed{folder / path.substr(0, start), path.substr(start)};
    if (typed.name == "." || typed.name == "..") {
        typed.folder /= typed.name;
        typed.name.clear();
    }
    typed.folder = typed.folder.lexically_normal();
    if (!typed.folder.has_filename() && typed.folder.has_relative_path())
        typed.folder = typed.folder.parent_path();  // without the last '/'
    return typed;
}

std::string completed_path(const std::string& text, const std::vector<FolderEntry>& rows) {
    const std::size_t start = name_start(text);
    const std::string name = text.substr(start);
    if (name == "~" || name == "..")
        return text + "/";
    if (name.empty() || rows.empty())
        return text;
    std::string common;
    const FolderEntry* first = nullptr;  // that begins with the name, or contains it
    int count = 0;
    for (const FolderEntry& row : rows) {
        const std::size_t at = to_lower(row.name).find(to_lower(name));
        if (!first && at != std::string::npos)
            first = &row;
        if (at != 0)
            continue;
        if (count++ == 0) {
            first = &row;
            common = row.name;
        }
        common.resize(character_start(common, shared_length(common, row.name)));
    }
    if (count > 1 && common.size() > name.size())
        return text.substr(0, start) + common;
    return first ? text.substr(0, start) + first->name + (first->is_folder ? "/" : "") : text;
}
