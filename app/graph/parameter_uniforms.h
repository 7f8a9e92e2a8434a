#pragma once

#include "graph/programs.h"
#include "model/look.h"

#include <vector>

/// Writes a look's values to the uniforms that they drive, and only those that changed.
class ParameterUniforms {
public:
    ParameterUniforms() = default;
    /// Writes what the passes fix (`set`); the values follow with the first write(). Both outlive
    /// it.
    ParameterUniforms(const Look& look, const Programs& programs);

    void write(const Look& look, const Values& values);

private:
    struct Place {
        const gpu::Program* program;
        const gpu::Uniform* uniform;
    };
    struct Driven {
        std::size_t parameter;  // in Look::parameters
        std::vector<Place> places;
        Value written;  // empty: nothing yet
    };
    std::vector<Driven> m_driven;
};
