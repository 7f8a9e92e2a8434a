#include "graph/executor/executor.h"

#include "gpu/context.h"
#include "graph/targets/image_texture.h"
#include "graph/view/view_programs.h"
#include "model/look/value_changes.h"

#include <algorithm>
#include <cassert>
#include <tuple>
#include <utility>

namespace {
// The built-in triangle and quad cover all texels. A user's vertex shader, points or `discard` may
// not.
bool covers(const Pass& pass) {
    return !is_of_beam(pass.draw) && pass.blend == Blend::replace && pass.vertex.file.empty() &&
           pass.fragment.text->find("discard") == std::string::npos;
}

// Whether make_state() has the same result for passes that keep their programs.
bool are_bound_alike(const Look& one, const Look& other) {
    const auto of_pass = [](const Pass& pass) {
        return std::tie(pass.name, pass.draw, pass.blend, pass.vertex.file, pass.inputs,
                        pass.built_ins);
    };
    const auto of_parameter = [](const Parameter& parameter) {
        return std::tie(parameter.name, parameter.control, parameter.bindings);
    };
    return std::ranges::equal(one.passes, other.passes, {}, of_pass, of_pass) &&
           std::ranges::equal(one.parameters, other.parameters, {}, of_parameter, of_parameter);
}
}  // namespace

Executor::Executor(Look look, Programs programs)
    : m_home(programs.home),
      m_scope(std::make_unique<gpu::ContextScope>(m_home.get())),
      m_look(std::move(look)),
      m_programs(std::move(programs)),
      m_largest_side(gpu::read_facts().largest_texture) {
    prepare();
    m_scope.reset();
}

Executor::PassState Executor::make_state(std::size_t pass) const {
    const auto& program = m_programs.passes[pass].program;
    const Pass& declared = m_look.passes[pass];
    PassState state{program,
                    BuiltInUniforms(m_look, static_cast<int>(pass), *program),
                    bind_inputs(m_look, static_cast<int>(pass), *program),
                    declared.draw == Draw::quad ? m_quad.vertices()
                                                : m_beam.vertices_for(*program, declared.draw),
                    is_of_beam(declared.draw) ? program->attribute_location("tint") : -1,
                    std::make_unique<gpu::Timer>()};
    state.reads_itself = std::ranges::any_of(state.inputs, [&](const BoundInput& input) {
        return input.from == Input::From::pass && input.pass == static_cast<int>(pass);
    });
    state.covers_target = covers(declared);
    return state;
}

void Executor::prepare() {
    assert(m_programs.passes.size() == m_look.passes.size());
    std::vector<PassState> old = std::exchange(m_passes, {});
    for (std::size_t i = 0; i < m_look.passes.size(); ++i) {
        const bool serves = i < old.size() && old[i].program == m_programs.passes[i].program;
        m_passes.push_back(serves ? std::move(old[i]) : make_state(i));
        m_passes.back().samples = m_passes.back().whole_samples = 0;
    }
    m_parameters = ParameterUniforms(m_look, m_programs);
    m_parameters.write(m_look, m_values);
    m_flipped_rows.forget();
    if (m_programs.views)
        m_flipped_rows.draw_with(part_of(m_programs.views, &ViewPrograms::pass_through));
}

Result<void> Executor::replace(Look look, Programs programs) {
    const gpu::ContextScope scope(m_home.get());
    drop_frame();
    PlanTerms terms = plan_terms();
    terms.read.clear();  // of the previous programs
    const bool has_other_passes = pass_names(look) != pass_names(m_look);
    if (has_other_passes)
        terms.seen.clear();
    if (auto made = m_keyboard.prepare(look); !made)
        return made;
    if (m_targets.size() > 0) {
        auto plan = plan_targets(look, m_viewport, m_source_extent, m_values, terms);
        if (!plan)
            return fail(plan.error());
        auto sound = SoundTextures::make(look);
        if (!sound)
            return fail(sound.error());
        auto targets = TargetSet::make(look, *plan, m_targets);
        if (!targets)
            return fail(targets.error());
        if (*plan != m_plan)
            forget_paces();
        m_plan = std::move(*plan);
        m_order = draw_order(m_plan);
        m_apart.clear();
        m_targets = std::move(*targets);
        m_source.set_slots(m_plan.source_slots);
        m_sound = std::move(*sound);
    }
    if (has_other_passes)
        m_displayed.clear();
    m_cubes = {};
    if (m_unsettled)
        take_own_back();
    m_spots.clear();
    if (!are_bound_alike(look, m_look)) {
        m_passes.clear();
        m_specialized_passes.clear();
    }
    m_look = std::move(look);
    m_programs = std::move(programs);
    ++m_picture_number;
    prepare();
    if (m_nan_detector)
        m_nan_detector->clear();
    return {};
}

Result<void> Executor::make_empty() {
    for (const auto& [kind, format] : {std::pair{SampleKind::floating, Format::rgba8},
                                       std::pair{SampleKind::natural, Format::r32ui},
                                       std::pair{SampleKind::integer, Format::r32i}}) {
        if (m_empty.contains(kind))
            continue;
        auto empty = gpu::Canvas::make({1, 1}, format);
        if (!empty)
            return fail(empty.error());
        m_empty.emplace(kind, std::move(*empty));
    }
    return {};
}

Result<void> Executor::resize(Extent viewport, Extent source) {
    const gpu::ContextScope scope(m_home.get());
    auto plan = plan_targets(m_look, viewport, source, m_values, plan_terms());
    if (!plan)
        return fail(plan.error());
    if (auto empty = make_empty(); !empty)
        return empty;
    if (auto made = m_keyboard.prepare(m_look); !made)
        return made;
    if (m_targets.size() == 0 || *plan != m_plan) {
        drop_frame();
        auto sound = SoundTextures::make(m_look);
        if (!sound)
            return fail(sound.error());
        auto targets = TargetSet::make(m_look, *plan, m_targets);
        if (!targets)
            return fail(targets.error());
        m_targets = std::move(*targets);
        m_sound = std::move(*sound);
        m_cubes = {};
        m_apart.clear();
        const bool share_alike = std::ranges::equal(plan->targets, m_plan.targets, {},
                                                    &PlannedTarget::onto, &PlannedTarget::onto);
        m_plan = std::move(*plan);
        m_order = draw_order(m_plan);
        if (!share_alike)
            end_specialized();  // those programs contain which pass was drawn onto which
        m_source.set_slots(m_plan.source_slots);
        ++m_picture_number;
        forget_paces();
        restart_samples();
    }
    m_viewport = viewport;
    m_source_extent = source;
    m_spots.clear();
    return {};
}

// The targets have other sizes.
void Executor::forget_paces() {
    for (PassState& state : m_passes)
        state.pace = {};
}

void Executor::set_values(const Values& values) {
    const gpu::ContextScope scope(m_home.get());
    const std::vector<std::string> changed = changed_parameters(m_look, m_values, values);
    if (!changed.empty()) {
        restart_samples(redraw_after(m_look, changed).passes);
        end_specialized_if_moved(changed);
        m_spots.clear();
    }
    follow_values(m_values, values);
    m_parameters.write(m_look, m_values, changed);
}

void Executor::invalidate_uniforms() {
    const gpu::ContextScope scope(m_home.get());
    m_parameters.forget_written();
    m_parameters.write(m_look, m_values);
}

Result<void> Executor::set_source(const Picture& picture) {
    const gpu::ContextScope scope(m_home.get());
    std::vector<bool> readers;
    for (const Pass& pass : m_look.passes)
        readers.push_back(std::ranges::any_of(
            pass.inputs, [](const Input& input) { return input.from == Input::From::source; }));
    restart_samples(readers);
    return m_source.set(picture, {m_look.source_encoding, m_look.source_rows, m_look.source_format,
                                  reads_mipmaps(m_look, Input::From::source, {})});
}

Result<void> Executor::set_image(const std::string& name, const Picture& picture) {
    const gpu::ContextScope scope(m_home.get());
    auto texture = image_texture(m_look, name, picture);
    if (!texture)
        return fail(texture.error());
    set_image(name, std::move(*texture));
    return {};
}

void Executor::set_image(const std::string& name, std::shared_ptr<const gpu::Texture> texture) {
    m_images.insert_or_assign(name, std::move(texture));
    restart_samples();
}

void Executor::clear_history() {
    const gpu::ContextScope scope(m_home.get());
    drop_frame();
    ++m_picture_number;
    for (std::size_t i = 0; i < m_targets.size(); ++i)
        if (run_of(i) != PassRun::frozen)
            m_targets[i].clear();
    m_source.clear();
    m_beam.clear();
    restart_samples();
}

std::vector<double> Executor::pass_milliseconds() {
    const gpu::ContextScope scope(m_home.get());
    std::vector<double> times;
    for (std::size_t i = 0; i < m_passes.size(); ++i) {
        const double time = m_passes[i].timer->milliseconds().value_or(0.0);
        times.push_back(i < m_targets.size() && is_kept(i) ? 0.0 : time);
    }
    return times;
}

int Executor::repeats_of(const Pass& pass) const {
    constexpr double most = 4096;
    return static_cast<int>(std::clamp(count_of(pass.repeat, m_look, m_values), 1.0, most));
}
