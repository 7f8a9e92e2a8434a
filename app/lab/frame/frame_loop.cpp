#include "lab/frame/frame_loop.h"

#include "base/elapsed.h"
#include "lab/document/users_content.h"
#include "lab/frame/applied_state.h"
#include "lab/frame/content_problems.h"
#include "lab/frame/replay_length.h"
#include "lab/frame/wanted_subframes.h"
#include "lab/rendering/frame_limit.h"
#include "lab/storage/local_date.h"

#include <algorithm>
#include <utility>

namespace {
// With the panels an update stays below 1/20 s.
constexpr double slice_seconds = 0.024;

// Whether uploaded pictures of one look can be used for the other.
bool reads_images_alike(const Look& one, const Look& other) {
    return one.images == other.images && one.source_encoding == other.source_encoding &&
           one.source_rows == other.source_rows && one.source_format == other.source_format &&
           std::ranges::equal(one.passes, other.passes, {}, &Pass::inputs, &Pass::inputs);
}
}  // namespace

FrameLoop::FrameLoop(Workspace& work, LookLoader& loader, const DrawingBoard& board)
    : m_work(work), m_loader(loader), m_board(board) {}

void FrameLoop::begin_look(BuiltLook& built) {
    m_constants.clear();
    m_heavy_pass.reset();
    m_loader.programs().set(std::move(*built.programs));
    m_specialization.stop();
    m_previews.stop();  // they draw with the previous programs
}

void FrameLoop::end_look(const BuiltLook& built) {
    m_passes.apply();
    m_work.pictures.show_look_images(built.images, m_work.renderer->executors());
    m_applied.reset();
}

void FrameLoop::open(BuiltLook& built, const Opening& opening) {
    begin_look(built);
    m_guard.open();
    const Look look = drawn_look();
    // The executor of the first draws is reused if no pass setting is overridden.
    if (built.executor && built.executor->look() == look)
        m_work.renderer = std::make_unique<Renderer>(std::move(*built.executor));
    else
        m_work.renderer = std::make_unique<Renderer>(Executor(look, m_loader.programs().generic()));
    constexpr double sample_budget_seconds = 0.05;
    m_work.renderer->executors().inputs().sample_budget_seconds = sample_budget_seconds;
    m_comparison.open(opening.is_same);
    if (!opening.is_same)
        m_passes.reset();
    m_drawn_extent = {};
    m_work.pictures.clear();
    m_work.media.forget();
    const double time = opening.keeps_time ? m_work.player.transport().time() : 0.0;
    m_work.player.restart();
    m_work.player.seek(time);
    m_work.player.play();
    end_look(built);
}

// Specialised programs are usable while the values are those that the picture was specialised for.
void FrameLoop::replace(BuiltLook& built) {
    if (!reads_images_alike(m_work.document->look(), *built.look))
        m_work.pictures.clear();
    const bool is_specialized = m_work.renderer->executor().programs().is_specialized() &&
                                !m_work.renderer->executors().variant() && m_applied &&
                                m_applied->values == m_work.document->values();
    begin_look(built);
    m_guard.reset();
    m_work.document->replace_look(std::move(*built.look));
    replace_drawn_look();
    if (built.specialized && is_specialized)
        m_specialization.draw(std::move(*built.specialized), drawn(), *m_work.renderer);
    end_look(built);
}

void FrameLoop::replace_constants(BuiltLook built) {
    if (!m_work.document || !m_work.renderer || m_work.document->has_pending_stack())
        return;
    if (built.kind == JobKind::variant_constants)
        return m_constants.set_variant({std::move(*built.look), std::move(*built.programs)});
    const Values before = m_work.document->look().constants;
    m_loader.programs().set(std::move(*built.programs));
    m_specialization.stop();
    m_previews.stop();  // they draw with the previous programs
    m_work.document->replace_look(std::move(*built.look));
    const Look& look = m_work.document->look();
    std::vector<std::string> changed;
    for (const auto& [name, value] : look.constants)
        if (const auto old = before.find(name); old == before.end() || old->second != value)
            changed.push_back(name);
    m_work.renderer->drop_frame();
    m_work.messages.succeeded(m_work.renderer->executors().picture().replace(
        drawn_look(), m_loader.programs().generic()));
    m_work.renderer->reset();
    m_passes.apply();
    m_work.pictures.show_look_images(built.images, m_work.renderer->executors());
    restart_samples();
    m_drawn_extent = {};  // other uniforms may be in use now
    const Redraw redraw = redraw_after(look, changed);
    m_guard.recheck(redraw);
    m_work.redraw.add(redraw);
}

Specialization::Drawn FrameLoop::drawn() const {
    return {*m_work.document, *m_applied, m_work.pictures.look_images(), m_work.size.extent()};
}

// Quiet: nothing changes values, and nothing else needs the worker thread or the GPU.
void FrameLoop::specialize(double wall_seconds) {
    if (!m_applied)
        return m_specialization.stop();
    const bool is_quiet = m_work.player.transport().is_playing() && !m_loader.is_loading() &&
                          !m_work.cues && !m_previews.is_busy() &&
                          !m_work.document->history().is_in_gesture();
    m_specialization.update(drawn(), *m_work.renderer, is_quiet, wall_seconds);
}

void FrameLoop::update(double wall_seconds, double loading_seconds) {
    m_slices.update_begun = std::chrono::steady_clock::now() -
                            std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                std::chrono::duration<double>(loading_seconds));
    if (m_work.document->has_pending_stack())  // the picture continues meanwhile
        m_loader.reload_stack(m_work.document->state().stack, m_work.document->state().values);
    m_constants.update(*m_work.document);
    update_displayed();
    // The worker thread needs the processor and the driver, too.
    m_work.renderer->set_slice(m_loader.is_reading() ? slice_seconds / 2.0 : slice_seconds);
    m_slices.was_loading = m_loader.is_loading() && !m_slices.was_loading &&
                           loading_seconds > slice_seconds &&
                           m_work.player.transport().is_playing();
    if (m_slices.was_loading)
        m_slices.unfinished_seconds += wall_seconds;  // the next update draws
    else if (has_unfinished_frame())
        continue_frame(wall_seconds);
    else
        begin_frame(wall_seconds);
    specialize(wall_seconds);
    m_heavy_pass.update();
}

// NaN detection and a variant need the own picture of each pass. A change of the plan drops the
// frame that is being drawn, with its light. Therefore the change waits until that frame is drawn.
void FrameLoop::update_displayed() {
    if (has_unfinished_frame())
        return;
    const Executor& executor = m_work.renderer->executor();
    const std::vector<bool> displayed = m_guard.found() || m_work.renderer->executors().variant()
                                            ? std::vector<bool>()
                                            : m_displayed.of(executor.look());
    if (displayed == executor.graph().settings().displayed)
        return;
    const Plan before = executor.plan();
    if (!m_work.messages.succeeded(m_work.renderer->executors().for_both(
            [&](Executor& one) { return one.set_displayed(displayed); })))
        m_displayed = {};
    if (executor.plan() == before)
        return;
    m_work.renderer->reset();
    m_specialization.stop();
    m_work.redraw.add_all(executor.look().passes.size());
}

bool FrameLoop::has_unfinished_frame() const {
    return m_work.renderer && m_work.renderer->has_unfinished_frame() &&
           !m_work.renderer->replay().is_running();
}

// Other changes apply to later frames.
void FrameLoop::continue_frame(double wall_seconds) {
    if (m_work.player.transport().is_playing())
        m_slices.unfinished_seconds += wall_seconds;
    for (const Parameter& parameter : m_work.document->look().parameters)
        if (parameter.control == Control::event && m_applied &&
            m_work.document->value(parameter).number() != 0.0 &&
            value_of(parameter, m_applied->values).number() == 0.0)
            m_slices.missed_events[parameter.name] = Value(1.0);
    m_work.renderer->continue_frame();
    if (!has_unfinished_frame())
        update_previews(wall_seconds);
}

// For clicks that began and ended while a frame was drawn.
void FrameLoop::apply_missed_events() {
    Values missed = std::exchange(m_slices.missed_events, {});
    if (missed.empty() || !m_applied)
        return;
    for (const auto& [name, value] : m_applied->values)
        missed.emplace(name, value);
    m_applied->values = std::move(missed);  // until the next frame
    m_work.renderer->executors().picture().set_values(m_applied->values);
}

void FrameLoop::begin_frame(double wall_seconds) {
    wall_seconds += std::exchange(m_slices.unfinished_seconds, 0.0);
    if (!m_work.document->has_pending_stack())
        apply_document();
    apply_missed_events();
    if (m_work.renderer->take_dropped_frame() && !m_work.player.transport().is_playing())
        m_work.redraw.add_replay();
    if (m_comparison.update(wall_seconds))
        m_drawn_extent = {};  // sizes may depend on values
    update_source();
    follow_hdr();
    show_whole_if_paused();
    draw_picture(wall_seconds);
    m_guard.update();
    if (!has_unfinished_frame())
        update_previews(wall_seconds);
}

bool FrameLoop::has_converged() const {
    const Source* source = m_work.media.source().get();
    const bool moves = (source && source->moves()) ||
                       (m_applied && !m_applied->modulations.empty()) || m_work.cues;
    return m_work.renderer && !moves && m_work.renderer->has_converged();
}

bool FrameLoop::is_moving() const {
    const Renderer* renderer = m_work.renderer.get();
    return (m_work.player.transport().is_playing() && !has_converged()) ||
           !m_work.redraw.is_empty() || m_previews.is_busy() || m_previews.effects().is_busy() ||
           m_work.pictures.chosen().is_reading() || !m_work.media.loading().empty() ||
           m_work.media.source().is_late() ||
           (renderer && (renderer->has_unfinished_frame() || renderer->replay().is_running() ||
                         m_guard.is_waiting()));
}

void FrameLoop::apply_document() {
    const DocumentState& state = m_work.document->state();
    Spec signal = m_board.shown(state.signal);
    if (m_applied == state && m_applied_signal == signal)
        return;
    const Redraw redraw = apply_changes(state, std::move(signal));
    copy_changes(m_applied, state);
    report_content_problems(m_work);
    m_guard.recheck(redraw);
    m_work.redraw.add(redraw);
}

// Returns the passes to redraw.
Redraw FrameLoop::apply_changes(const DocumentState& state, Spec signal) {
    const Look& look = m_work.document->look();
    Renderer& renderer = *m_work.renderer;
    const bool is_first = !m_applied;
    Redraw redraw =
        redraw_after(look, is_first ? parameter_names(look)
                                    : changed_uniforms(look, m_applied->values, state.values));
    renderer.executors().picture().set_values(state.values);
    m_work.messages.succeeded(
        m_work.pictures.show_chosen(look, state.values, renderer.executors()));
    m_comparison.show_pictures();
    m_drawn_extent = {};  // sizes may depend on values
    if (is_first || m_applied_signal != signal || m_applied->source != state.source) {
        m_applied_signal = std::move(signal);
        m_work.messages.succeeded(apply_signal());
        restart_samples();
        redraw.needs_replay = true;
    }
    if (!is_first && m_applied->tempo != state.tempo && uses_tempo(state.modulations))
        redraw.needs_replay = true;
    if (!is_first && m_applied->modulations != state.modulations) {
        redraw.needs_replay = true;
        if (Executor* variant = renderer.executors().variant())
            variant->set_values(*m_comparison.variant_values());
    }
    if (!is_first && m_applied->overrides != state.overrides) {
        m_specialization.stop();
        replace_drawn_look();
        redraw.needs_replay = true;
    }
    return redraw;
}

Result<void> FrameLoop::apply_signal() {
    m_work.renderer->executors().inputs().beam_fit = beam_fit_of(m_work.document->state().signal);
    auto followed =
        m_work.media.follow(*m_work.document, m_work.player, m_work.renderer->executors());
    if (!followed || !m_board.has_pen())
        return followed;
    return m_work.player.set_signal(m_applied_signal);
}

void FrameLoop::update_source() {
    Source* const source = m_work.media.source().get();
    if (const auto problems = m_work.media.take_problems()) {
        for (const Diagnostic& problem : *problems)
            m_work.messages.say(problem);
        report_content_problems(m_work);
    }
    if (source && m_work.player.transport().is_playing() && source->refresh())
        m_drawn_extent = {};  // a live source has another size
    if (m_work.media.source().is_late())
        show_source(m_work.player.transport().time());
    const auto taken =
        m_work.media.update(*m_work.document, m_work.player, m_work.renderer->executors());
    if (!taken)
        return;
    m_work.messages.succeeded(*taken);
    report_content_problems(m_work);
    restart_samples();
    m_drawn_extent = {};  // sizes may depend on the source
    m_work.redraw.add_replay();
}

// Redraws a paused picture with the new source.
void FrameLoop::show_source(double seconds) {
    const auto is_new = m_work.media.source().show(seconds, m_work.renderer->executors());
    if (m_work.messages.succeeded(is_new) && *is_new && !m_work.player.transport().is_playing())
        m_work.redraw.add_replay();
}

void FrameLoop::resize_picture() {
    const Extent extent = m_work.size.extent();
    if (extent == m_drawn_extent)
        return;
    m_drawn_extent = extent;
    m_loader.worker().builder().set_picture(extent);
    m_work.media.source().set_viewport(extent);
    show_source(m_work.player.transport().time());
    const Plan before = m_work.renderer->executor().plan();
    const Extent source = m_work.media.source().extent();
    const bool is_resized =
        m_work.messages.succeeded(m_work.renderer->executors().for_both([&](Executor& executor) {
            return executor.resize(extent, source.is_empty() ? extent : source);
        }));
    if (m_work.renderer->executor().plan() == before)
        return;
    m_work.renderer->reset();
    if (is_resized)
        m_work.redraw.add_replay();
}

Look FrameLoop::drawn_look() const {
    Look look = m_work.document->drawn_look();
    return m_work.renderer && m_work.renderer->executors().inputs().hdr
               ? with_kept_light(std::move(look))
               : look;
}

void FrameLoop::follow_hdr() {
    const auto before = std::exchange(m_work.renderer->executors().inputs().hdr, m_work.hdr);
    if (before == m_work.hdr)
        return;
    if (before.has_value() != m_work.hdr.has_value()) {
        m_specialization.stop();
        replace_drawn_look();
    }
    m_work.redraw.add_replay();
}

// A paused picture is a whole source frame.
void FrameLoop::show_whole_if_paused() {
    const bool is_paused = !m_work.player.transport().is_playing();
    if (std::exchange(m_work.renderer->executors().inputs().shows_whole, is_paused) != is_paused &&
        is_paused)
        m_work.redraw.add_all(m_work.renderer->executor().look().passes.size());
}

// On a slow machine the clock runs slower, so that frames do not get longer and longer.
void FrameLoop::limit_frame(double wall_seconds) {
    if (m_work.player.transport().past().empty())
        return;
    const double span = m_work.player.transport().past().back().span.seconds();
    m_work.player.set_longest_frame(
        longest_frame({.wall_seconds = wall_seconds,
                       .beam_seconds = m_work.renderer->times().beam_seconds_per_second() * span,
                       .span_seconds = span}));
}

// Without the source, the first frames would be empty and have wrong sizes.
bool FrameLoop::awaits_source() const {
    return m_work.document && m_work.document->look().driven_by == Driver::picture &&
           !m_work.media.source().get() && !m_work.media.loading().empty();
}

void FrameLoop::draw_picture(double wall_seconds) {
    if (awaits_source())
        return;
    const bool is_first = m_work.renderer->executor().plan().targets.empty();
    resize_picture();
    if (is_first && seconds_since(m_slices.update_begun) > slice_seconds)
        return;  // allocation has used the time of this update
    m_guard.prepare();
    limit_frame(wall_seconds);
    m_work.renderer->executors().inputs().sound = m_work.player.signal().sound_texels();
    m_work.renderer->executors().inputs().date = local_date();
    const bool is_static = m_work.player.transport().is_playing() && has_converged();
    const bool comes_next = m_work.player.transport().is_playing() &&
                            !is_static;  // a frame, which includes all redraws
    const bool waits = is_static || m_work.renderer->replay().is_of_variant();
    const auto frame =
        waits ? std::nullopt : m_work.player.advance(wall_seconds, wanted_subframes(m_work));
    if (frame) {
        m_work.redraw.clear();
        m_work.renderer->replay().cancel();
        if (frame->subframe.is_first())
            m_work.messages.succeeded(
                m_work.media.source().show(frame->span.end, m_work.renderer->executors()));
        set_values(*frame);
        m_work.renderer->draw(*frame, m_work.player.signal().trace(frame->span));
        return;
    }
    // Fast enough for a drag, and the window still responds.
    constexpr double replay_seconds = 0.012;
    if (m_work.renderer->replay().is_running())
        m_work.renderer->replay().update(
            m_work.player, replay_seconds, [this](const PlayedFrame& past) {
                Executors& executors = m_work.renderer->executors();
                if (past.subframe.is_first())
                    m_work.messages.succeeded(
                        m_work.media.source().show_past(past.span.end, executors));
                set_values(past);
            });
    else if (m_work.redraw.needs_replay() && !comes_next)
        start_replay();
    else if (!m_work.redraw.is_empty() && !comes_next)
        redraw();
}

void FrameLoop::redraw() {
    const Redraw redraw = m_work.redraw.take();
    if (!m_work.player.transport().past().empty())
        set_values(m_work.player.transport().past().back(), FrameDraw::again);
    m_work.renderer->redraw(m_work.player, redraw.passes);
}

void FrameLoop::set_values(const PlayedFrame& frame, FrameDraw draw) {
    if (m_applied)
        set_frame_values(m_work, frame, draw, *m_applied, m_comparison.variant_values());
}

void FrameLoop::replace_drawn_look() {
    Renderer& renderer = *m_work.renderer;
    if (renderer.replay().is_of_variant())
        renderer.replay().cancel();
    const Look look = drawn_look();
    m_work.messages.succeeded(renderer.executors().for_both(
        [&](Executor& executor) { return executor.replace(look, m_loader.programs().generic()); }));
    renderer.reset();
}

// The signal or source changed.
void FrameLoop::restart_samples() {
    static_cast<void>(m_work.renderer->executors().for_both([](Executor& executor) {
        executor.drawer().restart_samples();
        return Result<void>();
    }));
}

void FrameLoop::start_replay() {
    const ReplayLength length = replay_length(m_work);
    m_work.renderer->replay().start(m_work.player, length.frames);
    if (length.is_complete || m_work.renderer->replay().total() < length.frames)
        m_work.redraw.clear();  // otherwise the rest is replayed when the drag ends
}

void FrameLoop::restart() {
    m_guard.restart();
    m_work.player.restart();
    if (m_work.renderer)
        m_work.renderer->clear_history();
    if (!m_work.player.transport().is_playing())
        m_work.player.step();
}

void FrameLoop::cancel_replay() {
    if (!m_work.renderer)
        return;
    if (m_work.renderer->replay().total() > settling_frames(m_work))
        m_work.redraw.add_replay();  // of all frames; the latest ones are enough for a picture
    m_work.renderer->replay().cancel();
    if (!m_work.renderer->has_drawn())  // shows the current history instead of nothing
        m_work.redraw.add_all(m_work.renderer->executor().look().passes.size());
}

// Called after the picture is drawn.
void FrameLoop::update_previews(double wall_seconds) {
    if (m_work.document->has_pending_stack() || TextConstants::are_pending(*m_work.document) ||
        m_work.renderer->executor().plan().targets.empty() ||
        m_work.renderer->replay().is_running())
        return;
    constexpr double fast_frame_seconds = 0.004;
    const bool is_idle = !m_loader.is_loading() && !m_work.cues &&
                         !m_work.document->history().is_in_gesture() &&
                         (!m_work.player.transport().is_playing() ||
                          m_work.renderer->times().frame_seconds() < fast_frame_seconds);
    m_previews.update({*m_work.document, m_work.player, m_work.media, *m_work.renderer,
                       m_work.pictures.look_images(), m_work.size.extent()},
                      is_idle, wall_seconds);
}
