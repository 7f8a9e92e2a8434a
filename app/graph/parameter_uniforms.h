#pragma once

#include "graph/programs.h"
#include "model/orbit.h"

#include <optional>
#include <vector>

/// Writes a look's values to the uniforms that they drive, and only those that changed. Those of
/// the orbit become matrices.
class ParameterUniforms {
public:
    ParameterUniforms() = default;
    /// Writes what the passes fix (`set`); the values follow with the first write(). Both outlive
    /// it.
    ParameterUniforms(const Look& look, const Programs& programs);

    void write(const Look& look, const Values& values);
    /// Somebody else has written to the programs: the next write() writes all.
    void forget_written();

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
    struct Turned {  // u_view or u_camera
        int pass;
        Place place;
        Matrix (*matrix)(const Orbit&);
        std::optional<Orbit> written;
    };

    void find_turned(const Look& look, int pass, const gpu::Program& program);

    std::vector<Driven> m_driven;
    std::vector<Turned> m_turned;
};
