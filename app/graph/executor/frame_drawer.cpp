#include "graph/executor/frame_drawer.h"

#include "base/elapsed.h"
#include "gpu/context.h"
#include "gpu/debug_names.h"
#include "gpu/objects/draw.h"
#include "model/picture/beam_fit.h"

#include <algorithm>
#include <cassert>
#include <utility>

FrameDrawer::FrameDrawer(const FrameGraph& graph, Shapes& shapes, PassPrograms& programs,
                         FrameTextures& textures)
    : m_graph(graph),
      m_shapes(shapes),
      m_programs(programs),
      m_textures(textures),
      m_passes(graph, shapes, programs, textures),
      m_samples(graph),
      m_costs(programs.size()) {}

void FrameDrawer::draw(const Frame& frame, const std::vector<bool>* passes, Slices slices) {
    assert(m_graph.settings().redraws == Redraws::possible || slices != Slices::double_buffered);
    const gpu::ContextScope scope(m_programs.context().get());
    begin_frame(frame, passes, false);
    if (slices == Slices::none)
        end_slices();
    advance(slices == Slices::double_buffered);
    m_slices = slices;
    m_has_unfinished_frame = slices != Slices::none;
    if (m_has_unfinished_frame)
        return;
    draw_passes();
    m_programs.end_events();
}

void FrameDrawer::redraw(const Frame& frame, const std::vector<bool>& passes, Slices slices) {
    assert(m_graph.settings().redraws == Redraws::possible);
    const gpu::ContextScope scope(m_programs.context().get());
    begin_frame(frame, &passes, true);
    for (std::size_t i = 0; i < m_programs.size(); ++i)
        if (slices == Slices::double_buffered && may_be_unfinished(i))
            m_textures.targets()[i].begin(Target::Unfinished::again);
    m_slices = slices;
    m_has_unfinished_frame = slices != Slices::none;
    if (!m_has_unfinished_frame)
        draw_passes();
}

// Prepares the passes to draw, the beam, the keyboard and the sound.
void FrameDrawer::begin_frame(const Frame& frame, const std::vector<bool>* only, bool is_again) {
    const std::size_t count = m_programs.size();
    assert(m_textures.targets().size() == count);
    drop_frame();
    m_programs.refresh();
    m_work.passes.assign(count, only == nullptr);
    for (std::size_t i = 0; only && i < std::min(only->size(), count); ++i)
        m_work.passes[i] = (*only)[i];
    m_passes.set_frame(frame);
    if (!is_again)
        leave_out_of_subframe();
    draw_shared_whole();
    m_work.is_whole = only == nullptr;
    m_work.is_again = is_again;
    m_work.draw_calls = 0;
    m_samples.note_frame();
    if (!is_again)
        m_shapes.beam.advance(frame);
    write_beam(frame);
    m_textures.begin_frame(frame);
}

// A pass per source frame is drawn in the first sub-frame, or in a later one if it has no picture.
void FrameDrawer::leave_out_of_subframe() {
    for (std::size_t i = 0; i < m_work.passes.size(); ++i)
        if (!advances(i) && m_textures.targets()[i].is_drawn())
            m_work.passes[i] = false;
}

bool FrameDrawer::advances(std::size_t pass) const {
    return m_passes.frame().subframe.is_first() || !m_graph.look().passes[pass].per_source_frame;
}

// If no pass draws the beam, the previous vertices stay for views of earlier draws.
void FrameDrawer::write_beam(const Frame& frame) {
    const std::optional<BeamSpot> spot = smallest_spot();
    if (draws_points() || spot)
        m_shapes.beam.write(frame, draws_points(), spot,
                            beam_scale(m_graph.look(), m_graph.values(),
                                       m_graph.settings().viewport, frame.beam_fit));
}

// Passes that share a target are drawn together or not at all.
void FrameDrawer::draw_shared_whole() {
    bool is_any = false;
    for (std::size_t guest = 0; guest < m_work.passes.size(); ++guest)
        if (const std::size_t host = m_graph.host_of(guest); host != guest)
            m_work.passes[host] = m_work.passes[host] || m_work.passes[guest];
    for (std::size_t guest = 0; guest < m_work.passes.size(); ++guest)
        if (const std::size_t host = m_graph.host_of(guest); host != guest) {
            m_work.passes[guest] = m_work.passes[host];
            is_any = is_any || m_work.passes[guest];
        }
    m_separate.begin_frame(is_any, m_textures.number());
}

bool FrameDrawer::draws(std::size_t pass, Draw shape) const {
    return m_graph.look().passes[pass].draw == shape && m_work.passes[pass] &&
           !m_textures.is_kept(pass);
}

bool FrameDrawer::draws_points() const {
    for (std::size_t i = 0; i < m_work.passes.size(); ++i)
        if (draws(i, Draw::points))
            return true;
    return false;
}

std::optional<BeamSpot> FrameDrawer::smallest_spot() const {
    std::optional<BeamSpot> smallest;
    for (std::size_t i = 0; i < m_work.passes.size(); ++i) {
        if (!draws(i, Draw::segments))
            continue;
        const BeamSpot& spot = m_graph.spot_of(i);
        smallest = smallest ? BeamSpot{std::min(smallest->across, spot.across),
                                       std::min(smallest->up, spot.up)}
                            : spot;
    }
    return smallest;
}

// Advances the history by one frame.
void FrameDrawer::advance(bool is_unfinished) {
    TargetSet& targets = m_textures.targets();
    for (std::size_t i = 0; i < targets.size(); ++i) {
        if (!advances(i))
            continue;
        if (is_unfinished && may_be_unfinished(i))
            targets[i].begin(Target::Unfinished::next);
        else
            targets[i].advance();
        if (m_textures.is_kept(i))
            targets[i].keep();
    }
    if (m_passes.frame().subframe.is_first())
        m_textures.advance_source();
}

void FrameDrawer::draw_passes() {
    m_textures.note_changed();
    const gpu::DrawScope scope;
    for (const std::size_t pass : m_graph.order()) {
        if (m_work.passes[pass])
            draw_pass(pass);
        release_after(pass);
    }
    note_frame_drawn();
}

void FrameDrawer::note_frame_drawn() {
    if (m_observer)
        m_observer->frame_drawn(in_progress());
    m_textures.samplers().release();
    m_draw_calls = m_work.draw_calls;
}

FrameInProgress FrameDrawer::in_progress() const {
    return {m_graph, m_textures.targets(), m_work.passes, m_work.is_whole, m_passes.frame().number};
}

// No later pass of the frame reads these pictures.
void FrameDrawer::release_after(std::size_t pass) {
    const std::vector<PlannedTarget>& planned = m_graph.plan().targets;
    for (std::size_t i = 0; i < planned.size(); ++i)
        if (planned[i].common && planned[i].last_reader == pass)
            m_textures.targets()[i].release(m_work.passes[i]);
}

void FrameDrawer::draw_pass(std::size_t pass) {
    const gpu::DebugGroup group(m_graph.look().passes[pass].name);
    if (!begin_pass(pass))
        return;
    gpu::Timer& timer = *m_costs[pass].timer;
    if (m_work.draws > m_work.first_draw)
        timer.begin(m_work.draws - m_work.first_draw);
    for (int i = m_work.first_draw; i < m_work.draws; ++i) {
        start_draw(pass, i);
        m_passes.draw(pass, sample_of(pass, i));
        end_draw(pass);
    }
    timer.end();
    end_pass(pass);
}

// False if the program of the pass draws nothing.
bool FrameDrawer::begin_pass(std::size_t index) {
    if (m_textures.is_kept(index))
        return false;
    Target& target = m_textures.targets()[index];
    target.allocate_unfinished();
    target.note_drawn();
    if (m_graph.run_of(index) == PassRun::bypassed) {
        m_costs[index].timer->begin();
        m_passes.pass_through(index);
        m_costs[index].timer->end();
        target.canvas().texture().generate_mipmaps();
        return false;
    }
    const Pass& pass = m_graph.look().passes[index];
    if (pass.accumulate && m_work.is_again)
        return false;
    m_passes.use(index);
    m_work.first_draw = 0;
    if (pass.accumulate) {
        count_samples(index);
        return true;
    }
    // A pass that reads its own history advances with each repetition. When it is redrawn, only the
    // input of its last repetition still exists, so only that one is drawn.
    m_work.draws = m_graph.repeats_of(index);
    if (m_work.is_again && m_programs[index].reads_itself)
        m_work.first_draw = m_work.draws - 1;
    return true;
}

// The number of samples in this frame. Without any, the picture so far stays.
void FrameDrawer::count_samples(std::size_t pass) {
    const double each = m_costs[pass].timer->milliseconds_per_part().value_or(0.0) / 1000.0;
    m_work.draws = m_samples.begin_frame(pass, m_passes.frame().sample_budget_seconds, each);
    Target& target = m_textures.targets()[pass];
    if (m_work.draws == 0 && target.has_previous())
        target.canvas(1).copy_to(target.canvas());
}

void FrameDrawer::start_draw(std::size_t pass, int draw) {
    const bool is_first = draw == m_work.first_draw;
    const bool reads_itself = m_programs[pass].reads_itself;
    if (!is_first && reads_itself)
        m_textures.targets()[pass].advance();
    if (!is_first && !reads_itself)
        return;
    const bool accumulates = m_graph.look().passes[pass].accumulate;
    m_passes.start_target(pass, accumulates && m_samples.held(pass) > 0);
    m_passes.bind(pass);
}

int FrameDrawer::sample_of(std::size_t pass, int draw) const {
    return m_graph.look().passes[pass].accumulate ? m_samples.held(pass)
                                                  : m_samples.before(pass) + draw;
}

void FrameDrawer::end_draw(std::size_t pass) {
    ++m_work.draw_calls;
    if (m_graph.look().passes[pass].accumulate)
        m_samples.add(pass);
}

void FrameDrawer::end_pass(std::size_t pass) {
    if (m_graph.is_followed_onto(pass))
        return;
    const std::size_t host = m_graph.host_of(pass);
    if (m_observer)
        m_observer->pass_drawn(in_progress(), host);
    m_textures.targets()[host].canvas().texture().generate_mipmaps();
}

bool FrameDrawer::can_double_buffer() const {
    for (std::size_t i = 0; i < m_programs.size(); ++i)
        if (m_programs[i].reads_itself && m_graph.repeats_of(i) > 1)
            return false;
    return true;
}

bool FrameDrawer::may_be_unfinished(std::size_t pass) const {
    const bool takes_no_samples = m_graph.look().passes[pass].accumulate && m_work.is_again;
    return m_work.passes[pass] && !m_textures.is_kept(pass) && !takes_no_samples;
}

bool FrameDrawer::continue_frame(double seconds) {
    if (!m_has_unfinished_frame)
        return true;
    const auto begun = std::chrono::steady_clock::now();
    const gpu::ContextScope context(m_programs.context().get());
    m_programs.refresh();
    const std::size_t end = m_graph.order().size();
    {
        const gpu::DrawScope scope;
        double left = seconds;
        do {  // at least one band per slice
            continue_pass(left);
            left = seconds - seconds_since(begun);
        } while (m_work.pass < end && left > 0.0);
        m_textures.samplers().release();
    }
    if (m_work.pass < end)
        return false;
    finish_frame();
    return true;
}

void FrameDrawer::continue_pass(double seconds) {
    const std::size_t index = m_graph.order()[m_work.pass];
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
        m_costs[index].timer->set_elapsed(1000.0 * m_work.pass_seconds,
                                          m_work.draws - m_work.first_draw);
    end_pass(index);
    next_pass();
}

// Draws rows and waits for the GPU, because only then the time is known.
void FrameDrawer::draw_band(std::size_t index, double seconds) {
    RowPace& pace = m_costs[index].pace;
    const int height = m_graph.plan().targets[index].extent.height;
    // Beams are drawn in one band.
    const bool has_rows = !is_of_beam(m_graph.look().passes[index].draw);
    const int rows = has_rows ? pace.rows_for(seconds, height - m_work.row) : height;
    const auto begun = std::chrono::steady_clock::now();
    const gpu::DebugGroup group(m_graph.look().passes[index].name);
    m_passes.use(index);
    if (m_work.row == 0)
        start_draw(index, m_work.draw);
    gpu::limit_rows(m_work.row, m_work.row + rows);
    m_passes.bind(index);
    m_passes.draw(index, sample_of(index, m_work.draw));
    gpu::lift_limits();
    gpu::finish();
    const double took = seconds_since(begun);
    pace.note(rows, took);
    m_work.pass_seconds += took;
    m_work.row += rows;
    if (m_work.row < height)
        return;
    pace.end_draw();
    end_draw(index);
    m_work.row = 0;
    ++m_work.draw;
}

void FrameDrawer::finish_frame() {
    m_has_unfinished_frame = false;
    TargetSet& targets = m_textures.targets();
    for (std::size_t i = 0; i < targets.size(); ++i)
        targets[i].finish();
    {
        const gpu::DrawScope scope;
        note_frame_drawn();
    }
    if (!m_work.is_again)
        m_programs.end_events();
    m_textures.note_changed();
}

void FrameDrawer::drop_frame() {
    m_work = {.passes = std::move(m_work.passes)};
    if (!std::exchange(m_has_unfinished_frame, false))
        return;
    m_samples.drop_frame(m_slices != Slices::double_buffered);
    TargetSet& targets = m_textures.targets();
    for (std::size_t i = 0; i < targets.size(); ++i)
        targets[i].drop();
}

// Frees the memory for slices.
void FrameDrawer::end_slices() {
    if (m_slices == Slices::none)
        return;
    m_textures.clear_copies();  // of freed pictures
    TargetSet& targets = m_textures.targets();
    for (std::size_t i = 0; i < targets.size(); ++i)
        targets[i].release_unfinished();
}

void FrameDrawer::warm_up_pass(const Frame& frame, std::size_t pass) {
    const gpu::ContextScope context(m_programs.context().get());
    std::vector<bool> only(m_programs.size(), false);
    only[pass] = true;
    begin_frame(frame, &only, false);
    {
        const gpu::DrawScope scope;
        if (begin_pass(pass)) {
            if (m_work.draws > m_work.first_draw)
                draw_band(pass, 0.0);
            end_pass(pass);
            if (m_observer)
                m_observer->frame_drawn(in_progress());
        }
        m_textures.samplers().release();
    }
    drop_frame();
    m_costs[pass].pace = {};  // a band of 0 seconds is not representative
}

void FrameDrawer::restart_samples() {
    if (m_has_unfinished_frame && samples())
        drop_frame();
    m_samples.restart();
}

void FrameDrawer::restart_samples(const std::vector<bool>& changed_passes) {
    const bool takes_samples = m_has_unfinished_frame && samples();
    if (m_samples.restart(changed_passes) && takes_samples) {
        drop_frame();
        m_samples.restart(changed_passes);
    }
}

bool FrameDrawer::has_converged() const {
    if (m_graph.look().driven_by == Driver::signal ||
        m_textures.targets().size() != m_programs.size() || !samples())
        return false;
    for (std::size_t i = 0; i < m_programs.size(); ++i)
        if (!is_static(i))
            return false;
    return true;
}

// Whether it would draw the same picture again while its inputs of this frame do not change.
bool FrameDrawer::is_static(std::size_t index) const {
    const Pass& pass = m_graph.look().passes[index];
    if (m_textures.is_kept(index))
        return true;
    if (m_graph.run_of(index) == PassRun::bypassed)
        return passed_input(pass)->frames_ago == 0;
    if (pass.accumulate)
        return m_samples.has_converged(index);
    const bool reads_what_moves = std::ranges::any_of(pass.inputs, [](const Input& input) {
        return input.frames_ago > 0 || input.from == Input::From::sound ||
               input.from == Input::From::keyboard;
    });
    return !reads_what_moves && !m_programs[index].built_ins.uses_time();
}

void FrameDrawer::set_observer(std::shared_ptr<FrameObserver> observer) {
    const gpu::ContextScope context(m_programs.context().get());
    m_observer = std::move(observer);
}

void FrameDrawer::reset_passes(const std::vector<bool>& changed_passes) {
    m_costs.resize(changed_passes.size());
    for (std::size_t i = 0; i < changed_passes.size(); ++i)
        if (changed_passes[i])
            m_costs[i] = {};
    m_separate.clear();
    m_samples.restart();
    if (m_observer)
        m_observer->look_replaced();
}

void FrameDrawer::targets_replaced() {
    m_separate.clear();
    for (PassCost& cost : m_costs)
        cost.pace = {};
    restart_samples();
}

const gpu::Texture& FrameDrawer::picture(std::size_t pass) const {
    const PlannedTarget& planned = m_graph.plan().targets[pass];
    if (planned.onto) {
        const gpu::ContextScope context(m_programs.context().get());
        const auto separate = m_separate.take(pass, planned, m_textures.number());
        if (separate.is_stale)
            m_passes.draw_separately(pass, *separate.canvas, m_samples.before(pass));
        if (separate.canvas)
            return separate.canvas->texture();
    }
    return m_textures.targets()[pass].finished().texture();
}

PassReport FrameDrawer::report(std::size_t pass) const {
    const int samples = m_graph.look().passes[pass].accumulate
                            ? std::max(m_samples.held(pass) - 1, 0)
                            : m_samples.before(pass) + m_graph.repeats_of(pass) - 1;
    return m_passes.report(pass, samples);
}

std::vector<double> FrameDrawer::pass_milliseconds() {
    const gpu::ContextScope context(m_programs.context().get());
    std::vector<double> times;
    for (std::size_t i = 0; i < m_costs.size(); ++i) {
        const double time = m_costs[i].timer->milliseconds().value_or(0.0);
        times.push_back(i < m_textures.targets().size() && m_textures.is_kept(i) ? 0.0 : time);
    }
    return times;
}
