#pragma once

#include "glsl/text/declarations.h"
#include "model/look/parameter.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// A named number in a shader text whose comments request a control:
/// `#define STEPS 64  // @range 8 256` or `const float GLOW = 0.35;  // @range 0 1`.
struct WrittenConstant {
    std::string name;
    NumberType type;
    std::optional<double> number;  // nullopt: not a single plain number
    std::size_t begin = 0;         // of the number with its sign: offsets into the text
    std::size_t end = 0;
    int line = 1;
    std::vector<Comment> comments;
};

/// The constants of a text in order, anywhere in it. `@range` or `@items` in the comment requests a
/// control; for true and false, `@label` does as well.
std::vector<WrittenConstant> find_constants(std::string_view text);

/// A number as a GLSL literal of that type. Negative numbers are in brackets, so that a preceding
/// minus does not form a `--` token.
std::string glsl_number(const NumberType& type, double number);
