#include "lab/document/output_name.h"

#include "base/text.h"
#include "lab/document/opened_preset.h"

#include <fmt/format.h>

#include <cctype>
#include <cstdlib>

namespace fs = std::filesystem;

namespace {
// Small letters, digits, + and _; a hyphen for each run of others.
std::string simple_name(std::string_view text) {
    std::string name;
    for (const char letter : to_lower(std::string(text))) {
        const bool is_plain =
            std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '+' || letter == '_';
        if (is_plain && static_cast<unsigned char>(letter) < 128)
            name += letter;
        else if (!name.empty() && name.back() != '-')
            name += '-';
    }
    while (name.ends_with('-'))
        name.pop_back();
    constexpr std::size_t longest = 60;
    return name.substr(0, longest);
}
}  // namespace

std::string output_stem(const Document& document, const Date& date) {
    std::string stem = simple_name(document.look().id);
    if (const std::string preset = simple_name(preset_name(document)); !preset.empty())
        stem += "-" + preset;
    if (stem.empty())
        stem = "afterglow";
    return fmt::format("{}-{:04}-{:02}-{:02}", stem, date.year, date.month, date.day);
}

std::string unused_name(const fs::path& folder, const std::string& stem,
                        const std::string& ending) {
    constexpr int most = 1000;
    std::error_code ignored;
    std::string name = stem + ending;
    for (int number = 2; number < most && fs::exists(folder / name, ignored); ++number)
        name = fmt::format("{}-{}{}", stem, number, ending);
    return name;
}

bool has_own_folder(const std::string& text) {
    const std::string_view name = trim(text);
    return name.starts_with("~/") || fs::path(name).is_absolute();
}

fs::path typed_file(const std::string& text, const fs::path& folder) {
    const std::string name(trim(text));
    const char* const home = std::getenv("HOME");
    if (home && (name == "~" || name.starts_with("~/")))
        return fs::path(home) / (name.size() > 2 ? name.substr(2) : "");
    return (folder / name).lexically_normal();
}
