#pragma once

#include <set>
#include <string>
#include <string_view>

/// Gives names that GLSL and other shader languages accept as identifiers, each once.
class EffectNames {
public:
    /// `taken`: names that must not be given.
    explicit EffectNames(std::set<std::string, std::less<>> taken = {})
        : m_taken(std::move(taken)) {}

    /// The name with '_' for other characters, and with a number if it was already given.
    std::string add(std::string_view name);

private:
    std::set<std::string, std::less<>> m_taken;
};

/// The name with '_' for characters that an identifier can't have. Never empty, starts with a
/// letter, and without "__", which GLSL reserves.
std::string identifier_from(std::string_view name);
