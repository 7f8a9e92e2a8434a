#include "formats/slang/decoration.h"

#include <algorithm>

namespace {
struct Letter {
    char32_t code = 0;
    std::size_t size = 0;
};

// The character of valid UTF-8 at `at`.
Letter letter_at(std::string_view text, std::size_t at) {
    const auto first = static_cast<unsigned char>(text[at]);
    if (first < 0x80)
        return {first, 1};
    const std::size_t size = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    char32_t code = first & (0x7fu >> size);
    for (std::size_t i = at + 1; i < std::min(at + size, text.size()); ++i)
        code = (code << 6) | (static_cast<unsigned char>(text[i]) & 0x3fu);
    return {code, size};
}

// Signs, arrows, lines, superscripts: Unicode's blocks of symbols, without letters.
bool is_symbol(char32_t code) {
    if (code >= 0xa0 && code <= 0xbf)
        return code != 0xaa && code != 0xb5 && code != 0xba;
    return code == 0xd7 || code == 0xf7 || (code >= 0x2000 && code <= 0x2bff) ||
           (code >= 0xfe00 && code <= 0xfe0f) || code >= 0x1f000;
}

bool is_decoration(char32_t code, std::string_view signs) {
    return code < 0x80 ? signs.find(static_cast<char>(code)) != signs.npos : is_symbol(code);
}
}  // namespace

std::string_view without_decoration(std::string_view text) {
    constexpr std::string_view leading = " \t-=*.><~_|/\\:,;!";
    constexpr std::string_view trailing = " \t-=*><~_|/\\:,;";
    while (!text.empty()) {
        const Letter first = letter_at(text, 0);
        if (!is_decoration(first.code, leading))
            break;
        text.remove_prefix(std::min(first.size, text.size()));
    }
    while (!text.empty()) {
        std::size_t at = text.size() - 1;
        while (at > 0 && (static_cast<unsigned char>(text[at]) & 0xc0u) == 0x80u)
            --at;
        if (!is_decoration(letter_at(text, at).code, trailing))
            break;
        text = text.substr(0, at);
    }
    return text;
}
