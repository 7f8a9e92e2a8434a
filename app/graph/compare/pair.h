#pragma once

#include "gpu/objects/samplers.h"
#include "gpu/program.h"
#include "model/look/picture.h"

#include <string>

/// Two textures of one size that hold no whole numbers: the same pass drawn twice, or a picture in
/// the place of the second.
struct Pair {
    const gpu::Texture& ours;
    const gpu::Texture& other;
    Encoding encoding = Encoding::display;  // of the stored numbers of both
};

/// A program whose fragment stage has pair_text.h before `body`; every vertex covers the target.
Result<gpu::Program> build_pair_program(const std::string& body);
/// A program that reads one texture, `shown`, and has curve_text.
Result<gpu::Program> build_single_program(const std::string& body);

/// Brings the textures to the program, which is bound afterwards; to be called in a DrawScope.
void bind_pair(const Pair& pair, const gpu::Program& program, gpu::Samplers& samplers);

/// Whether two pictures can be told apart number by number.
bool are_comparable(const gpu::Texture& ours, const gpu::Texture& other);
