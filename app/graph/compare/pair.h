#pragma once

#include "gpu/objects/samplers.h"
#include "gpu/program.h"
#include "model/look/picture.h"

#include <string>

/// Two textures of the same size in formats that are not integer: a pass drawn twice, or a pass and
/// a picture.
struct Pair {
    const gpu::Texture& ours;
    const gpu::Texture& other;
    Encoding encoding = Encoding::display;  // of the stored numbers of both
};

/// A program with pair_text before `body` in the fragment stage. The vertex stage covers the
/// target.
Result<gpu::Program> build_pair_program(const std::string& body);
/// A program that reads one texture, `shown`, with curve_text.
Result<gpu::Program> build_single_program(const std::string& body);

/// Binds the textures and the program. Call in a DrawScope.
void bind_pair(const Pair& pair, const gpu::Program& program, gpu::Samplers& samplers);

/// Whether two pictures can be compared number by number.
bool are_comparable(const gpu::Texture& ours, const gpu::Texture& other);
