#include "graph/warm_up.h"

#include "glsl/include.h"
#include "gpu/draw.h"
#include "graph/executor.h"

#include <algorithm>
#include <bit>

namespace {
bool is_known(const PassProgram& program, const Programs* known) {
    return known && std::ranges::any_of(known->passes, [&](const PassProgram& other) {
               return other.program == program.program;
           });
}

// Draws nothing.
Result<PassProgram> idle_program() {
    Stage fragment;
    fragment.text = "#version 410 core\nvoid main() { discard; }\n";
    auto program = gpu::Program::build(fullscreen_vertex_stage(), fragment);
    if (!program)
        return fail(program.error());
    return PassProgram{{},
                       fragment.text,
                       Draw::fullscreen,
                       {},
                       std::make_shared<const gpu::Program>(std::move(*program))};
}

// Some drivers make other code for textures whose sides are powers of two.
Extent small_like(Extent viewport) {
    const auto side = [](int length) {
        return std::has_single_bit(static_cast<unsigned>(std::max(length, 1))) ? 64 : 96;
    };
    return {side(viewport.width), side(viewport.height)};
}
}  // namespace

WarmUp::WarmUp(PassProgram first, PassProgram last, gpu::Canvas canvas)
    : m_first(std::move(first)), m_last(std::move(last)), m_canvas(std::move(canvas)) {}

Result<WarmUp> WarmUp::make() {
    auto first = idle_program();
    auto last = idle_program();
    auto canvas = gpu::Canvas::make({1, 1}, Format::rgba8);
    for (const auto* program : {&first, &last})
        if (!*program)
            return fail(program->error());
    if (!canvas)
        return fail(canvas.error());
    return WarmUp(std::move(*first), std::move(*last), std::move(*canvas));
}

void WarmUp::draw_with(const PassProgram& program) const {
    const gpu::DrawScope scope;
    m_canvas.bind();
    program.program->use();
    m_vertices.bind();
    gpu::draw_triangle();
}

void WarmUp::draw(const Look& look, const Programs& programs, const Programs* known,
                  Extent viewport) const {
    if (std::ranges::all_of(programs.passes,
                            [&](const PassProgram& pass) { return is_known(pass, known); }))
        return;
    Look stand_in = look;
    Programs drawn = programs;
    for (std::size_t i = 0; i < drawn.passes.size(); ++i) {
        if (!is_known(drawn.passes[i], known))
            continue;
        drawn.passes[i] = m_first;
        stand_in.passes[i].draw = Draw::fullscreen;
        stand_in.passes[i].inputs.clear();
        stand_in.passes[i].set.clear();
    }
    Executor executor(std::move(stand_in), std::move(drawn));
    const Extent extent = small_like(viewport);
    if (!executor.resize(extent, extent))
        return;
    const Beam beam(2);
    Frame frame;
    frame.number = 1;
    frame.time = frame.time_delta = 1.0 / 60.0;
    frame.beam = beam;
    frame.is_first = true;
    draw_with(m_first);
    executor.draw(frame);
    draw_with(m_last);
    gpu::finish();
}
