#pragma once

#include <functional>
#include <string>

/// The text with line breaks in the place of blanks, so that no line is wider than `most` where its
/// words are not. Dear ImGui's own also breaks within a number, behind its point.
std::string broken_at_blanks(const std::string& text, float most,
                             const std::function<float(const std::string&)>& width_of);
