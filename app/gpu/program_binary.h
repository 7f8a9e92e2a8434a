#pragma once

#include <epoxy/gl.h>

#include <string>
#include <string_view>

namespace gpu {

/// What a program's binary answers: these texts, for the driver of the current context.
std::string binary_question(std::string_view vertex, std::string_view fragment);

/// A linked program as the driver keeps it; "" where the driver has no such form.
std::string binary_of(GLuint program);

/// Whether the driver took what binary_of() gave; else the program is as it was made.
bool load_binary(GLuint program, std::string_view bytes);

}  // namespace gpu
