#include "lab/golden/golden_name.h"

#include "base/printable.h"
#include "base/text.h"

#include <algorithm>

namespace {
constexpr std::size_t max_part_bytes = 100;
constexpr std::size_t max_golden_name_bytes = 250;  // of 255 with ".png"

bool is_ascii(char letter) {
    return static_cast<unsigned char>(letter) < 0x80;
}

bool is_kept(char letter) {
    return !is_ascii(letter) || (letter >= 'a' && letter <= 'z') ||
           (letter >= '0' && letter <= '9') ||
           std::string_view("_.+").find(letter) != std::string_view::npos;
}

// Bytes that are not valid UTF-8 can't be written to JSON and HTML.
bool is_printable(std::string_view text) {
    return printable(text) == text;
}

// Cut at the start of a UTF-8 character.
void cut_to_limit(std::string& text) {
    if (text.size() <= max_part_bytes)
        return;
    std::size_t end = max_part_bytes;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
        --end;
    text.resize(end);
}

std::string name_part(std::string_view text) {
    const bool keeps_all_letters = is_printable(text);
    std::string part;
    for (const char letter : to_lower(text)) {
        if (is_kept(letter) && (keeps_all_letters || is_ascii(letter)))
            part += letter;
        else if (!part.ends_with('-'))
            part += '-';
    }
    part.erase(0, std::min(part.find_first_not_of("-."), part.size()));
    cut_to_limit(part);
    while (part.ends_with('-') || part.ends_with('.'))
        part.pop_back();
    return part;
}
}  // namespace

std::string golden_name(std::string_view look, std::string_view preset) {
    std::string name = name_part(look);
    if (name.empty())
        name = "look";
    if (preset.empty())
        return name;
    const std::string part = name_part(preset);
    return name + "--" + (part.empty() ? "preset" : part);
}

bool is_golden_name(std::string_view text) {
    return !text.empty() && text.size() <= max_golden_name_bytes && text.front() != '-' &&
           text.front() != '.' && is_printable(text) &&
           std::ranges::all_of(text, [](char letter) { return is_kept(letter) || letter == '-'; });
}
