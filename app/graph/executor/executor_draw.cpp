// Executor::draw and redraw: the passes of one frame.
#include "gpu/objects/draw.h"
#include "graph/executor/executor.h"
#include "model/picture/beam_fit.h"

#include <algorithm>
#include <cassert>
#include <limits>

void Executor::draw(const Frame& frame, const std::vector<bool>* passes) {
    const gpu::ContextScope scope(m_home.get());
    note_frame(frame, passes, false);
    move_on(false);
    draw_passes();
    m_parameters.end_events();
}

void Executor::redraw(const Frame& frame, const std::vector<bool>& passes) {
    assert(m_frames == Frames::drawn_again);
    const gpu::ContextScope scope(m_home.get());
    note_frame(frame, &passes, true);
    draw_passes();
}

// Prepares the passes to draw, the beam, the keyboard and the sound.
void Executor::note_frame(const Frame& frame, const std::vector<bool>* only, bool is_again) {
    assert(m_targets.size() == m_passes.size());
    drop_frame();
    if (!is_again && frame.is_first)
        clear_history();
    m_work.passes.assign(m_passes.size(), only == nullptr);
    for (std::size_t i = 0; only && i < std::min(only->size(), m_passes.size()); ++i)
        m_work.passes[i] = (*only)[i];
    draw_shared_whole();
    m_work.is_again = is_again;
    for (PassState& state : m_passes)
        state.whole_samples = state.samples;
    m_draws_whole = only == nullptr;
    if (!is_again)
        m_beam.advance(frame);
    write_beam(frame);
    m_keyboard.show(frame.keys);
    m_sound.show(frame);
    m_drawn = frame;
    m_drawn.beam = {};
    m_drawn.tints = {};
    m_drawn.sound = nullptr;
    m_work.draw_calls = 0;
}

// If no pass draws the beam, the previous vertices stay for views of earlier draws.
void Executor::write_beam(const Frame& frame) {
    const std::optional<BeamSpot> spot = smallest_spot();
    if (draws_points() || spot)
        m_beam.write(frame, draws_points(), spot,
                     beam_scale(m_look, m_values, m_viewport, frame.beam_fit));
}

// Passes that share a target are drawn together or not at all.
void Executor::draw_shared_whole() {
    bool is_any = false;
    for (std::size_t guest = 0; guest < m_passes.size(); ++guest)
        if (const std::size_t host = host_of(guest); host != guest)
            m_work.passes[host] = m_work.passes[host] || m_work.passes[guest];
    for (std::size_t guest = 0; guest < m_passes.size(); ++guest)
        if (const std::size_t host = host_of(guest); host != guest) {
            m_work.passes[guest] = m_work.passes[host];
            is_any = is_any || m_work.passes[guest];
        }
    m_shared_draws += is_any ? 1 : 0;
    std::erase_if(m_apart, [this](const auto& one) {
        constexpr std::uint64_t pictures = 600;  // without a request
        return one.second.asked + pictures < m_picture_number;
    });
}

std::size_t Executor::host_of(std::size_t pass) const {
    return m_plan.targets[pass].onto.value_or(pass);
}

bool Executor::is_followed_onto(std::size_t pass) const {
    const auto place = std::ranges::find(m_order, pass);
    return place != m_order.end() && place + 1 != m_order.end() &&
           host_of(place[1]) == host_of(pass);
}

bool Executor::draws(std::size_t pass, Draw shape) const {
    return m_look.passes[pass].draw == shape && m_work.passes[pass] && !is_kept(pass);
}

bool Executor::draws_points() const {
    for (std::size_t i = 0; i < m_passes.size(); ++i)
        if (draws(i, Draw::points))
            return true;
    return false;
}

std::optional<BeamSpot> Executor::smallest_spot() {
    std::optional<BeamSpot> smallest;
    for (std::size_t i = 0; i < m_passes.size(); ++i) {
        if (!draws(i, Draw::segments))
            continue;
        if (m_spots.empty())
            m_spots.resize(m_passes.size());
        if (!m_spots[i])
            m_spots[i] =
                spot_of(m_look, m_look.passes[i], m_viewport, m_plan.targets[i].extent, m_values)
                    .value_or(BeamSpot{});
        const BeamSpot& spot = *m_spots[i];
        smallest = smallest ? BeamSpot{std::min(smallest->across, spot.across),
                                       std::min(smallest->up, spot.up)}
                            : spot;
    }
    return smallest;
}

// Advances the history by one frame.
void Executor::move_on(bool is_unfinished) {
    for (std::size_t i = 0; i < m_targets.size(); ++i) {
        if (is_unfinished && may_be_unfinished(i))
            m_targets[i].begin(Target::Unfinished::next);
        else
            m_targets[i].advance();
        if (is_kept(i))
            m_targets[i].keep();
    }
    m_source.advance();
}

void Executor::draw_passes() {
    ++m_picture_number;
    const gpu::DrawScope scope;
    for (const std::size_t pass : m_order) {
        if (m_work.passes[pass])
            draw_pass(pass);
        release_after(pass);
    }
    check_frame();
    m_samplers.release();
    m_draw_calls = m_work.draw_calls;
}

// No later pass of the frame reads these pictures.
void Executor::release_after(std::size_t pass) {
    for (std::size_t i = 0; i < m_plan.targets.size(); ++i)
        if (m_plan.targets[i].common && m_plan.targets[i].held_until == pass)
            m_targets[i].release(m_work.passes[i]);
}

void Executor::draw_pass(std::size_t index) {
    if (!begin_pass(index))
        return;
    PassState& state = m_passes[index];
    if (m_work.draws > m_work.first_draw)
        state.timer->begin(m_work.draws - m_work.first_draw);
    for (int i = m_work.first_draw; i < m_work.draws; ++i) {
        start_draw(index, i);
        draw_shape(index);
        end_draw(index);
    }
    state.timer->end();
    end_pass(index);
}

// False if the program of the pass draws nothing.
bool Executor::begin_pass(std::size_t index) {
    if (is_kept(index))
        return false;
    m_targets[index].make_room();
    m_targets[index].note_drawn();
    if (run_of(index) == PassRun::bypassed) {
        pass_through(index);
        return false;
    }
    const Pass& pass = m_look.passes[index];
    PassState& state = m_passes[index];
    if (pass.accumulate && m_work.is_again)
        return false;
    state.program->use();
    write_built_ins(index);
    m_work.first_draw = 0;
    if (pass.accumulate) {
        count_samples(index);
        return true;
    }
    // A pass that reads its own history advances with each repetition. When it is redrawn, only the
    // input of its last repetition still exists, so only that one is drawn.
    m_work.draws = repeats_of(pass);
    if (m_work.is_again && state.reads_itself)
        m_work.first_draw = m_work.draws - 1;
    return true;
}

void Executor::start_draw(std::size_t index, int draw) {
    PassState& state = m_passes[index];
    const bool is_first = draw == m_work.first_draw;
    const bool accumulates = m_look.passes[index].accumulate;
    if (!is_first && state.reads_itself)
        m_targets[index].advance();
    if (is_first || state.reads_itself) {
        start_target(index, accumulates && state.samples > 0);
        aim(index);
    }
    write_sample(index, draw);
}

void Executor::write_sample(std::size_t index, int draw) {
    const PassState& state = m_passes[index];
    const int sample =
        m_look.passes[index].accumulate ? state.samples : samples_before(index) + draw;
    state.built_ins.write_samples(*state.program, sample);
}

void Executor::end_draw(std::size_t index) {
    ++m_work.draw_calls;
    if (m_look.passes[index].accumulate)
        ++m_passes[index].samples;
}

void Executor::end_pass(std::size_t index) {
    if (is_followed_onto(index))
        return;
    const std::size_t host = host_of(index);
    check_pass(host);
    m_targets[host].canvas().texture().generate_mipmaps();
}

PassFacts Executor::facts_of_pass(std::size_t index) const {
    const Pass& pass = m_look.passes[index];
    const gpu::Texture* texture = m_source.texture(0);
    const Extent source =
        source_extent_of(m_look, pass, m_plan, texture ? texture->extent() : m_source_extent);
    const std::int64_t modulo =
        pass.frame_modulo > 0 ? pass.frame_modulo : std::numeric_limits<std::int64_t>::max();
    const std::int64_t before = std::max<std::int64_t>(m_drawn.number - 1, 0);
    return {
        static_cast<double>(m_drawn.number % modulo),
        static_cast<double>(before % modulo),
        m_plan.targets[index].extent,
        m_viewport,
        source,
        pass.source.empty() && m_drawn.source_raster ? *m_drawn.source_raster : own_raster(source),
        pass.rows,
        meets_drawn_onto(m_look, m_plan, index),
        [this, source](const BoundInput& input) {
            if (input.from == Input::From::pass && input.pass >= 0)
                return m_plan.targets[static_cast<std::size_t>(input.pass)].extent;
            const gpu::Texture* read = texture_for(input);
            return read ? read->extent() : source;
        }};
}

void Executor::write_built_ins(std::size_t index) const {
    const PassState& state = m_passes[index];
    state.built_ins.write(*state.program, m_drawn, facts_of_pass(index));
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

PassReport Executor::report(int pass) const {
    const auto index = static_cast<std::size_t>(pass);
    const PassState& state = reported_state(index);
    PassReport report;
    for (const BoundInput& input : state.inputs) {
        SamplerReport sampler{input.uniform, choice_of(input, m_look), {}, {}, {}};
        if (const gpu::Texture* texture = texture_for(input)) {
            sampler.extent = texture->extent();
            sampler.format = texture->format();
            sampler.sampler = gpu::usable_sampler(input.sampler, texture->format());
        }
        report.samplers.push_back(std::move(sampler));
    }
    const Pass& declared = m_look.passes[index];
    const int samples = declared.accumulate ? std::max(m_passes[index].samples - 1, 0)
                                            : samples_before(index) + repeats_of(declared) - 1;
    report.built_ins = state.built_ins.report(m_drawn, facts_of_pass(index), samples);
    return report;
}

// Initialises the target: the picture so far, or the neutral colour of the pass's blending.
void Executor::start_target(std::size_t index, bool goes_on) {
    if (host_of(index) != index)
        return;
    const Pass& pass = m_look.passes[index];
    Target& target = m_targets[index];
    const bool is_whole = m_passes[index].covers_target;
    if (goes_on && !is_whole && target.has_former())
        target.canvas(1).copy_to(target.canvas());
    else if (!goes_on && !is_whole && pass.blend == Blend::multiply)
        target.canvas().clear({1.0f, 1.0f, 1.0f, 1.0f});
    else if (!goes_on && !is_whole)
        target.canvas().clear();
}

// Binds the target and the inputs of the next draws.
void Executor::aim(std::size_t index) {
    const Pass& pass = m_look.passes[index];
    const std::size_t host = host_of(index);
    m_targets[host].canvas().bind();
    if (host != index)
        gpu::set_blend_onto();
    else
        gpu::set_blend(facts_of(pass.format).is_integer ? Blend::replace : pass.blend);
    bind(m_passes[index]);
}

namespace {
using Sampled = gpu::Uniform::Sampled;

// Of 2D textures.
std::optional<SampleKind> kind_read_by(Sampled sampled) {
    switch (sampled) {
        case Sampled::floating:
            return SampleKind::floating;
        case Sampled::natural:
            return SampleKind::natural;
        case Sampled::integer:
            return SampleKind::integer;
        default:
            return std::nullopt;
    }
}

bool can_read(Sampled sampled, const gpu::Texture& texture) {
    if (const auto kind = kind_read_by(sampled))
        return texture.shape() == PictureShape::flat && sample_kind_of(texture.format()) == *kind;
    switch (sampled) {
        case Sampled::cube:
            return texture.shape() == PictureShape::cube;
        case Sampled::volume:
            return texture.shape() == PictureShape::volume;
        default:
            return false;
    }
}
}  // namespace

void Executor::bind(const PassState& state) const {
    for (const BoundInput& input : state.inputs) {
        const gpu::Texture* texture =
            input.sampled == Sampled::cube ? cube_for(input) : texture_for(input);
        if (!texture || !can_read(input.sampled, *texture)) {
            const auto kind = kind_read_by(input.sampled);
            texture = kind ? &m_empty.at(*kind).texture() : nullptr;
        }
        if (texture)
            m_samplers.bind(input.unit, *texture, input.sampler);
        else
            m_samplers.bind_nothing(input.unit);
    }
}

// Faces that a pass drew are copied into a cube map.
const gpu::Texture* Executor::cube_for(const BoundInput& input) const {
    if (input.from != Input::From::pass)
        return texture_for(input);
    const Target& target = m_targets[static_cast<std::size_t>(input.pass)];
    return m_cubes.copy_of(target.canvas(input.frames_ago), input.sampler.mipmap);
}

const gpu::Texture* Executor::texture_for(const BoundInput& input) const {
    if (!input.from)
        return nullptr;
    if (*input.from == Input::From::source)
        return m_source.texture(input.frames_ago);
    if (*input.from == Input::From::keyboard)
        return m_keyboard.texture();
    if (*input.from == Input::From::pass)
        return &m_targets[static_cast<std::size_t>(input.pass)].canvas(input.frames_ago).texture();
    if (*input.from == Input::From::sound)
        return m_sound.find(input.sound);
    const auto image = m_images.find(input.image);
    return image == m_images.end() ? nullptr : image->second.get();
}

void Executor::draw_shape(std::size_t index) const {
    const Draw shape = m_look.passes[index].draw;
    m_passes[index].vertices.bind();
    if (const int location = m_passes[index].tint_location; location >= 0)
        m_beam.choose_tints(m_passes[index].vertices, location, shape);
    if (shape == Draw::points)
        gpu::draw_points(m_beam.point_count());
    else if (shape == Draw::segments)
        gpu::draw_quads(m_beam.segment_count());
    else if (shape == Draw::quad)
        gpu::draw_quads(1);
    else
        gpu::draw_triangle();
}
