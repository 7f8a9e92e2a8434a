#pragma once

#include <functional>
#include <string>

/// Replaces blanks by line breaks so that no line exceeds `maximum`, except for a single long word.
/// Dear ImGui's wrapping also breaks within numbers, after the decimal point.
std::string broken_at_blanks(const std::string& text, float maximum,
                             const std::function<float(const std::string&)>& width_of);
