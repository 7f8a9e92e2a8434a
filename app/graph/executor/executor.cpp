#include "graph/executor/executor.h"

#include "gpu/context.h"
#include "graph/targets/image_texture.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace {
// Whether passes that keep their programs are bound in the same way.
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

Executor::Parts::Parts(Look look, Programs linked)
    : graph(std::move(look), gpu::read_info().largest_texture),
      programs(graph, shapes, std::move(linked)),
      textures(graph, programs.context()),
      drawer(graph, shapes, programs, textures) {
    textures.set_views(programs.generic().views);
}

Executor::Executor(Look look, Programs programs) {
    const gpu::ContextScope scope(programs.context.get());
    m_parts = std::make_unique<Parts>(std::move(look), std::move(programs));
    note_programs();
}

Executor::~Executor() {
    if (!m_parts)
        return;
    const std::shared_ptr<gpu::Context> context = m_parts->programs.context();
    const gpu::ContextScope scope(context.get());
    m_parts.reset();
}

Executor& Executor::operator=(Executor&& other) noexcept {
    std::swap(m_parts, other.m_parts);
    return *this;
}

void Executor::note_programs() {
    m_parts->graph.set_read_inputs(m_parts->programs.read_inputs());
}

Result<void> Executor::replace(Look look, Programs programs) {
    auto& [graph, shapes, bound, textures, drawer] = *m_parts;
    const gpu::ContextScope scope(bound.context().get());
    drawer.drop_frame();
    if (!graph.plan().targets.empty()) {
        auto plan = graph.plan_for(look);
        if (!plan)
            return fail(plan.error());
        if (auto allocated = textures.allocate(look, *plan); !allocated)
            return allocated;
        if (*plan != graph.plan())
            drawer.targets_replaced();
        graph.set_plan(std::move(*plan));
    }
    const bool is_bound_alike = are_bound_alike(look, graph.look());
    graph.set_look(std::move(look));
    textures.set_views(programs.views);
    textures.note_changed();
    drawer.reset_passes(bound.replace(std::move(programs), is_bound_alike));
    note_programs();
    return {};
}

Result<void> Executor::resize(Extent viewport, Extent source) {
    FrameSettings settings = m_parts->graph.settings();
    settings.viewport = viewport;
    settings.source = source;
    return set_planned(std::move(settings));
}

// Before the first resize() nothing is planned.
Result<void> Executor::set(FrameSettings settings) {
    if (!m_parts->graph.plan().targets.empty())
        return set_planned(std::move(settings));
    m_parts->graph.set_settings(std::move(settings));
    return {};
}

Result<void> Executor::set_planned(FrameSettings settings) {
    auto& [graph, shapes, programs, textures, drawer] = *m_parts;
    const gpu::ContextScope scope(programs.context().get());
    auto plan = graph.plan_for(settings);
    if (!plan)
        return fail(plan.error());
    if (graph.plan().targets.empty() || *plan != graph.plan()) {
        drawer.drop_frame();
        if (auto allocated = textures.allocate(graph.look(), *plan); !allocated)
            return allocated;
        // Specialised programs contain which pass was drawn onto which.
        const bool share_alike = std::ranges::equal(plan->targets, graph.plan().targets, {},
                                                    &PlannedTarget::onto, &PlannedTarget::onto);
        graph.set_plan(std::move(*plan));
        if (!share_alike) {
            programs.end_specialized();
            note_programs();
        }
        drawer.targets_replaced();
    }
    graph.set_settings(std::move(settings));
    return {};
}

Result<void> Executor::set_displayed(std::vector<bool> displayed, Redraws redraws) {
    FrameSettings settings = m_parts->graph.settings();
    settings.displayed = std::move(displayed);
    settings.redraws = redraws;
    return set(std::move(settings));
}

Result<void> Executor::set_runs(std::vector<PassRun> runs) {
    auto& [graph, shapes, programs, textures, drawer] = *m_parts;
    const gpu::ContextScope scope(programs.context().get());
    if (std::ranges::find(runs, PassRun::bypassed) != runs.end())
        if (auto prepared = drawer.prepare_bypass(); !prepared)
            return prepared;
    drawer.drop_frame();
    std::vector<bool> changed(programs.size(), false);
    for (std::size_t i = 0; i < changed.size(); ++i)
        changed[i] = graph.run_of(i) != (i < runs.size() ? runs[i] : PassRun::drawn);
    FrameSettings settings = graph.settings();
    settings.runs = std::move(runs);
    if (auto planned = set(std::move(settings)); !planned)
        return planned;
    drawer.restart_samples(changed);
    return {};
}

void Executor::set_values(const Values& values) {
    auto& [graph, shapes, programs, textures, drawer] = *m_parts;
    const gpu::ContextScope scope(programs.context().get());
    const std::vector<std::string> changed = graph.set_values(values);
    if (!changed.empty())
        drawer.restart_samples(redraw_after(graph.look(), changed).passes);
    const bool was_specialized = programs.is_specialized();
    programs.write(changed);
    if (!was_specialized || programs.is_specialized())
        return;
    drawer.drop_frame();
    note_programs();
}

void Executor::specialize(Programs programs, std::set<std::string> moving) {
    const gpu::ContextScope scope(m_parts->programs.context().get());
    m_parts->drawer.drop_frame();
    m_parts->programs.specialize(std::move(programs), std::move(moving));
    note_programs();
}

Result<void> Executor::set_source(const Picture& picture) {
    const gpu::ContextScope scope(m_parts->programs.context().get());
    std::vector<bool> readers;
    for (const Pass& pass : look().passes)
        readers.push_back(std::ranges::any_of(
            pass.inputs, [](const Input& input) { return input.from == Input::From::source; }));
    m_parts->drawer.restart_samples(readers);
    return m_parts->textures.set_source(picture);
}

Result<void> Executor::set_image(const std::string& name, const Picture& picture) {
    const gpu::ContextScope scope(m_parts->programs.context().get());
    auto texture = image_texture(look(), name, picture);
    if (!texture)
        return fail(texture.error());
    set_image(name, std::move(*texture));
    return {};
}

void Executor::set_image(const std::string& name, std::shared_ptr<const gpu::Texture> texture) {
    m_parts->textures.set_image(name, std::move(texture));
    m_parts->drawer.restart_samples();
}

void Executor::draw(const Frame& frame, const std::vector<bool>* passes, Slices slices) {
    if (frame.is_first)
        clear_history();
    m_parts->drawer.draw(frame, passes, slices);
}

void Executor::redraw(const Frame& frame, const std::vector<bool>& passes, Slices slices) {
    m_parts->drawer.redraw(frame, passes, slices);
}

void Executor::clear_history() {
    auto& [graph, shapes, programs, textures, drawer] = *m_parts;
    const gpu::ContextScope scope(programs.context().get());
    drawer.drop_frame();
    textures.note_changed();
    for (std::size_t i = 0; i < textures.targets().size(); ++i)
        if (graph.run_of(i) != PassRun::frozen)
            textures.targets()[i].clear();
    textures.clear_source();
    shapes.beam.clear();
    drawer.restart_samples();
}

void Executor::clear_history(int pass) {
    auto& [graph, shapes, programs, textures, drawer] = *m_parts;
    const auto index = static_cast<std::size_t>(pass);
    if (index >= textures.targets().size())
        return;  // nothing has been drawn yet
    const gpu::ContextScope scope(programs.context().get());
    drawer.drop_frame();
    textures.note_changed();
    textures.targets()[index].clear();
    std::vector<bool> changed(programs.size(), false);
    changed[index] = true;
    drawer.restart_samples(changed);
}

const gpu::Texture& Executor::target(int pass) const {
    const auto index = static_cast<std::size_t>(pass);
    return m_parts->textures.with_row_order(m_parts->drawer.picture(index),
                                            look().passes[index].rows);
}

const gpu::Texture* Executor::texture(const TextureChoice& choice) const {
    const FrameTextures& textures = m_parts->textures;
    const BoundInput read =
        bound_input(look(), static_cast<int>(look().passes.size()),
                    {{}, choice.from, choice.name, choice.frames_ago, {}, choice.sound});
    if (choice.from != Input::From::pass) {
        const gpu::Texture* stored = textures.stored(choice);
        return stored ? &textures.with_row_order(*stored, textures.rows_of(read)) : nullptr;
    }
    const auto pass = static_cast<std::size_t>(find_pass(look(), choice.name).value_or(-1));
    if (pass >= textures.targets().size())
        return nullptr;
    const Target& target = textures.targets()[pass];
    if (choice.frames_ago >= target.planned().slots - (target.planned().common ? 1 : 0))
        return nullptr;
    return &textures.with_row_order(choice.frames_ago == 0
                                        ? m_parts->drawer.picture(pass)
                                        : target.finished(choice.frames_ago).texture(),
                                    textures.rows_of(read));
}

std::vector<bool> read_dependencies_of(const Executor& executor,
                                       const std::vector<bool>& displayed) {
    std::vector<bool> read(executor.programs().size(), false);
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < std::min(displayed.size(), read.size()); ++i)
        if (displayed[i])
            open.push_back(i);
    const std::vector<PlannedTarget>& planned = executor.plan().targets;
    while (!open.empty()) {
        const std::size_t pass = open.back();
        open.pop_back();
        if (read[pass])
            continue;
        read[pass] = true;
        for (std::size_t guest = 0; guest < planned.size(); ++guest)
            if (planned[guest].onto == pass)
                open.push_back(guest);
        for (const BoundInput& input : executor.programs()[pass].inputs)
            if (input.from == Input::From::pass && input.pass >= 0)
                open.push_back(static_cast<std::size_t>(input.pass));
    }
    return read;
}

double bytes_per_pixel(const Executor& executor) {
    const std::vector<PlannedTarget>& planned = executor.plan().targets;
    const auto bytes_of = [&](std::size_t pass) {
        const PlannedTarget& target = planned[pass];
        if (target.onto)
            return 0.0;
        return static_cast<double>(target.extent.width) * target.extent.height *
               info_of(target.format).bytes;
    };
    double bytes = 0.0;
    for (std::size_t i = 0; i < planned.size(); ++i) {
        if (executor.textures().is_kept(i))
            continue;
        bytes += bytes_of(i);
        for (const BoundInput& input : executor.programs()[i].inputs)
            if (input.from == Input::From::pass && input.pass >= 0)
                bytes += bytes_of(static_cast<std::size_t>(input.pass));
    }
    const Extent picture = planned.back().extent;
    return bytes / (static_cast<double>(picture.width) * picture.height);
}
