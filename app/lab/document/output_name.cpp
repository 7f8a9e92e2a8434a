#include "lab/document/output_name.h"

#include "base/text.h"
#include "io/pictures/frame_names.h"
#include "lab/document/opened_preset.h"
#include "lab/files/typed_path.h"

#include <fmt/format.h>

#include <cctype>

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

std::string unused_name(const fs::path& folder, const std::string& stem, const std::string& ending,
                        const IsTaken& is_taken) {
    constexpr int most = 10000;
    const auto is_used = [&](const fs::path& file) {
        const auto names = parse_frame_names(file.string());
        return (names && names->exist()) || is_taken(file);
    };
    std::string name = stem + ending;
    for (int number = 2; number < most && is_used(folder / name); ++number)
        name = fmt::format("{}-{}{}", stem, number, ending);
    return name;
}

bool has_own_folder(const std::string& text) {
    const std::string_view name = trim(text);
    return name.starts_with("~/") || fs::path(name).is_absolute();
}

fs::path typed_file(const std::string& text, const fs::path& folder) {
    return parse_typed_path(text, folder, home_folder()).file();
}

fs::path usual_folder(const fs::path& last) {
    std::error_code error;
    return fs::is_directory(last, error) ? last : fs::current_path(error);
}
