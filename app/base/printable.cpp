#include "base/printable.h"

#include <fmt/format.h>

namespace {
unsigned char byte_at(std::string_view text, std::size_t offset) {
    return static_cast<unsigned char>(text[offset]);
}

bool is_continuation(unsigned char byte) {
    return (byte & 0xC0U) == 0x80U;
}

// Bytes of the character at `offset` (RFC 3629, table 3-7 of Unicode); 0 if not valid UTF-8.
std::size_t character_size(std::string_view text, std::size_t offset) {
    const unsigned char first = byte_at(text, offset);
    const std::size_t size = first < 0x80   ? 1
                             : first < 0xC2 ? 0
                             : first < 0xE0 ? 2
                             : first < 0xF0 ? 3
                             : first < 0xF5 ? 4
                                            : 0;
    if (size == 0 || offset + size > text.size())
        return 0;
    for (std::size_t i = 1; i < size; ++i)
        if (!is_continuation(byte_at(text, offset + i)))
            return 0;
    const unsigned char second = size > 2 ? byte_at(text, offset + 1) : 0x80;
    const bool is_overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
    const bool is_outside = (first == 0xED && second > 0x9F) || (first == 0xF4 && second > 0x8F);
    return is_overlong || is_outside ? 0 : size;
}

bool is_control(std::string_view character) {
    const unsigned char first = byte_at(character, 0);
    return first < 0x20 || first == 0x7F || (first == 0xC2 && byte_at(character, 1) < 0xA0);
}
}  // namespace

std::string printable(std::string_view text) {
    std::string shown;
    shown.reserve(text.size());
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t size = character_size(text, i);
        const std::string_view piece = text.substr(i, size == 0 ? 1 : size);
        if (size > 0 && !is_control(piece))
            shown += piece;
        else
            for (const char byte : piece)
                shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
        i += piece.size();
    }
    return shown;
}

std::string shortened(std::string text, std::size_t max_bytes) {
    if (text.size() <= max_bytes)
        return text;
    std::size_t end = max_bytes;
    while (end > 0 && is_continuation(byte_at(text, end)))
        --end;
    text.resize(end);
    return text + "…";
}
