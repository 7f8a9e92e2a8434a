#include "formats/slang/slang_text.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace {
// The number of bytes of the UTF-8 character at the start of `bytes`; 0 if invalid. Unicode table
// 3-7: no overlong forms, no code points above U+10FFFF, no surrogates.
std::size_t letter_size(std::string_view bytes) {
    const auto byte = [&](std::size_t i) {
        return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0u;
    };
    const auto is_next = [&](std::size_t i) { return (byte(i) & 0xc0u) == 0x80u; };
    const unsigned first = byte(0);
    if (first < 0x80)
        return 1;
    if (first >= 0xc2 && first <= 0xdf)
        return is_next(1) ? 2 : 0;
    if (first >= 0xe0 && first <= 0xef) {
        const bool is_shortest = first != 0xe0 || byte(1) >= 0xa0;
        const bool is_surrogate = first == 0xed && byte(1) >= 0xa0;
        return is_next(1) && is_next(2) && is_shortest && !is_surrogate ? 3 : 0;
    }
    if (first >= 0xf0 && first <= 0xf4) {
        const bool is_in_range =
            (first != 0xf0 || byte(1) >= 0x90) && (first != 0xf4 || byte(1) < 0x90);
        return is_next(1) && is_next(2) && is_next(3) && is_in_range ? 4 : 0;
    }
    return 0;
}
}  // namespace

std::optional<double> leading_number(std::string_view text) {
    text = trim(text);
    if (text.starts_with('+'))
        text.remove_prefix(1);
    double number = 0.0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool is_float = std::abs(number) <= std::numeric_limits<float>::max();
    if (read.ec != std::errc{} || !is_float)
        return std::nullopt;
    return number;
}

std::string decimal_comma_note(std::string_view key, std::string_view text) {
    text = trim(text);
    const auto is_digit = [&](std::size_t at) {
        return at < text.size() && text[at] >= '0' && text[at] <= '9';
    };
    std::size_t comma = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
    while (is_digit(comma))
        ++comma;
    if (comma == 0 || comma >= text.size() || text[comma] != ',' || !is_digit(comma - 1) ||
        !is_digit(comma + 1))
        return {};
    std::string with_point(text);
    with_point[comma] = '.';
    return fmt::format("'{}' is {} because '{}' has a decimal comma; use '{}'", key,
                       text.substr(0, comma), text, with_point);
}

std::string fault_of_slang_path(std::string_view written) {
    constexpr std::size_t longest_path = 4096;  // of Linux
    return written.size() > longest_path
               ? fmt::format("the path is longer than the limit of {} bytes", longest_path)
               : std::string();
}

std::string readable_text(std::string_view bytes) {
    const auto is_ascii = [](char letter) { return static_cast<unsigned char>(letter) < 0x80; };
    if (std::ranges::all_of(bytes, is_ascii))
        return std::string(bytes);
    std::string text;
    while (!bytes.empty()) {
        const std::size_t size = letter_size(bytes);
        if (size > 0) {
            text.append(bytes.substr(0, size));
        } else {
            const auto letter = static_cast<unsigned char>(bytes.front());
            text += static_cast<char>(0xc0u | (letter >> 6));
            text += static_cast<char>(0x80u | (letter & 0x3fu));
        }
        bytes.remove_prefix(std::max<std::size_t>(size, 1));
    }
    return text;
}
