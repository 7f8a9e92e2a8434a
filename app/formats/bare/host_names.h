#pragma once

#include <span>
#include <string>
#include <string_view>

/// The pieces of three.js's library, `#include <common>`, that a fragment shader may ask for.
std::span<const std::string_view> host_chunks();

/// What GameMaker and three.js declare for an author, and the functions of the chunks that a text
/// includes: GLSL 4.10 of our own, of the names that the text uses and does not declare itself. A
/// scene's facts are those of a flat picture: no fog, no alpha test, a camera that looks at it.
std::string host_declarations(std::string_view text);
