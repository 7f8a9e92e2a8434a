#include "lab/previews/preview_renderer.h"

#include "base/elapsed.h"
#include "lab/document/users_content.h"
#include "lab/storage/local_date.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace {
constexpr double patience_seconds = 0.01;  // for accumulating passes

std::vector<PlayedFrame> latest(const Player& player, std::size_t frames) {
    const auto& past = player.past();
    const std::size_t count = std::min(frames, past.size());
    return {past.end() - static_cast<std::ptrdiff_t>(count), past.end()};
}
}  // namespace

Result<PreviewRenderer> PreviewRenderer::make(const PreviewSubject& subject, const Values& values,
                                              const Values* others, std::size_t frames) {
    auto renderer = std::make_unique<Renderer>(subject.document.drawn_look(),
                                               subject.shown.executor().programs());
    renderer->set_values(values);
    renderer->set_modulations(subject.document.state().modulations);
    renderer->set_beam_fit(beam_fit_of(subject.document.state().signal));
    renderer->set_loudness(subject.player.loudness());
    renderer->set_sound(subject.player.sound_texels());
    renderer->set_date(local_date());
    renderer->set_patience(patience_seconds);
    renderer->set_mouse(subject.shown.mouse()[0], subject.shown.mouse()[1]);
    const Extent source = subject.media.source_extent(subject.picture);
    if (auto sized =
            renderer->resize(subject.picture, source.is_empty() ? subject.picture : source);
        !sized)
        return fail(sized.error());
    if (others) {
        if (auto started = renderer->start_variant(*others); !started)
            return fail(started.error());
        renderer->cancel_replay();  // from now on, both get the same input
    }
    PreviewRenderer trial(std::move(renderer), latest(subject.player, frames));
    if (auto done = trial.show_pictures(subject, values, others); !done)
        return fail(done.error());
    return trial;
}

Result<void> PreviewRenderer::show_pictures(const PreviewSubject& subject, const Values& values,
                                            const Values* others) {
    for (const auto& [name, texture] : subject.images)
        m_renderer->set_image(name, texture);
    const Look& look = executor().look();
    // Unreadable files are black, as in the window, which has already reported them.
    static_cast<void>(m_chosen_images.show(look, values, *m_renderer, Renderer::Whose::picture));
    if (others)
        static_cast<void>(
            m_other_images.show(look, *others, *m_renderer, Renderer::Whose::variant));
    return subject.media.show_beside(subject.player.time(),
                                     {*m_renderer, subject.picture, m_source});
}

Result<void> PreviewRenderer::start_again(const Values& values) {
    m_renderer->set_values(values);
    static_cast<void>(m_chosen_images.show(executor().look(), values, *m_renderer));
    if (auto sized = m_renderer->resize_again(); !sized)
        return sized;
    m_renderer->clear_history();
    m_renderer->restart_samples();
    m_done = 0;
    return {};
}

bool PreviewRenderer::has_samples() const {
    const auto samples = executor().samples();
    return !samples || m_frames.empty() || samples->held >= samples->enough.value_or(0);
}

// Repeats the last frame until accumulating passes have enough samples.
void PreviewRenderer::draw_next(const PreviewSubject& subject) {
    const bool is_last = m_done + 1 >= m_frames.size();
    const PlayedFrame& frame = m_frames[std::min(m_done, m_frames.size() - 1)];
    m_done = std::min(m_done + 1, m_frames.size());
    // Errors are ignored, because a missing film picture affects all compared pictures.
    static_cast<void>(
        subject.media.show_past_beside(frame.span.end, {*m_renderer, subject.picture, m_source}));
    m_renderer->invalidate_uniforms();
    const Beam beam = subject.player.trace(frame.span);
    if (is_last)
        m_renderer->draw(frame, beam);
    else
        m_renderer->draw_unseen(frame, beam);
}

bool PreviewRenderer::go_on(const PreviewSubject& subject, double seconds) {
    if (!is_running())
        return false;
    const auto start = std::chrono::steady_clock::now();
    while (is_running() && seconds_since(start) < seconds)
        draw_next(subject);
    return !is_running();
}

std::string why_untried(const Parameter& constant) {
    return fmt::format(
        "\"{}\" is a constant, so changing it recompiles the look. Change it directly, or render a "
        "sheet with 'afterglow sweep'.",
        constant.label);
}

std::size_t bearable_frames(const Look& look, const Renderer& shown, double seconds, double times) {
    constexpr double fewest = 4.0;
    const double all = std::max(look.settle_frames, 1);
    const double bearable = seconds / std::max(shown.frame_seconds() * times, 1e-6);
    return static_cast<std::size_t>(std::clamp(bearable, std::min(fewest, all), all));
}
