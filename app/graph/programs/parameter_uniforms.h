#pragma once

#include "graph/programs/programs.h"
#include "model/look/orbit.h"

#include <optional>
#include <vector>

/// A value as shaders read it: within its limits, colours as they are encoded there.
Value value_for_shaders(const Parameter& parameter, const Value& value);

/// Writes a look's values to the uniforms that they drive, and only those that changed. Those of
/// the orbit become matrices; colours are encoded where shaders want them so; an event is on for
/// one frame.
class ParameterUniforms {
public:
    ParameterUniforms() = default;
    /// Writes what the passes fix (`set`); the values follow with the first write(). Both outlive
    /// it.
    ParameterUniforms(const Look& look, const Programs& programs);

    void write(const Look& look, const Values& values);
    /// The same where since the last write() only these have changed; sorted.
    void write(const Look& look, const Values& values, const std::vector<std::string>& changed);
    /// A frame has been drawn: events that were on in it are off until they have been let go.
    void end_events();
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
        bool is_event = false;
        bool is_over = false;  // an event that is held and had its frame
    };
    struct Turned {  // u_view or u_camera
        int pass;
        Place place;
        Matrix (*matrix)(const Orbit&);
        std::optional<Orbit> written;
    };

    static void write_to(const Driven& driven, const Value& usable);
    static void write(Driven& driven, const Parameter& parameter, const Values& values);
    void write_turned(const Look& look, const Values& values);
    void find_turned(const Look& look, int pass, const gpu::Program& program);

    std::vector<Driven> m_driven;
    std::vector<Turned> m_turned;
};
