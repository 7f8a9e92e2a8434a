#include "ui/widgets/typed_prefix.h"

#include <algorithm>
#include <cctype>

namespace {
char small(char letter) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
}
}  // namespace

void TypedPrefix::add(std::string_view letters, double seconds) {
    constexpr double pause_seconds = 1.0;
    if (letters.empty())
        return;
    if (seconds - m_seconds > pause_seconds)
        m_text.clear();
    m_text += letters;
    m_seconds = seconds;
    m_is_open = true;
}

bool TypedPrefix::is_found(std::string_view label) {
    const bool is_match =
        m_is_open && label.size() >= m_text.size() &&
        std::ranges::equal(label.substr(0, m_text.size()), m_text, {}, small, small);
    if (is_match)
        m_is_open = false;
    return is_match;
}
