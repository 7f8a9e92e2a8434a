#pragma once

#include "gpu/canvas.h"
#include "gpu/program.h"

#include <optional>
#include <string>

// What those have in common that draw numbers of textures into a canvas of floats, to be read.

/// A fragment stage of the program's own, drawn over the whole of a target.
Result<gpu::Program> build_measuring_program(const std::string& fragment_text);

/// Makes the canvas anew where it has another size; false without memory: then nothing is measured,
/// and the passes themselves are what needs it.
bool fit_floats(std::optional<gpu::Canvas>& canvas, Extent extent);
