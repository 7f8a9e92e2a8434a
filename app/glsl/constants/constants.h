#pragma once

#include "glsl/text/declarations.h"
#include "model/look/parameter.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// A number that a text gives a name, and whose comments ask for a control:
/// `#define STEPS 64  // @range 8 256` or `const float GLOW = 0.35;  // @range 0 1`.
struct WrittenConstant {
    std::string name;
    NumberType type;
    std::optional<double> number;  // none: what is written is not one plain number
    std::size_t begin = 0;         // where it is written, with its sign: offsets into the text
    std::size_t end = 0;
    int line = 1;
    std::vector<Comment> comments;
};

/// Those of a text in order, wherever they stand. A comment asks for a control with `@range` or
/// `@items`, of true and false also with `@label`.
std::vector<WrittenConstant> find_constants(std::string_view text);

/// A number as GLSL writes one of that type; below 0 in brackets, so that no sign before it makes
/// one token with its own.
std::string glsl_number(const NumberType& type, double number);
