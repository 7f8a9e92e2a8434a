#include "lab/rendering/renderer.h"

#include "base/elapsed.h"
#include "model/look/value_changes.h"

#include <algorithm>
#include <chrono>
#include <utility>

// If the variant fails it is removed, and the picture continues.
template <class Act>
Result<void> Renderer::for_each(Act act) {
    if (!m_is_variant_alone)
        if (auto done = act(m_executor); !done)
            return done;
    if (!m_variant)
        return {};
    auto done = act(*m_variant);
    if (!done)
        end_variant();
    return done;
}

void Renderer::set_values(const Values& values) {
    follow_values(m_values, values);
    follow_values(m_drawn_values, values);
    m_executor.set_values(values);
}

// Sets the modulated values of the next frame. Sizes do not depend on modulated values.
void Renderer::move_values(double seconds) {
    if (m_modulations.empty())
        return;
    const Look& look = m_executor.look();
    const auto now = [&](const Values& values) {
        return modulated(look, values, m_modulations, seconds, m_loudness.get());
    };
    if (!m_is_variant_alone) {
        m_drawn_values = now(m_values);
        m_executor.set_values(m_drawn_values);
    }
    if (m_variant)
        m_variant->set_values(now(m_variant_values));
}

Result<void> Renderer::replace(Look look, Programs programs) {
    if (m_is_variant_alone)
        cancel_replay();
    drop_frame();
    m_slicing.forget();
    if (!m_variant)
        return m_executor.replace(std::move(look), std::move(programs));
    return for_each([&](Executor& executor) { return executor.replace(look, programs); });
}

Result<void> Renderer::replace(Whose whose, const Look& look, const Programs& programs) {
    drop_frame();
    m_slicing.forget();
    if (whose == Whose::picture)
        return m_executor.replace(look, programs);
    auto done = m_variant ? m_variant->replace(look, programs) : Result<void>();
    if (!done)
        end_variant();
    return done;
}

void Renderer::specialize(Programs programs, std::set<std::string> moving) {
    drop_frame();
    m_executor.specialize(std::move(programs), std::move(moving));
}

Result<void> Renderer::resize(Extent picture, Extent source) {
    m_picture = picture;
    m_source = source;
    const Plan before = m_executor.plan();
    if (auto done = m_executor.resize(picture, source); !done)
        return done;
    if (m_executor.plan() != before) {
        m_holds_picture = false;
        m_slicing.forget();
    }
    if (!m_variant)
        return {};
    auto done = m_variant->resize(picture, source);
    if (!done)
        end_variant();
    return done;
}

Result<void> Renderer::set_source(const Picture& picture, double pixel_aspect,
                                  const std::optional<SourceRaster>& raster) {
    m_pixel_aspect = pixel_aspect;
    m_source_raster = raster;
    return for_each([&](Executor& executor) { return executor.set_source(picture); });
}

Result<void> Renderer::set_image(const std::string& name, const Picture& picture) {
    return for_each([&](Executor& executor) { return executor.set_image(name, picture); });
}

void Renderer::set_image(const std::string& name,
                         const std::shared_ptr<const gpu::Texture>& texture) {
    if (!m_is_variant_alone)
        m_executor.set_image(name, texture);
    if (m_variant)
        m_variant->set_image(name, texture);
}

Result<void> Renderer::set_image(Whose whose, const std::string& name, const Picture& picture) {
    if (whose == Whose::picture)
        return m_executor.set_image(name, picture);
    auto done = m_variant ? m_variant->set_image(name, picture) : Result<void>();
    if (!done)
        end_variant();
    return done;
}

Result<void> Renderer::set_runs(const std::vector<PassRun>& runs) {
    if (runs == m_runs)
        return {};
    m_runs = runs;
    if (auto done = m_executor.set_runs(runs); !done || !m_variant)
        return done;
    auto done = m_variant->set_runs(runs);
    if (!done)
        end_variant();
    return done;
}

Result<void> Renderer::set_displayed(const std::vector<bool>& seen, Executor::Frames frames) {
    const Plan before = m_executor.plan();
    if (auto done = m_executor.set_displayed(seen, frames); !done)
        return done;
    auto done = m_variant ? m_variant->set_displayed(seen, frames) : Result<void>();
    if (!done)
        end_variant();
    if (m_executor.plan() != before) {
        drop_frame();
        m_holds_picture = false;
    }
    return done;
}

void Renderer::clear_history(int pass) {
    drop_frame();
    m_executor.clear_history(pass);
    if (m_variant)
        m_variant->clear_history(pass);
}

void Renderer::restart_samples() {
    m_executor.restart_samples();
    if (m_variant)
        m_variant->restart_samples();
}

void Renderer::clear_history() {
    drop_frame();
    m_holds_picture = m_holds_picture && m_is_variant_alone;
    if (!m_is_variant_alone)
        m_executor.clear_history();
    if (m_variant)
        m_variant->clear_history();
}

Result<void> Renderer::start_variant(const Values& values) {
    m_variant = std::make_unique<Executor>(m_executor.look(), m_executor.programs());
    m_is_variant_alone = true;
    set_variant_values(values);
    if (auto switched = m_variant->set_runs(m_runs); !switched) {
        end_variant();
        return switched;
    }
    if (auto looked_at = m_variant->set_displayed(m_executor.seen()); !looked_at) {
        end_variant();
        return looked_at;
    }
    auto sized = m_picture.is_empty() ? Result<void>() : m_variant->resize(m_picture, m_source);
    if (!sized)
        end_variant();
    return sized;
}

void Renderer::set_variant_values(const Values& values) {
    m_variant_values = values;
    if (m_variant)
        m_variant->set_values(values);
}

void Renderer::end_variant() {
    if (m_is_variant_alone)
        cancel_replay();
    m_variant.reset();
    m_executor.invalidate_uniforms();
}

void Renderer::replay_variant(const Player& player, std::size_t frames) {
    m_is_variant_alone = m_variant != nullptr;
    begin_replay(player, m_variant ? frames : 0);
}

Frame Renderer::frame_of(const PlayedFrame& played, const Beam& beam) const {
    Frame frame;
    frame.time = played.span.end;
    frame.time_delta = played.span.seconds();
    frame.number = played.number;
    frame.mouse = m_hand.place();
    frame.press = m_hand.press();
    frame.keys = m_hand.keys();
    frame.pixel_aspect = m_pixel_aspect;
    frame.source_raster = m_source_raster;
    frame.patience_seconds = m_variant ? m_patience_seconds / 2.0 : m_patience_seconds;
    frame.beam = beam;
    frame.beam_fit = m_beam_fit;
    frame.tints = beam.tints;
    frame.sound = m_sound.get();
    frame.date = m_date.value_or(date_after(date_of_renders, frame.time));
    return frame;
}

// Keeps the samples of an unfinished frame.
void Renderer::note_mouse() {
    m_owes_mouse = is_amid_frame();
    if (m_owes_mouse)
        return;
    m_executor.note_mouse_moved();
    if (m_variant)
        m_variant->note_mouse_moved();
}

void Renderer::set_mouse(double x, double y) {
    const std::array<double, 2> place{x, y};
    if (place != m_hand.place())
        note_mouse();
    m_hand.move(place);
}

void Renderer::set_mouse_button(bool is_down) {
    if (is_down != m_hand.press().is_down)
        note_mouse();
    m_hand.set_button(is_down);
}

void Renderer::set_key(std::size_t key, bool is_down) {
    m_hand.set_key(key, is_down);
}

void Renderer::draw_frame(const PlayedFrame& played, const Beam& beam,
                          const std::vector<bool>* passes) {
    const Frame frame = frame_of(played, beam);
    move_values(frame.time);
    if (m_variant && !m_is_variant_alone)
        m_executor.invalidate_uniforms();
    if (!m_is_variant_alone)
        m_executor.draw(frame, passes);
    m_hand.note_drawn();
    if (!m_variant)
        return;
    m_variant->invalidate_uniforms();
    m_variant->draw(frame, passes);
}

bool Renderer::has_whole_picture() const {
    const bool is_one_ahead = m_variant && m_variant->is_amid_frame() != m_executor.is_amid_frame();
    return m_holds_picture && !is_one_ahead && (!m_unfinished || m_unfinished->is_beside);
}

void Renderer::draw(const PlayedFrame& played, const Beam& beam) {
    const auto start = std::chrono::steady_clock::now();
    drop_frame();
    m_owes_frame = false;
    if (m_slicing.is_due())
        return begin_slices(frame_of(played, beam), nullptr,
                            {.is_whole = true, .played = played, .points = beam.size()});
    draw_frame(played, beam, nullptr);
    const double took = seconds_since(start);
    note_whole(played, beam.size(), took);
    m_slicing.note(std::max(took, reported_seconds()));
}

// The GPU time, some frames old; 0 without timers.
double Renderer::reported_seconds() const {
    double milliseconds = 0.0;
    for (const double pass : m_pass_milliseconds)
        milliseconds += pass;
    return (m_variant ? 2.0 : 1.0) * milliseconds / 1000.0;
}

void Renderer::note_whole(const PlayedFrame& played, std::size_t points, double seconds) {
    m_has_drawn = m_holds_picture = true;
    m_point_count = points;
    m_pass_milliseconds = m_executor.pass_milliseconds();
    m_pass_times.add(m_pass_milliseconds);
    note_beam_cost(played);
    constexpr double smoothing = 0.1;
    m_frame_seconds += smoothing * (seconds - m_frame_seconds);
}

// Draws the first slice immediately.
void Renderer::begin_slices(const Frame& frame, const std::vector<bool>* passes,
                            Unfinished unfinished) {
    move_values(frame.time);
    unfinished.is_beside =
        m_holds_picture && m_slicing.is_heavy() && m_executor.can_double_buffer();
    for (Executor* executor : {&m_executor, m_variant.get()}) {
        const bool is_left_out =
            executor == &m_executor && m_is_variant_alone && !unfinished.is_again;
        if (!executor || is_left_out)
            continue;
        if (unfinished.is_again)
            executor->begin_redraw(frame, *passes, unfinished.is_beside);
        else
            executor->begin_draw(frame, passes, unfinished.is_beside);
    }
    if (!unfinished.is_again)
        m_hand.note_drawn();
    m_unfinished = unfinished;
    continue_frame();
}

bool Renderer::continue_frame(double seconds) {
    const auto begun = std::chrono::steady_clock::now();
    bool was_dropped = true;
    bool is_whole = true;
    for (Executor* executor : {&m_executor, m_variant.get()}) {
        if (!executor || !executor->is_amid_frame())
            continue;
        was_dropped = false;
        executor->invalidate_uniforms();
        is_whole = executor->continue_frame(seconds - seconds_since(begun)) && is_whole;
    }
    if (was_dropped) {
        m_owes_frame = m_owes_frame || m_unfinished;
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
    if (m_slicing.is_due())
        return;
    m_executor.end_slices();
    if (m_variant)
        m_variant->end_slices();
}

void Renderer::end_unfinished() {
    m_unfinished.reset();
    if (std::exchange(m_owes_mouse, false))
        note_mouse();
}

void Renderer::drop_frame() {
    m_owes_frame = m_owes_frame || m_unfinished;
    end_unfinished();
    m_executor.drop_frame();
    if (m_variant)
        m_variant->drop_frame();
}

void Renderer::note_beam_cost(const PlayedFrame& played) {
    const std::vector<Pass>& passes = m_executor.look().passes;
    double milliseconds = 0.0;
    for (std::size_t i = 0; i < std::min(passes.size(), m_pass_milliseconds.size()); ++i)
        if (is_of_beam(passes[i].draw))
            milliseconds += m_pass_milliseconds[i];
    if (m_variant)
        milliseconds *= 2.0;
    const double cost = milliseconds / 1000.0 / std::max(played.span.seconds(), 1e-6);
    constexpr double smoothing = 0.2;  // the driver's times are some frames old
    m_beam_cost = m_beam_cost == 0.0 ? cost : m_beam_cost + smoothing * (cost - m_beam_cost);
}

void Renderer::draw_unseen(const PlayedFrame& played, const Beam& beam) {
    const std::vector<bool> carried = carried_passes(m_executor.look());
    drop_frame();
    if (m_slicing.is_due())
        begin_slices(frame_of(played, beam), &carried, {});
    else
        draw_frame(played, beam, &carried);
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
    if (player.past().empty())
        return;
    const PlayedFrame& present = player.past().back();
    const Beam beam = draws_beam(m_executor.look(), passes) ? player.trace(present.span) : Beam();
    const Frame frame = frame_of(present, beam);
    drop_frame();
    if (m_slicing.is_due())
        return begin_slices(frame, &passes, {.is_again = true});
    move_values(frame.time);
    if (m_variant)
        m_executor.invalidate_uniforms();
    m_executor.redraw(frame, passes);
    m_has_drawn = m_holds_picture = true;
    if (!m_variant)
        return;
    m_variant->invalidate_uniforms();
    m_variant->redraw(frame, passes);
}

void Renderer::start_replay(const Player& player, std::size_t frames) {
    m_is_variant_alone = false;
    begin_replay(player, frames);
}

void Renderer::begin_replay(const Player& player, std::size_t frames) {
    drop_frame();
    m_owes_frame = false;
    const std::size_t there = player.past().size();
    m_replay = {0, std::min(frames, there)};
    m_replay_first = there - m_replay.total;
    if (m_replay.is_running())
        clear_history();
    else
        m_is_variant_alone = false;
}

void Renderer::cancel_replay() {
    if (m_replay.is_running())
        drop_frame();
    m_replay = {};
    m_is_variant_alone = false;
}

bool Renderer::continue_replay(const Player& player, double seconds, const BeforeFrame& before) {
    const auto start = std::chrono::steady_clock::now();
    while (m_replay.is_running() && seconds_since(start) < seconds) {
        const PlayedFrame& frame = player.past()[m_replay_first + m_replay.done];
        const bool is_last = m_replay.done + 1 == m_replay.total;
        if (is_amid_frame()) {
            continue_frame(seconds - seconds_since(start));
        } else {
            before(frame);
            if (is_last)
                draw(frame, player.trace(frame.span));
            else
                draw_unseen(frame, player.trace(frame.span));
        }
        if (is_amid_frame())
            return false;
        if (std::exchange(m_owes_frame, false))
            continue;  // it was dropped: repeats it
        ++m_replay.done;
        m_is_variant_alone = m_is_variant_alone && !is_last;
        if (is_last)
            return true;
    }
    return false;
}
