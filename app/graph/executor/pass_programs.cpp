#include "graph/executor/pass_programs.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <utility>

namespace {
// The built-in triangle and quad cover all texels. A user's vertex shader, points or `discard` may
// not.
bool covers(const Pass& pass) {
    return !is_of_beam(pass.draw) && pass.blend == Blend::replace && pass.vertex.file.empty() &&
           pass.fragment.text->find("discard") == std::string::npos;
}

std::uint64_t next_writer() {
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}
}  // namespace

PassPrograms::PassPrograms(const FrameGraph& graph, const Shapes& shapes, Programs programs)
    : m_graph(graph),
      m_shapes(shapes),
      m_context(programs.context),
      m_writer(next_writer()),
      m_generic(bound(std::move(programs), {})) {
    write_all();
}

BoundPass PassPrograms::bound(std::size_t pass,
                              const std::shared_ptr<const gpu::Program>& program) const {
    const Look& look = m_graph.look();
    const Pass& declared = look.passes[pass];
    BoundPass made{program, BuiltInUniforms(look, static_cast<int>(pass), *program),
                   bind_inputs(look, static_cast<int>(pass), *program),
                   m_shapes.vertices_for(*program, declared.draw),
                   is_of_beam(declared.draw) ? program->attribute_location("tint") : -1};
    made.reads_itself = std::ranges::any_of(made.inputs, [&](const BoundInput& input) {
        return input.from == Input::From::pass && input.pass == static_cast<int>(pass);
    });
    made.covers_target = covers(declared);
    return made;
}

// Reuses previous passes with the same program.
PassPrograms::Bound PassPrograms::bound(Programs programs, std::vector<BoundPass> previous) const {
    assert(programs.passes.size() == m_graph.look().passes.size());
    Bound made{std::move(programs)};
    for (std::size_t i = 0; i < made.programs.passes.size(); ++i) {
        const auto& program = made.programs.passes[i].program;
        const bool serves = i < previous.size() && previous[i].program == program;
        made.passes.push_back(serves ? std::move(previous[i]) : bound(i, program));
    }
    made.uniforms = ParameterUniforms(m_graph.look(), made.programs);
    return made;
}

std::vector<bool> PassPrograms::reading_mouse() const {
    std::vector<bool> readers;
    for (const BoundPass& pass : active().passes)
        readers.push_back(pass.built_ins.uses_mouse());
    return readers;
}

std::vector<std::vector<bool>> PassPrograms::read_inputs() const {
    std::vector<std::vector<bool>> read;
    for (std::size_t i = 0; i < active().passes.size(); ++i) {
        const std::vector<BoundInput>& bound = active().passes[i].inputs;
        read.emplace_back();
        for (const Input& input : m_graph.look().passes[i].inputs)
            read.back().push_back(std::ranges::find(bound, input.uniform, &BoundInput::uniform) !=
                                  bound.end());
    }
    return read;
}

std::vector<bool> PassPrograms::replace(Programs programs, bool are_bound_alike) {
    if (m_specialized)
        m_previous = std::move(std::exchange(m_specialized, std::nullopt)->passes);
    if (!are_bound_alike) {
        m_generic.passes.clear();
        m_previous.clear();
    }
    std::vector<bool> changed;
    for (std::size_t i = 0; i < programs.passes.size(); ++i)
        changed.push_back(i >= m_generic.passes.size() ||
                          m_generic.passes[i].program != programs.passes[i].program);
    m_generic = bound(std::move(programs), std::move(m_generic.passes));
    write_all();
    return changed;
}

void PassPrograms::specialize(Programs programs, std::set<std::string> moving) {
    end_specialized();
    m_specialized = bound(std::move(programs), std::exchange(m_previous, {}));
    m_moving = std::move(moving);
    write_all();
}

void PassPrograms::end_specialized() {
    if (!m_specialized)
        return;
    m_previous = std::move(std::exchange(m_specialized, std::nullopt)->passes);
    write_all();
}

void PassPrograms::write(const std::vector<std::string>& changed) {
    const auto is_constant = [this](const std::string& name) { return !m_moving.contains(name); };
    if (m_specialized && std::ranges::any_of(changed, is_constant))
        return end_specialized();
    if (set_uniform_owner())
        write_all();
    else
        active().uniforms.write(m_graph.look(), m_graph.values(), changed);
}

void PassPrograms::refresh() {
    if (set_uniform_owner())
        write_all();
}

void PassPrograms::write_all() {
    set_uniform_owner();
    active().uniforms.forget_written();
    active().uniforms.write(m_graph.look(), m_graph.values());
}

// Whether others have written to the programs since the last call.
bool PassPrograms::set_uniform_owner() const {
    bool is_new = false;
    for (const BoundPass& pass : active().passes)
        is_new = pass.program->set_uniform_owner(m_writer) || is_new;
    return is_new;
}
