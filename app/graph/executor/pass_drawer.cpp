#include "graph/executor/pass_drawer.h"

#include "gpu/objects/draw.h"

#include <limits>
#include <utility>

Result<void> PassDrawer::prepare_bypass() {
    if (m_pass_through)
        return {};
    auto made = PassThrough::make();
    if (!made)
        return fail(made.error());
    m_pass_through.emplace(std::move(*made));
    return {};
}

void PassDrawer::set_frame(const Frame& frame) {
    m_frame = frame;
    m_frame.beam = {};
    m_frame.tints = {};
    m_frame.sound = nullptr;
    if (m_frame.source_number == 0)
        m_frame.source_number = source_frame_of(m_frame.number, m_frame.subframe.count);
    m_source_frame = source_frame_of(m_frame);
}

const Frame& PassDrawer::frame_of(std::size_t index) const {
    return m_graph.look().passes[index].per_source_frame ? m_source_frame : m_frame;
}

PassInfo PassDrawer::info_of_pass(std::size_t index) const {
    const Look& look = m_graph.look();
    const Plan& plan = m_graph.plan();
    const Pass& pass = look.passes[index];
    const gpu::Texture* texture = m_textures.stored({Input::From::source, {}});
    const Extent source =
        source_extent_of(look, pass, plan, texture ? texture->extent() : m_graph.settings().source);
    const std::int64_t modulo =
        pass.frame_modulo > 0 ? pass.frame_modulo : std::numeric_limits<std::int64_t>::max();
    const Frame& frame = frame_of(index);
    const std::int64_t before = std::max<std::int64_t>(frame.number - 1, 0);
    return {
        static_cast<double>(frame.number % modulo),
        static_cast<double>(before % modulo),
        static_cast<double>((frame.source_number - 1) % modulo),
        plan.targets[index].extent,
        m_graph.settings().viewport,
        source,
        pass.source.empty() && m_frame.source_raster ? *m_frame.source_raster : own_raster(source),
        pass.rows,
        is_drawn_onto(look, plan, index),
        [this, source](const BoundInput& input) {
            if (input.from == Input::From::pass && input.pass >= 0)
                return m_graph.plan().targets[static_cast<std::size_t>(input.pass)].extent;
            const gpu::Texture* read = m_textures.find(input);
            return read ? read->extent() : source;
        }};
}

void PassDrawer::use(std::size_t index) const {
    const BoundPass& bound = m_programs[index];
    bound.program->use();
    bound.built_ins.write(*bound.program, frame_of(index), info_of_pass(index));
}

void PassDrawer::start_target(std::size_t index, bool keeps_picture) {
    if (m_graph.host_of(index) != index)
        return;
    Target& target = m_textures.targets()[index];
    const bool is_covered = m_programs[index].covers_target;
    if (keeps_picture && !is_covered && target.has_previous())
        target.canvas(1).copy_to(target.canvas());
    else if (!keeps_picture && !is_covered && m_graph.look().passes[index].blend == Blend::multiply)
        target.canvas().clear({1.0f, 1.0f, 1.0f, 1.0f});
    else if (!keeps_picture && !is_covered)
        target.canvas().clear();
}

void PassDrawer::bind(std::size_t index) {
    const Pass& pass = m_graph.look().passes[index];
    const std::size_t host = m_graph.host_of(index);
    m_textures.targets()[host].canvas().bind();
    if (host != index)
        gpu::set_blend_onto();
    else
        gpu::set_blend(info_of(pass.format).is_integer ? Blend::replace : pass.blend);
    m_textures.bind(m_programs[index].inputs);
}

void PassDrawer::draw(std::size_t index, int samples) const {
    const BoundPass& bound = m_programs[index];
    bound.built_ins.write_samples(*bound.program, samples);
    draw_shape(index);
}

void PassDrawer::draw_shape(std::size_t index) const {
    const Draw shape = m_graph.look().passes[index].draw;
    const BoundPass& bound = m_programs[index];
    bound.vertices.bind();
    if (bound.tint_location >= 0)
        m_shapes.beam.choose_tints(bound.vertices, bound.tint_location, shape);
    if (shape == Draw::points)
        gpu::draw_points(m_shapes.beam.point_count());
    else if (shape == Draw::segments)
        gpu::draw_quads(m_shapes.beam.segment_count());
    else if (shape == Draw::quad)
        gpu::draw_quads(1);
    else
        gpu::draw_triangle();
}

void PassDrawer::pass_through(std::size_t index) {
    const Look& look = m_graph.look();
    const Pass& pass = look.passes[index];
    const BoundInput input = bound_input(look, static_cast<int>(index), *passed_input(pass));
    const gpu::Texture* from = m_textures.find(input);
    const gpu::Canvas& to = m_textures.targets()[index].canvas();
    m_pass_through->draw(from ? *from : m_textures.black(), input.sampler, to,
                         m_textures.samplers(), m_textures.rows_of(input) != pass.rows);
}

void PassDrawer::draw_separately(std::size_t index, const gpu::Canvas& canvas, int samples) const {
    const gpu::DrawScope scope;
    const Pass& pass = m_graph.look().passes[index];
    m_programs.refresh();
    use(index);
    canvas.clear();
    canvas.bind();
    gpu::set_blend(pass.blend);
    m_textures.bind(m_programs[index].inputs);
    for (int i = 0; i < m_graph.repeats_of(index); ++i)
        draw(index, samples + i);
    m_textures.samplers().release();
}

namespace {
std::optional<TextureChoice> choice_of(const BoundInput& input, const Look& look) {
    if (!input.from)
        return std::nullopt;
    const std::string name =
        input.pass >= 0 ? look.passes[static_cast<std::size_t>(input.pass)].name : input.image;
    return TextureChoice{*input.from, name, input.frames_ago, 0, input.sound};
}
}  // namespace

PassReport PassDrawer::report(std::size_t index, int samples) const {
    const BoundPass& bound = m_programs.generic_pass(index);
    PassReport report;
    for (const BoundInput& input : bound.inputs) {
        SamplerReport sampler{input.uniform, choice_of(input, m_graph.look()), {}, {}, {}};
        if (const gpu::Texture* texture = m_textures.find(input)) {
            sampler.extent = texture->extent();
            sampler.format = texture->format();
            sampler.sampler = gpu::usable_sampler(input.sampler, texture->format());
        }
        report.samplers.push_back(std::move(sampler));
    }
    report.built_ins = bound.built_ins.report(frame_of(index), info_of_pass(index), samples);
    return report;
}
