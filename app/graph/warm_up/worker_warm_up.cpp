#include "graph/warm_up/worker_warm_up.h"

#include "gpu/objects/draw.h"

WorkerWarmUp::WorkerWarmUp(PassProgram first, PassProgram last, gpu::Canvas canvas)
    : m_first(std::move(first)), m_last(std::move(last)), m_canvas(std::move(canvas)) {}

Result<WorkerWarmUp> WorkerWarmUp::make() {
    auto first = idle_program();
    auto last = idle_program();
    auto canvas = gpu::Canvas::make({1, 1}, Format::rgba8);
    for (const auto* program : {&first, &last})
        if (!*program)
            return fail(program->error());
    if (!canvas)
        return fail(canvas.error());
    return WorkerWarmUp(std::move(*first), std::move(*last), std::move(*canvas));
}

void WorkerWarmUp::draw_with(const PassProgram& program) const {
    const gpu::DrawScope scope;
    m_canvas.bind();
    program.program->use();
    m_vertices.bind();
    gpu::draw_triangle();
}

void WorkerWarmUp::draw(const FirstDrawsInput& of, PassProgress& progress) const {
    FirstDraws draws(of, m_first);
    if (draws.is_done())
        return;
    draw_with(m_first);
    draws.draw_all(progress);
    draw_with(m_last);
    gpu::finish();
}
