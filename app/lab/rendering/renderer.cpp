#include "lab/rendering/renderer.h"

#include "base/elapsed.h"

#include <algorithm>
#include <utility>

void Renderer::change_input_state(const std::function<void(InputState&)>& change) {
    InputState& input_state = m_executors.inputs().input_state;
    const auto position = input_state.position();
    const bool was_down = input_state.press().is_down;
    change(input_state);
    if (input_state.position() != position || input_state.press().is_down != was_down)
        note_mouse();
}

// Keeps the samples of an unfinished frame.
void Renderer::note_mouse() {
    m_has_new_mouse = has_unfinished_frame();
    if (m_has_new_mouse)
        return;
    m_executors.picture().drawer().note_mouse_moved();
    if (Executor* variant = m_executors.variant())
        variant->drawer().note_mouse_moved();
}

bool Renderer::has_whole_picture() const {
    const Executor* variant = m_executors.variant();
    const bool is_one_ahead = variant && variant->drawer().has_unfinished_frame() !=
                                             executor().drawer().has_unfinished_frame();
    return m_holds_picture && !is_one_ahead && (!m_unfinished || m_is_double_buffered);
}

bool Renderer::has_converged() const {
    const Executor* variant = m_executors.variant();
    return executor().drawer().has_converged() && (!variant || variant->drawer().has_converged());
}

void Renderer::draw(const PlayedFrame& played, const Beam& beam) {
    const auto start = std::chrono::steady_clock::now();
    drop_frame();
    m_was_dropped = false;
    if (m_slicing.is_due()) {
        const Slices slices =
            begin_slices({.is_whole = true, .played = played, .points = beam.size()});
        m_executors.draw(played, beam, nullptr, slices);
        continue_frame();
        return;
    }
    m_executors.draw(played, beam);
    const double took = seconds_since(start);
    note_whole(played, beam.size(), took);
    m_slicing.note(std::max(took, m_times.gpu_seconds()));
}

void Renderer::draw_unseen(const PlayedFrame& played, const Beam& beam) {
    drop_frame();
    if (!m_slicing.is_due())
        return ::draw_unseen(m_executors, played, beam);
    const std::vector<bool> carried = feedback_passes(executor().look());
    m_executors.draw(played, beam, &carried, begin_slices({}));
    continue_frame();
}

namespace {
bool draws_beam(const Look& look, const std::vector<bool>& passes) {
    for (std::size_t i = 0; i < std::min(look.passes.size(), passes.size()); ++i)
        if (passes[i] && is_of_beam(look.passes[i].draw))
            return true;
    return false;
}
}  // namespace

void Renderer::redraw(const Player& player, const std::vector<bool>& passes) {
    if (player.transport().past().empty())
        return;
    const PlayedFrame& current = player.transport().past().back();
    const Beam beam =
        draws_beam(executor().look(), passes) ? player.signal().trace(current.span) : Beam();
    drop_frame();
    if (m_slicing.is_due()) {
        m_executors.redraw(current, beam, passes, begin_slices({.is_again = true}));
        continue_frame();
        return;
    }
    m_executors.redraw(current, beam, passes);
    m_has_drawn = m_holds_picture = true;
}

Slices Renderer::begin_slices(const Unfinished& unfinished) {
    m_is_double_buffered =
        m_holds_picture && m_slicing.is_heavy() && executor().drawer().can_double_buffer();
    m_unfinished = unfinished;
    return m_is_double_buffered ? Slices::double_buffered : Slices::in_place;
}

bool Renderer::continue_frame(double seconds) {
    const auto begun = std::chrono::steady_clock::now();
    bool was_dropped = true;
    bool is_whole = true;
    for (Executor* executor : {&m_executors.picture(), m_executors.variant()}) {
        if (!executor || !executor->drawer().has_unfinished_frame())
            continue;
        was_dropped = false;
        is_whole = executor->drawer().continue_frame(seconds - seconds_since(begun)) && is_whole;
    }
    if (was_dropped) {
        m_was_dropped = m_was_dropped || m_unfinished;
        end_unfinished();
        return true;
    }
    m_unfinished->seconds += seconds_since(begun);
    if (is_whole)
        finish_frame();
    return is_whole;
}

void Renderer::finish_frame() {
    const Unfinished done = *m_unfinished;
    end_unfinished();
    m_holds_picture = m_holds_picture || done.is_again;
    m_has_drawn = m_has_drawn || done.is_again;
    if (!done.is_whole)
        return;
    note_whole(done.played, done.points, done.seconds);
    m_slicing.note(done.seconds);
}

void Renderer::note_whole(const PlayedFrame& played, std::size_t points, double seconds) {
    m_has_drawn = m_holds_picture = true;
    m_times.add(m_executors.picture(),
                {played.span.seconds(), points, seconds, m_executors.variant() != nullptr});
}

void Renderer::end_unfinished() {
    m_unfinished.reset();
    if (std::exchange(m_has_new_mouse, false))
        note_mouse();
}

void Renderer::drop_frame() {
    m_was_dropped = m_was_dropped || m_unfinished;
    end_unfinished();
    m_executors.picture().drawer().drop_frame();
    if (Executor* variant = m_executors.variant())
        variant->drawer().drop_frame();
}

void Renderer::clear_history() {
    drop_frame();
    m_holds_picture = m_holds_picture && m_executors.is_variant_alone();
    static_cast<void>(m_executors.for_drawn([](Executor& executor) {
        executor.clear_history();
        return Result<void>();
    }));
}

void Renderer::reset() {
    drop_frame();
    m_slicing.forget();
    m_holds_picture = false;
}
