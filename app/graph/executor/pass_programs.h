#pragma once

#include "graph/executor/shapes.h"
#include "graph/programs/bound_input.h"
#include "graph/programs/built_in_uniforms.h"
#include "graph/programs/parameter_uniforms.h"
#include "graph/programs/programs.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

/// The program of a pass and what it reads.
struct BoundPass {
    std::shared_ptr<const gpu::Program> program;
    BuiltInUniforms built_ins;
    std::vector<BoundInput> inputs;
    gpu::VertexArray vertices;
    int tint_location;  // of the attribute; -1: unused
    bool reads_itself = false;
    bool covers_target = false;  // overwrites all texels
};

/// The programs of a look, with its values in their uniforms: the generic ones, or specialised ones
/// whose constants are the current values. Programs may be shared with other looks. Belongs to
/// their context. Passes are given by their index in the look.
class PassPrograms {
public:
    /// Both must outlive it.
    PassPrograms(const FrameGraph& graph, const Shapes& shapes, Programs programs);

    /// The context of the executor; null: the current one.
    const std::shared_ptr<gpu::Context>& context() const { return m_context; }
    /// The generic programs, even while specialised ones draw.
    const Programs& generic() const { return m_generic.programs; }
    bool is_specialized() const { return m_specialized.has_value(); }

    /// The pass as it is drawn, or as generic programs draw it.
    const BoundPass& operator[](std::size_t pass) const { return active().passes[pass]; }
    const BoundPass& generic_pass(std::size_t pass) const { return m_generic.passes[pass]; }
    std::size_t size() const { return m_generic.passes.size(); }
    /// One flag per pass: whether its program reads the mouse.
    std::vector<bool> reading_mouse() const;

    /// One flag per input of each pass: whether its program reads it.
    std::vector<std::vector<bool>> read_inputs() const;

    /// Follows an edited look. `are_bound_alike`: the passes that keep their programs read the same
    /// as before. Returns the passes that changed, one flag each.
    std::vector<bool> replace(Programs programs, bool are_bound_alike);
    /// Draws with specialised programs. The parameters in `moving` are still uniforms.
    void specialize(Programs programs, std::set<std::string> moving);
    /// Draws with the generic programs again.
    void end_specialized();
    /// Writes the values of these parameters, which have changed. Ends a specialisation for another
    /// value.
    void write(const std::vector<std::string>& changed);
    /// Writes all values, if others have written to these programs. Call before draws.
    void refresh();
    /// Call after each frame: events that were on in it stay off until they are released.
    void end_events() { active().uniforms.end_events(); }

private:
    struct Bound {
        Programs programs;
        std::vector<BoundPass> passes = {};
        ParameterUniforms uniforms = {};
    };

    BoundPass bound(std::size_t pass, const std::shared_ptr<const gpu::Program>& program) const;
    Bound bound(Programs programs, std::vector<BoundPass> previous) const;
    Bound& active() { return m_specialized ? *m_specialized : m_generic; }
    const Bound& active() const { return m_specialized ? *m_specialized : m_generic; }
    void write_all();
    bool set_uniform_owner() const;

    const FrameGraph& m_graph;
    const Shapes& m_shapes;
    std::shared_ptr<gpu::Context> m_context;
    std::uint64_t m_writer;  // identifies this object to the programs
    Bound m_generic;
    std::optional<Bound> m_specialized;
    std::set<std::string> m_moving;
    std::vector<BoundPass> m_previous;  // the last specialised ones, which may return
};
