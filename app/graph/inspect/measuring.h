#pragma once

#include "gpu/objects/canvas.h"
#include "gpu/objects/download.h"
#include "graph/programs/sample_programs.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

// What those have in common that draw numbers of textures into a canvas of floats, to be read.

/// A fragment stage of the program's own, drawn over the whole of a target.
Result<gpu::Program> build_measuring_program(const std::string& fragment_text);

/// The same for every kind of texture: between the parts it is told how texels are read, see
/// texel_text.h.
Result<SamplePrograms> build_texel_programs(std::string start, std::string end);

/// Makes the canvas anew where it has another size or format; false without memory: then nothing is
/// measured, and the passes themselves are what needs it.
bool fit_canvas(std::optional<gpu::Canvas>& canvas, Extent extent, Format format);
/// The same of 32-bit RGBA floats.
bool fit_floats(std::optional<gpu::Canvas>& canvas, Extent extent);

/// RGBA of each texel of such a canvas, once they have come; then nothing is to come any more.
std::optional<std::vector<std::array<float, 4>>> take_texels(std::optional<gpu::Download>& to_come);
