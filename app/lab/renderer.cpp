#include "lab/renderer.h"

#include "base/elapsed.h"

#include <algorithm>
#include <chrono>

// A variant that cannot follow ends; the picture itself goes on.
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
    m_values = values;
    m_drawn_values = values;
    m_executor.set_values(values);
}

// Those of the frame that is to be drawn; sizes follow no value that moves.
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

Result<void> Renderer::replace(const Look& look, const Programs& programs) {
    if (m_is_variant_alone)
        cancel_replay();
    return for_each([&](Executor& executor) { return executor.replace(look, programs); });
}

Result<void> Renderer::resize(Extent picture, Extent source) {
    m_picture = picture;
    m_source = source;
    if (auto done = m_executor.resize(picture, source); !done || !m_variant)
        return done;
    auto done = m_variant->resize(picture, source);
    if (!done)
        end_variant();
    return done;
}

Result<void> Renderer::set_source(const Picture& picture, double pixel_aspect) {
    m_pixel_aspect = pixel_aspect;
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

void Renderer::clear_history(int pass) {
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
    m_executor.claim_programs();
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
    frame.patience_seconds = m_variant ? m_patience_seconds / 2.0 : m_patience_seconds;
    frame.beam = beam;
    frame.tints = beam.tints;
    frame.sound = m_sound.get();
    frame.date = m_date.value_or(date_after(date_of_renders, frame.time));
    return frame;
}

void Renderer::note_mouse() {
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
        m_executor.claim_programs();
    if (!m_is_variant_alone)
        m_executor.draw(frame, passes);
    m_hand.note_drawn();
    if (!m_variant)
        return;
    m_variant->claim_programs();
    m_variant->draw(frame, passes);
}

void Renderer::draw(const PlayedFrame& played, const Beam& beam) {
    const auto start = std::chrono::steady_clock::now();
    draw_frame(played, beam, nullptr);
    m_has_drawn = true;
    m_point_count = beam.size();
    m_pass_milliseconds = m_executor.pass_milliseconds();
    m_pass_times.add(m_pass_milliseconds);
    note_beam_cost(played);
    constexpr double smoothing = 0.1;
    m_frame_seconds += smoothing * (seconds_since(start) - m_frame_seconds);
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
    constexpr double smoothing = 0.2;  // the driver's times are of some frames ago
    m_beam_cost = m_beam_cost == 0.0 ? cost : m_beam_cost + smoothing * (cost - m_beam_cost);
}

void Renderer::draw_unseen(const PlayedFrame& played, const Beam& beam) {
    const std::vector<bool> carried = carried_passes(m_executor.look());
    draw_frame(played, beam, &carried);
}

void Renderer::redraw(const Player& player, const std::vector<bool>& passes) {
    if (player.past().empty())
        return;
    const PlayedFrame& present = player.past().back();
    const Beam beam = player.trace(present.span);
    const Frame frame = frame_of(present, beam);
    move_values(frame.time);
    if (m_variant)
        m_executor.claim_programs();
    m_executor.redraw(frame, passes);
    if (!m_variant)
        return;
    m_variant->claim_programs();
    m_variant->redraw(frame, passes);
}

void Renderer::start_replay(const Player& player, std::size_t frames) {
    m_is_variant_alone = false;
    begin_replay(player, frames);
}

void Renderer::begin_replay(const Player& player, std::size_t frames) {
    const std::size_t there = player.past().size();
    m_replay = {0, std::min(frames, there)};
    m_replay_first = there - m_replay.total;
    if (m_replay.is_running())
        clear_history();
    else
        m_is_variant_alone = false;
}

void Renderer::cancel_replay() {
    m_replay = {};
    m_is_variant_alone = false;
}

bool Renderer::continue_replay(const Player& player, double seconds, const BeforeFrame& before) {
    const auto start = std::chrono::steady_clock::now();
    while (m_replay.is_running() && seconds_since(start) < seconds) {
        const PlayedFrame& frame = player.past()[m_replay_first + m_replay.done];
        ++m_replay.done;
        before(frame);
        if (m_replay.is_running()) {
            draw_unseen(frame, player.trace(frame.span));
            continue;
        }
        draw(frame, player.trace(frame.span));
        m_is_variant_alone = false;
        return true;
    }
    return false;
}
