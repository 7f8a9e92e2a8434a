#pragma once

#include <span>
#include <string>
#include <string_view>

/// The chunks of three.js that a fragment shader can include with `#include <common>`.
std::span<const std::string_view> host_chunks();

/// Declarations of GameMaker and three.js, and functions of the included chunks, in our own GLSL
/// 4.10. Only for names that the text uses and does not declare. Scene values are those of a flat
/// picture: no fog, no alpha test, a camera that faces it.
std::string host_declarations(std::string_view text);
