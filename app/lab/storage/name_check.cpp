#include "lab/storage/name_check.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace {
constexpr std::size_t max_name_bytes = 100;
constexpr std::size_t max_file_name_bytes = 255;  // of common file systems

bool is_ascii_alphanumeric(char letter) {
    const auto byte = static_cast<unsigned char>(letter);
    return byte < 0x80 && std::isalnum(byte);
}

bool is_of_preset(char letter) {
    return is_ascii_alphanumeric(letter) || static_cast<unsigned char>(letter) >= 0x80 ||
           std::string_view(" -_.()+").find(letter) != std::string_view::npos;
}

bool is_of_look(char letter) {
    return (is_ascii_alphanumeric(letter) && letter == std::tolower(letter)) || letter == '-' ||
           letter == '_';
}

// Cut at the start of a UTF-8 character.
std::string cut_to(std::string text, std::size_t bytes) {
    if (text.size() <= bytes)
        return text;
    while (bytes > 0 && (static_cast<unsigned char>(text[bytes]) & 0xC0U) == 0x80U)
        --bytes;
    text.resize(bytes);
    return text;
}

// The text with one '-' for each run of letters that are not allowed.
std::string with_dashes(std::string_view text, bool (*is_allowed)(char)) {
    std::string name;
    for (const char letter : text)
        if (is_allowed(letter))
            name += letter;
        else if (!name.ends_with('-'))
            name += '-';
    return name;
}

std::string_view without_ends(std::string_view text, std::string_view letters) {
    const std::size_t first = text.find_first_not_of(letters);
    return first == std::string_view::npos
               ? std::string_view()
               : text.substr(first, text.find_last_not_of(letters) - first + 1);
}

NameCheck invalid(std::string problem, std::string suggestion) {
    return {.is_valid = false, .problem = std::move(problem), .suggestion = std::move(suggestion)};
}

std::string joined(std::span<const std::string> extensions) {
    std::string text;
    for (std::size_t i = 0; i < extensions.size(); ++i)
        text += (i == 0 ? "" : i + 1 == extensions.size() ? " or " : ", ") + extensions[i];
    return text;
}

// Whether the part after the last dot looks like the extension of a file: "jpg", not "2 final".
bool is_like_extension(std::string_view extension) {
    constexpr std::size_t longest = 5;  // ".jpeg"
    return extension.size() >= 2 && extension.size() <= longest &&
           std::ranges::all_of(extension.substr(1), is_ascii_alphanumeric) &&
           !std::ranges::all_of(extension.substr(1), [](char c) { return c >= '0' && c <= '9'; });
}
}  // namespace

std::string valid_preset_name(std::string_view text) {
    std::string name = with_dashes(text, is_of_preset);
    name = without_ends(name, " -.");
    return std::string(trim(cut_to(std::move(name), max_name_bytes)));
}

std::string valid_look_id(std::string_view text) {
    const std::string id = with_dashes(to_lower(text), is_of_look);
    return cut_to(std::string(without_ends(id, "-_")), max_name_bytes);
}

NameCheck check_preset_name(std::string_view name) {
    if (name.empty())
        return {};
    const std::string suggestion = valid_preset_name(name);
    if (!std::ranges::all_of(name, is_of_preset))
        return invalid("Use only letters, digits, spaces and - _ . ( ) +", suggestion);
    if (name.front() == '.')
        return invalid("A name can't start with a dot.", suggestion);
    if (trim(name) != name)
        return invalid("A name can't start or end with a space.", suggestion);
    if (name.size() > max_name_bytes)
        return invalid(fmt::format("This name is too long. The limit is {} bytes.", max_name_bytes),
                       suggestion);
    return {.is_valid = true};
}

NameCheck check_look_id(std::string_view id) {
    if (id.empty())
        return {};
    const std::string suggestion = valid_look_id(id);
    if (!std::ranges::all_of(id, is_of_look))
        return invalid("Use only lowercase letters, digits, - and _", suggestion);
    if (!is_ascii_alphanumeric(id.front()))
        return invalid("A name must start with a letter or digit.", suggestion);
    if (id.size() > max_name_bytes)
        return invalid(fmt::format("This name is too long. The limit is {} bytes.", max_name_bytes),
                       suggestion);
    return {.is_valid = true};
}

std::string with_extension(std::string_view name, const FileNameRule& rule) {
    const bool has_one = std::filesystem::path(name).has_extension() || rule.extensions.empty();
    return std::string(name) + (has_one ? "" : rule.extensions.front());
}

NameCheck check_file_name(std::string_view name, const FileNameRule& rule) {
    if (name.empty())
        return {};
    if (name == "." || name == "..")
        return invalid("Type a file name.", {});
    const std::string whole = with_extension(name, rule);
    const std::filesystem::path path(whole);
    const std::string extension = to_lower(path.extension().string());
    if (!rule.extensions.empty() && std::ranges::count(rule.extensions, extension) == 0) {
        const std::string& first = rule.extensions.front();
        const std::string suggestion =
            is_like_extension(extension) ? path.stem().string() + first : whole + first;
        return invalid(fmt::format("{} are saved as {}.", rule.content, joined(rule.extensions)),
                       suggestion);
    }
    if (whole.size() > max_file_name_bytes) {
        const std::size_t room = max_file_name_bytes - path.extension().string().size();
        return invalid(
            fmt::format("This name is too long. The limit is {} bytes.", max_file_name_bytes),
            cut_to(path.stem().string(), room) + path.extension().string());
    }
    return {.is_valid = true};
}
