#include "formats/effect/effect_names.h"

#include <fmt/format.h>

namespace {
bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
}  // namespace

std::string identifier_from(std::string_view name) {
    std::string identifier;
    for (const char c : name) {
        const bool is_usable = is_letter(c) || (c >= '0' && c <= '9');
        if (is_usable)
            identifier += c;
        else if (!identifier.empty() && identifier.back() != '_')
            identifier += '_';
    }
    while (!identifier.empty() && identifier.back() == '_')
        identifier.pop_back();
    if (identifier.empty() || !is_letter(identifier.front()) || identifier.starts_with("gl_"))
        identifier.insert(0, "p_");
    return identifier;
}

std::string EffectNames::add(std::string_view name) {
    const std::string wanted = identifier_from(name);
    std::string given = wanted;
    for (int copy = 2; !m_taken.insert(given).second; ++copy)
        given = fmt::format("{}_{}", wanted, copy);
    return given;
}
