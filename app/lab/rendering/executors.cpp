#include "lab/rendering/executors.h"

#include "model/plan/parameter_use.h"

#include <algorithm>

Result<void> Executors::for_both(const Act& act) {
    if (auto done = act(m_picture); !done || !m_variant)
        return done;
    auto done = act(*m_variant);
    if (!done)
        end_variant();
    return done;
}

Result<void> Executors::for_drawn(const Act& act) {
    if (!m_is_variant_alone)
        return for_both(act);
    auto done = act(*m_variant);
    if (!done)
        end_variant();
    return done;
}

Result<void> Executors::start_variant(const Values& values) {
    const FrameSettings& settings = m_picture.graph().settings();
    m_variant = std::make_unique<Executor>(m_picture.look(), m_picture.programs().generic());
    m_variant->set_values(values);
    m_is_variant_alone = true;
    auto started = m_variant->set_runs(settings.runs);
    if (started)
        started = m_variant->set_displayed(settings.displayed);
    if (started && !settings.viewport.is_empty())
        started = m_variant->resize(settings.viewport, settings.source);
    if (!started)
        end_variant();
    return started;
}

void Executors::end_variant() {
    m_is_variant_alone = false;
    m_variant.reset();
}

Result<void> Executors::set_source(const Picture& picture, double pixel_aspect,
                                   const std::optional<SourceRaster>& raster) {
    m_inputs.pixel_aspect = pixel_aspect;
    m_inputs.source_raster = raster;
    return for_drawn([&](Executor& executor) { return executor.set_source(picture); });
}

Result<void> Executors::set_image(const std::string& name, const Picture& picture) {
    return for_drawn([&](Executor& executor) { return executor.set_image(name, picture); });
}

void Executors::set_image(const std::string& name,
                          const std::shared_ptr<const gpu::Texture>& texture) {
    if (!m_is_variant_alone)
        m_picture.set_image(name, texture);
    if (m_variant)
        m_variant->set_image(name, texture);
}

Frame Executors::next_frame(const PlayedFrame& played, const Beam& beam) const {
    Frame frame = frame_of(m_inputs, played, beam);
    if (m_variant)
        frame.sample_budget_seconds /= 2.0;
    return frame;
}

void Executors::draw(const PlayedFrame& played, const Beam& beam, const std::vector<bool>* passes,
                     Slices slices) {
    const Frame frame = next_frame(played, beam);
    if (!m_is_variant_alone)
        m_picture.draw(frame, passes, slices);
    if (m_variant)
        m_variant->draw(frame, passes, slices);
    m_inputs.input_state.note_drawn();
}

void Executors::redraw(const PlayedFrame& played, const Beam& beam, const std::vector<bool>& passes,
                       Slices slices) {
    const Frame frame = next_frame(played, beam);
    m_picture.redraw(frame, passes, slices);
    if (m_variant)
        m_variant->redraw(frame, passes, slices);
}

void draw_unseen(Executors& executors, const PlayedFrame& played, const Beam& beam) {
    const std::vector<bool> carried = feedback_passes(executors.picture().look());
    executors.draw(played, beam, &carried);
}

namespace {
// Also changes the sizes of targets that depend on a changed value.
Result<void> set_planned_values(Executor& executor, const Values& values) {
    const Values before = executor.graph().values();
    executor.set_values(values);
    const Look& look = executor.look();
    const bool is_resized = std::ranges::any_of(look.parameters, [&](const Parameter& parameter) {
        return value_of(parameter, before) != value_of(parameter, executor.graph().values()) &&
               drives_size(look, parameter);
    });
    const FrameSettings settings = executor.graph().settings();
    return is_resized ? executor.resize(settings.viewport, settings.source) : Result<void>{};
}
}  // namespace

Result<void> modulate(Executors& executors, const ModulatedValues& values, double seconds,
                      const Loudness* loudness) {
    if (values.modulations.empty() && !values.cues)
        return {};
    const Look& look = executors.picture().look();
    const auto at_frame = [&](const CuedState& state) {
        return modulated(look, state.values, state.modulations, seconds, loudness, values.tempo);
    };
    const CuedState stored{values.picture, values.modulations};
    if (Executor* variant = executors.variant())
        variant->set_values(at_frame({values.variant, values.modulations}));
    if (executors.is_variant_alone())
        return {};
    if (values.cues)
        return set_planned_values(executors.picture(),
                                  at_frame(values.cues->state_at(look, stored, values.position)));
    executors.picture().set_values(at_frame(stored));
    return {};
}
