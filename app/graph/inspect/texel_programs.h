#pragma once

#include "gpu/objects/canvas.h"
#include "gpu/objects/download.h"
#include "graph/programs/sample_programs.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

// Common code of classes that draw the numbers of textures into a float canvas for readback.

/// A program with this fragment stage that covers the whole target.
Result<gpu::Program> build_measuring_program(const std::string& fragment_text);

/// The same for every kind of texture. The code that reads texels is inserted between `start` and
/// `end`; see texel_text.h.
Result<SamplePrograms> build_texel_programs(std::string start, std::string end);

/// Recreates the canvas if it has another size or format. False without memory: then nothing is
/// measured, as the passes need the memory.
bool fit_canvas(std::optional<gpu::Canvas>& canvas, Extent extent, Format format);
/// The same for 32-bit RGBA floats.
bool fit_floats(std::optional<gpu::Canvas>& canvas, Extent extent);

/// RGBA of each texel of such a canvas, when available. Then resets `to_come`.
std::optional<std::vector<std::array<float, 4>>> take_texels(std::optional<gpu::Download>& to_come);
