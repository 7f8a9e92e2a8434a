#pragma once

#include <epoxy/gl.h>

#include <string>
#include <string_view>

namespace gpu {

/// The cache key of a program's binary: these texts and the driver of the current context.
std::string binary_key(std::string_view vertex, std::string_view fragment);

/// The binary of a linked program; "" if the driver supports no binaries.
std::string binary_of(GLuint program);

/// Whether the driver accepted a binary from binary_of(); otherwise the program stays unlinked.
bool load_binary(GLuint program, std::string_view bytes);

}  // namespace gpu
