// The part of Lab that draws the picture: its source, its size, the next frame or the past again.
#include "base/elapsed.h"
#include "lab/lab.h"
#include "lab/rendering/frame_limit.h"
#include "lab/storage/local_date.h"

#include <algorithm>
#include <utility>

void Lab::update_drive() {
    const Diagnostics problems = m_drive.take_problems();
    for (const Diagnostic& problem : problems)
        m_messages.say(problem);
    if (!problems.empty())
        gather_problems();
    if (m_drive.is_source_late())
        show_source(m_player.time());
    const auto taken = m_drive.update(*m_document, m_player, *m_renderer);
    if (!taken)
        return;
    m_messages.succeeded(*taken);
    gather_problems();
    m_renderer->restart_samples();
    m_drawn_extent = {};  // sizes may depend on the source
    want({{}, true});
}

// A paused picture is owed what it reads.
void Lab::show_source(double seconds) {
    const auto is_new = m_drive.show_source(seconds, *m_renderer);
    if (m_messages.succeeded(is_new) && *is_new && !m_player.is_playing())
        want({{}, true});
}

void Lab::want(const Redraw& redraw) {
    if (!m_wanted) {
        m_wanted = redraw;
        return;
    }
    m_wanted->needs_replay = m_wanted->needs_replay || redraw.needs_replay;
    for (std::size_t i = 0; i < redraw.passes.size() && i < m_wanted->passes.size(); ++i)
        m_wanted->passes[i] = m_wanted->passes[i] || redraw.passes[i];
}

void Lab::resize_picture() {
    const Extent extent = m_size.extent();
    if (extent == m_drawn_extent)
        return;
    m_drawn_extent = extent;
    m_loader.worker().builder().set_picture(extent);
    m_drive.set_viewport(extent);
    show_source(m_player.time());
    const Plan before = m_renderer->executor().plan();
    const Extent source = m_drive.source_extent();
    if (m_messages.succeeded(m_renderer->resize(extent, source.is_empty() ? extent : source)) &&
        m_renderer->executor().plan() != before)
        want({{}, true});
}

// While a machine is slow, time is shown more slowly and not in ever longer frames.
void Lab::limit_frame(double wall_seconds) {
    if (m_player.past().empty())
        return;
    const double span = m_player.past().back().span.seconds();
    m_player.set_longest_frame(
        longest_frame({.wall_seconds = wall_seconds,
                       .beam_seconds = m_renderer->beam_seconds_a_second() * span,
                       .span_seconds = span}));
}

// Its first frames would show nothing, at sizes that are not its own.
bool Lab::awaits_source() const {
    return m_document && m_document->look().driven_by == Driver::picture && !m_drive.source() &&
           !m_drive.loading().empty();
}

void Lab::draw_picture(double wall_seconds) {
    if (awaits_source())
        return;
    const bool is_first = m_renderer->executor().plan().targets.empty();
    resize_picture();
    if (is_first && seconds_since(m_turn_begun) > slice_seconds)
        return;  // making room has taken this turn
    set_guard();
    limit_frame(wall_seconds);
    m_renderer->set_loudness(m_player.loudness());
    m_renderer->set_sound(m_player.sound_texels());
    m_renderer->set_date(local_date());
    const bool rests = m_player.is_playing() && has_converged();
    const bool comes_next = m_player.is_playing() && !rests;  // a frame, with all that is wanted
    const bool waits = rests || m_renderer->is_replaying_variant();
    const auto frame = waits ? std::nullopt : m_player.advance(wall_seconds);
    if (frame) {
        m_wanted.reset();
        m_renderer->cancel_replay();
        m_messages.succeeded(m_drive.show_source(frame->span.end, *m_renderer));
        m_renderer->draw(*frame, m_player.trace(frame->span));
        return;
    }
    // Enough of each turn for a picture that follows the hand, and the window stays awake.
    constexpr double seconds_a_turn = 0.012;
    if (m_renderer->replay().is_running())
        m_renderer->continue_replay(m_player, seconds_a_turn, [this](const PlayedFrame& past) {
            m_messages.succeeded(m_drive.show_past_source(past.span.end, *m_renderer));
        });
    else if (m_wanted && m_wanted->needs_replay && !comes_next)
        start_replay();
    else if (m_wanted && !comes_next)
        m_renderer->redraw(m_player, std::exchange(m_wanted, std::nullopt)->passes);
}

// While a knob is being turned only as much of the past is shown again as the hand can wait for.
void Lab::start_replay() {
    constexpr double patience_seconds = 0.2;
    constexpr std::size_t fewest = 4;
    const auto all = static_cast<std::size_t>(std::max(m_document->look().settle_frames, 1));
    std::size_t frames = all;
    if (m_document->history().is_in_gesture())
        frames =
            std::clamp(static_cast<std::size_t>(patience_seconds / m_renderer->frame_seconds()),
                       std::min(fewest, all), all);
    m_renderer->start_replay(m_player, frames);
    if (frames == all || m_renderer->replay().total < frames)
        m_wanted.reset();  // else the rest is owed until the hand lets go
}
