#pragma once

#include <string>
#include <string_view>
#include <vector>

enum class IsfStage { vertex, fragment };

/// The GLSL of an ISF shader, written for GL 2.1 to 3.3 or GLSL ES, as that of 4.10: names that
/// went out of use and words that became reserved are replaced, `#version`, `#extension` and what
/// the program declares itself (`declared`) are blanked out. Every line stays where it was.
std::string isf_body(std::string_view code, IsfStage stage,
                     const std::vector<std::string>& declared);
