#include "ui/widgets/truncated_text.h"

#include <algorithm>

namespace {
// The start of the UTF-8 character at `offset`.
std::size_t character_at(const std::string& text, std::size_t offset) {
    offset = std::min(offset, text.size());
    while (offset > 0 && offset < text.size() &&
           (static_cast<unsigned char>(text[offset]) & 0xC0U) == 0x80U)
        --offset;
    return offset;
}
}  // namespace

std::string truncated_to_width(const std::string& text, float maximum,
                               const std::function<float(const std::string&)>& width_of) {
    constexpr std::size_t first = 64;
    std::size_t fitting = 0;
    std::size_t over = first;
    while (width_of(text.substr(0, character_at(text, over))) <= maximum) {
        if (over >= text.size())
            return text;
        fitting = over;
        over *= 2;
    }
    const auto cut = [&](std::size_t offset) {
        return text.substr(0, character_at(text, offset)) + "…";
    };
    if (width_of(cut(fitting)) > maximum)
        fitting = 0;
    while (over - fitting > 1) {  // cut(fitting) fits, cut(over) does not
        const std::size_t middle = fitting + (over - fitting) / 2;
        (width_of(cut(middle)) <= maximum ? fitting : over) = middle;
    }
    return cut(fitting);
}
