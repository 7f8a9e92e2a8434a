#pragma once

#include "graph/programs/programs.h"
#include "model/look/orbit.h"

#include <optional>
#include <vector>

/// Writes changed values of a look to their uniforms. Orbit parameters become matrices. Colours are
/// encoded if their parameter has display encoding. An event is on for one frame.
class ParameterUniforms {
public:
    ParameterUniforms() = default;
    /// Writes the fixed uniforms of the passes (`set`). The first write() writes the values. Both
    /// arguments must outlive it.
    ParameterUniforms(const Look& look, const Programs& programs);

    void write(const Look& look, const Values& values);
    /// The same if only these parameters have changed since the last write(). `changed` is sorted.
    void write(const Look& look, const Values& values, const std::vector<std::string>& changed);
    /// Call after each frame: events that were on in it stay off until they are released.
    void end_events();
    /// Call if other code has written to the programs: the next write() writes all values.
    void forget_written();

private:
    struct UniformTarget {
        const gpu::Program* program;
        const gpu::Uniform* uniform;
    };
    struct Driven {
        std::size_t parameter;  // in Look::parameters
        std::vector<UniformTarget> targets;
        Value written;  // empty: not written yet
        bool is_event = false;
        bool is_over = false;  // an event that is still held after its frame
    };
    struct OrbitUniform {  // u_view or u_camera
        int pass;
        UniformTarget target;
        Matrix (*matrix)(const Orbit&);
        std::optional<Orbit> written;
    };

    static void write_to(const Driven& driven, const Value& usable);
    static void write(Driven& driven, const Parameter& parameter, const Values& values);
    void write_orbits(const Look& look, const Values& values);
    void find_orbits(const Look& look, int pass, const gpu::Program& program);

    std::vector<Driven> m_driven;
    std::vector<OrbitUniform> m_orbit_uniforms;
};
