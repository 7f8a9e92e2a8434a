// The part of Executor that draws a frame in slices.
#include "base/elapsed.h"
#include "gpu/objects/draw.h"
#include "graph/executor/executor.h"

#include <algorithm>
#include <cassert>
#include <utility>

void Executor::begin_draw(const Frame& frame, const std::vector<bool>* passes, bool is_beside) {
    assert(m_frames == Frames::drawn_again || !is_beside);
    const gpu::ContextScope scope(m_home.get());
    note_frame(frame, passes, false);
    move_on(is_beside);
    m_is_amid_frame = true;
    m_is_beside = is_beside;
}

void Executor::begin_redraw(const Frame& frame, const std::vector<bool>& passes, bool is_beside) {
    assert(m_frames == Frames::drawn_again);
    const gpu::ContextScope scope(m_home.get());
    note_frame(frame, &passes, true);
    for (std::size_t i = 0; is_beside && i < m_targets.size(); ++i)
        if (may_be_unfinished(i))
            m_targets[i].begin(Target::Unfinished::again);
    m_is_amid_frame = true;
    m_is_beside = is_beside;
}

bool Executor::can_double_buffer() const {
    for (std::size_t i = 0; i < m_passes.size(); ++i)
        if (m_passes[i].reads_itself && repeats_of(m_look.passes[i]) > 1)
            return false;
    return true;
}

bool Executor::may_be_unfinished(std::size_t pass) const {
    const bool takes_no_samples = m_look.passes[pass].accumulate && m_work.is_again;
    return m_work.passes[pass] && !is_kept(pass) && !takes_no_samples;
}

bool Executor::continue_frame(double seconds) {
    if (!m_is_amid_frame)
        return true;
    const auto begun = std::chrono::steady_clock::now();
    const gpu::ContextScope home(m_home.get());
    {
        const gpu::DrawScope scope;
        double left = seconds;
        do {  // at least one band per slice
            continue_pass(left);
            left = seconds - seconds_since(begun);
        } while (m_work.pass < m_order.size() && left > 0.0);
        m_samplers.release();
    }
    if (m_work.pass < m_order.size())
        return false;
    finish_frame();
    return true;
}

void Executor::continue_pass(double seconds) {
    const std::size_t index = m_order[m_work.pass];
    const bool is_drawn = m_work.passes[index];
    if (is_drawn && !m_work.has_begun_pass)
        m_work.has_begun_pass = begin_pass(index);
    const auto next_pass = [&] {
        release_after(index);
        ++m_work.pass;
        m_work.draw = m_work.row = 0;
        m_work.has_begun_pass = false;
        m_work.pass_seconds = 0.0;
    };
    if (!m_work.has_begun_pass)
        return next_pass();
    m_work.draw = std::max(m_work.draw, m_work.first_draw);
    if (m_work.draw < m_work.draws)
        return draw_band(index, seconds);
    if (m_work.draws > m_work.first_draw)
        m_passes[index].timer->tell(1000.0 * m_work.pass_seconds, m_work.draws - m_work.first_draw);
    end_pass(index);
    next_pass();
}

// Draws rows and waits for the GPU, because only then the time is known.
void Executor::draw_band(std::size_t index, double seconds) {
    PassState& state = m_passes[index];
    const int height = m_plan.targets[index].extent.height;
    const bool has_rows = !is_of_beam(m_look.passes[index].draw);  // beams are drawn in one band
    const int rows = has_rows ? state.pace.rows_for(seconds, height - m_work.row) : height;
    const auto begun = std::chrono::steady_clock::now();
    state.program->use();
    write_built_ins(index);
    if (m_work.row == 0)
        start_draw(index, m_work.draw);
    gpu::limit_rows(m_work.row, m_work.row + rows);
    aim(index);
    write_sample(index, m_work.draw);
    draw_shape(index);
    gpu::lift_limits();
    gpu::finish();
    const double took = seconds_since(begun);
    state.pace.note(rows, took);
    m_work.pass_seconds += took;
    m_work.row += rows;
    if (m_work.row < height)
        return;
    state.pace.end_draw();
    end_draw(index);
    m_work.row = 0;
    ++m_work.draw;
}

void Executor::finish_frame() {
    m_is_amid_frame = false;
    for (std::size_t i = 0; i < m_targets.size(); ++i)
        m_targets[i].finish();
    {
        const gpu::DrawScope scope;
        check_frame();
        m_samplers.release();
    }
    m_draw_calls = m_work.draw_calls;
    if (!m_work.is_again)
        m_parameters.end_events();
    ++m_picture_number;
}

void Executor::drop_frame() {
    m_work = {.passes = std::move(m_work.passes)};
    if (!std::exchange(m_is_amid_frame, false))
        return;
    for (PassState& state : m_passes)  // the picture they were added to is lost or incomplete
        state.samples = m_is_beside ? state.whole_samples : 0;
    for (std::size_t i = 0; i < m_targets.size(); ++i)
        m_targets[i].drop();
}

void Executor::warm_up_pass(const Frame& frame, std::size_t pass) {
    const gpu::ContextScope home(m_home.get());
    std::vector<bool> only(m_passes.size(), false);
    only[pass] = true;
    note_frame(frame, &only, false);
    {
        const gpu::DrawScope scope;
        if (begin_pass(pass)) {
            if (m_work.draws > m_work.first_draw)
                draw_band(pass, 0.0);
            end_pass(pass);
            check_frame();
        }
        m_samplers.release();
    }
    drop_frame();
    m_passes[pass].pace = {};                           // a band of 0 seconds is not representative
    static_cast<void>(target(static_cast<int>(pass)));  // warms up the flipped copy
}

void Executor::end_slices() {
    const gpu::ContextScope scope(m_home.get());
    drop_frame();
    m_cubes = {};  // copies of freed pictures
    for (std::size_t i = 0; i < m_targets.size(); ++i)
        m_targets[i].forget_room();
}
