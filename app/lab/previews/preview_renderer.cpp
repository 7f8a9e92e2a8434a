#include "lab/previews/preview_renderer.h"

#include "base/elapsed.h"
#include "lab/document/users_content.h"
#include "lab/storage/local_date.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace {
constexpr double sample_budget_seconds = 0.01;  // for accumulating passes

std::vector<PlayedFrame> latest(const Player& player, std::size_t frames) {
    const auto& past = player.transport().past();
    const std::size_t count = std::min(frames, past.size());
    return {past.end() - static_cast<std::ptrdiff_t>(count), past.end()};
}
}  // namespace

Result<PreviewRenderer> PreviewRenderer::make(const PreviewSubject& subject, const Values& values,
                                              const Values* others, std::size_t frames) {
    Executors executors(
        Executor(subject.document.drawn_look(), subject.shown.executor().programs().generic()));
    FrameInputs& inputs = executors.inputs();
    inputs.shows_whole = true;
    inputs.beam_fit = beam_fit_of(subject.document.state().signal);
    inputs.sound = subject.player.signal().sound_texels();
    inputs.date = local_date();
    inputs.sample_budget_seconds = sample_budget_seconds;
    inputs.input_state.move(subject.shown.executors().inputs().input_state.position());
    executors.picture().set_values(values);
    const Extent source = subject.media.source().extent(subject.picture);
    if (auto sized = executors.picture().resize(subject.picture,
                                                source.is_empty() ? subject.picture : source);
        !sized)
        return fail(sized.error());
    if (others) {
        if (auto started = executors.start_variant(*others); !started)
            return fail(started.error());
        executors.set_variant_alone(false);  // from now on, both get the same input
    }
    PreviewRenderer trial(std::move(executors), latest(subject.player, frames));
    trial.m_values = values;
    trial.m_other_values = others ? *others : Values();
    if (auto done = trial.show_pictures(subject, values, others); !done)
        return fail(done.error());
    return trial;
}

Result<void> PreviewRenderer::show_pictures(const PreviewSubject& subject, const Values& values,
                                            const Values* others) {
    for (const auto& [name, texture] : subject.images)
        m_executors.set_image(name, texture);
    const Look& look = executor().look();
    // Unreadable files are black, as in the window, which has already reported them.
    static_cast<void>(m_chosen_images.show(look, values, m_executors.picture()));
    if (others)
        static_cast<void>(m_other_images.show(look, *others, *m_executors.variant()));
    return subject.media.source().show_in(subject.player.transport().time(),
                                          {m_executors, subject.picture, m_source});
}

Result<void> PreviewRenderer::start_again(const Values& values) {
    m_values = values;
    Executor& picture = m_executors.picture();
    picture.set_values(values);
    static_cast<void>(m_chosen_images.show(picture.look(), values, picture));
    m_done = 0;
    return m_executors.for_both([](Executor& executor) {
        const FrameSettings& settings = executor.graph().settings();
        auto sized = executor.resize(settings.viewport, settings.source);
        if (sized)
            executor.clear_history();
        return sized;
    });
}

bool PreviewRenderer::has_samples() const {
    const auto samples = executor().drawer().samples();
    return !samples || m_frames.empty() || samples->held >= samples->enough.value_or(0);
}

// Repeats the last frame until accumulating passes have enough samples.
void PreviewRenderer::draw_next(const PreviewSubject& subject) {
    const bool is_last = m_done + 1 >= m_frames.size();
    const PlayedFrame& frame = m_frames[std::min(m_done, m_frames.size() - 1)];
    m_done = std::min(m_done + 1, m_frames.size());
    // Errors are ignored, because a missing film picture affects all compared pictures.
    static_cast<void>(subject.media.source().show_past_in(
        frame.span.end, {m_executors, subject.picture, m_source}));
    const DocumentState& state = subject.document.state();
    static_cast<void>(modulate(m_executors,
                               {m_values, m_other_values, state.modulations, state.tempo},
                               frame.span.end, subject.player.signal().loudness().get()));
    const Beam beam = subject.player.signal().trace(frame.span);
    if (is_last)
        m_executors.draw(frame, beam);
    else
        draw_unseen(m_executors, frame, beam);
}

bool PreviewRenderer::update(const PreviewSubject& subject, double seconds) {
    if (!is_running())
        return false;
    const auto start = std::chrono::steady_clock::now();
    while (is_running() && seconds_since(start) < seconds)
        draw_next(subject);
    return !is_running();
}

std::string preview_error(const Parameter& constant) {
    return fmt::format(
        "\"{}\" is a constant, so changing it recompiles the look. Change it directly, or render a "
        "sheet with 'afterglow sweep'.",
        constant.label);
}

std::size_t affordable_frames(const Look& look, const Renderer& shown, double seconds,
                              double times) {
    constexpr double fewest = 4.0;
    const double all = std::max(look.settle_frames, 1);
    const double bearable = seconds / std::max(shown.times().frame_seconds() * times, 1e-6);
    return static_cast<std::size_t>(std::clamp(bearable, std::min(fewest, all), all));
}
