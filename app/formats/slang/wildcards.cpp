#include "formats/slang/wildcards.h"

#include <array>
#include <optional>
#include <utility>

namespace fs = std::filesystem;

namespace {
constexpr std::array<std::pair<std::string_view, std::string_view>, 10> desktop_words{{
    {"VID-DRV", "glcore"},
    {"VID-DRV-SHADER-EXT", "slang"},
    {"VID-DRV-PRESET-EXT", "slangp"},
    {"CORE-REQ-ROT", "CORE-REQ-ROT-0"},
    {"VID-ALLOW-CORE-ROT", "VID-ALLOW-CORE-ROT-OFF"},
    {"VID-USER-ROT", "VID-USER-ROT-0"},
    {"VID-FINAL-ROT", "VID-FINAL-ROT-0"},
    {"SCREEN-ORIENT", "SCREEN-ORIENT-0"},
    {"VIEW-ASPECT-ORIENT", "VIEW-ASPECT-ORIENT-HORZ"},
    {"CORE-ASPECT-ORIENT", "CORE-ASPECT-ORIENT-HORZ"},
}};

std::optional<std::string> meaning_of(std::string_view token, const fs::path& opened) {
    if (token == "PRESET")
        return opened.stem().string();
    if (token == "PRESET-DIR")
        return opened.parent_path().filename().string();
    for (const auto& [name, meaning] : desktop_words)
        if (token == name)
            return std::string(meaning);
    return std::nullopt;
}
}  // namespace

std::string with_wildcards_replaced(std::string_view written, const fs::path& opened) {
    std::string path;
    while (!written.empty()) {
        const std::size_t open = written.find('$');
        const std::size_t close = open == written.npos ? open : written.find('$', open + 1);
        if (close == written.npos)
            break;
        const auto meaning = meaning_of(written.substr(open + 1, close - open - 1), opened);
        // The second '$' of an unknown token may start another token.
        const std::size_t done = meaning ? close + 1 : close;
        path += written.substr(0, meaning ? open : close);
        path += meaning.value_or("");
        written.remove_prefix(done);
    }
    return path.append(written);
}

fs::path find_slang_file(std::string_view written, const fs::path& from, const fs::path& opened,
                         SlangFiles& files) {
    const std::string replaced = with_wildcards_replaced(written, opened);
    if (replaced != written) {
        fs::path file = sibling_path(from, replaced);
        files.note(file);
        std::error_code unknown;
        if (fs::exists(file, unknown))
            return file;
    }
    fs::path file = sibling_path(from, written);
    files.note(file);
    return file;
}
