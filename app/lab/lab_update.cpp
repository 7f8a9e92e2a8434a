// The part of Lab that runs every turn: reloads in, time on, picture drawn.
#include "base/elapsed.h"
#include "base/printable.h"
#include "formats/preset/modulation_format.h"
#include "formats/preset/preset_format.h"
#include "lab/document/morphing.h"
#include "lab/document/sharing.h"
#include "lab/document/users_content.h"
#include "lab/lab.h"
#include "lab/messages/source_lines.h"
#include "lab/session.h"
#include "lab/trials/tryouts.h"
#include "model/look/value_changes.h"
#include "signals/signal_table.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace fs = std::filesystem;

void Lab::update(double wall_seconds) {
    m_messages.update(wall_seconds);
    for (const fs::path& file : m_loader.take_changed_files())
        extra_file_changed(file);
    m_turn_begun = std::chrono::steady_clock::now();
    if (auto built = m_loader.update({.picture = m_size.extent(), .is_amid_frame = is_amid_frame()},
                                     wall_seconds))
        apply(std::move(*built));
    const double arriving_seconds = seconds_since(m_turn_begun);
    m_remote.update(wall_seconds);
    m_size.update(wall_seconds);
    const bool was_comparing = m_jobs.rates().is_running();
    m_jobs.update();
    if (const auto& compared = m_jobs.rates().outcome(); was_comparing && compared && *compared)
        show_rate_pair((*compared)->worst_place());
    const bool is_quiet =
        !m_loader.is_loading() && !is_amid_frame() && (!m_renderer || m_renderer->has_drawn());
    m_loader.note_update(is_quiet);
    if (!m_document || !m_renderer)
        return;
    go_on_morphing(wall_seconds);
    if (m_document->is_restacking())
        // The last picture goes on meanwhile.
        m_loader.restack(m_document->state().stack, m_document->state().values);
    m_constants.update(*m_document);
    follow_seen();
    // Beside a look that is being opened others are at work on the same processor and driver.
    m_renderer->set_slice(m_loader.is_reading() ? slice_seconds / 2.0 : slice_seconds);
    m_is_turn_spent = m_loader.is_loading() && !m_is_turn_spent &&
                      arriving_seconds > slice_seconds && m_player.is_playing();
    if (m_is_turn_spent)
        m_amid_seconds += wall_seconds;  // the picture's turn is the next one
    else if (is_amid_frame())
        go_on_drawing(wall_seconds);
    else
        begin_drawing(wall_seconds);
    specialize(wall_seconds);
    m_automation.update(m_player.time());
    m_audio.update();
    follow_heavy_pass();
}

bool Lab::is_amid_frame() const {
    return m_renderer && m_renderer->is_amid_frame() && !m_renderer->replay().is_running();
}

// What else the person changed is for the frames to come.
void Lab::go_on_drawing(double wall_seconds) {
    if (m_player.is_playing())
        m_amid_seconds += wall_seconds;
    for (const Parameter& parameter : m_document->look().parameters)
        if (parameter.control == Control::event && m_applied &&
            m_document->value(parameter).number() != 0.0 &&
            value_of(parameter, m_applied->values).number() == 0.0)
            m_missed_events[parameter.name] = Value(1.0);
    m_renderer->continue_frame();
    if (!is_amid_frame())
        try_out();
}

// A click that began and ended while a frame was drawn.
void Lab::hand_on_missed_events() {
    Values missed = std::exchange(m_missed_events, {});
    if (missed.empty() || !m_applied)
        return;
    for (const auto& [name, value] : m_applied->values)
        missed.emplace(name, value);
    m_applied->values = std::move(missed);  // the next frame's are the document's again
    m_renderer->set_values(m_applied->values);
}

void Lab::begin_drawing(double wall_seconds) {
    wall_seconds += std::exchange(m_amid_seconds, 0.0);
    take_chosen_images();
    if (!m_document->is_restacking()) {
        take_chosen_content();
        apply_document();
    }
    hand_on_missed_events();
    if (m_renderer->owes_frame() && !m_player.is_playing())
        want({{}, true});
    follow_variant(wall_seconds);
    update_drive();
    draw_picture(wall_seconds);
    follow_trip();
    if (!is_amid_frame())
        try_out();
}

bool Lab::is_moving() const {
    return (m_player.is_playing() && !has_converged()) || m_loader.is_loading() || m_wanted ||
           (m_messages.notice() && m_messages.notice()->goes_by) || m_tryouts->is_busy() ||
           m_morphing || m_remote.is_busy() || m_chosen_images.is_reading() ||
           m_jobs.is_running() || !m_drive.loading().empty() || m_drive.is_source_late() ||
           (m_renderer && (m_renderer->is_amid_frame() || m_renderer->replay().is_running() ||
                           m_renderer->awaits_trip()));
}

bool Lab::has_converged() const {
    const bool is_source_moving = m_drive.source() && m_drive.source()->moves();
    const bool moves = is_source_moving || (m_applied && !m_applied->modulations.empty());
    return m_renderer && !moves && m_renderer->has_converged();
}

// Those of the look, then those of the files that a person chose.
void Lab::gather_problems() {
    Diagnostics problems = m_drive.problems();
    const auto add = [&problems](const Diagnostics& more) {
        problems.insert(problems.end(), more.begin(), more.end());
    };
    add(m_chosen_images.problems());
    if (m_document && m_document->look().driven_by == Driver::signal)
        add(notes_about(m_document->state().signal));
    m_messages.set_content_problems(problems);
}

namespace {
// Whether a picture that was uploaded for the one serves the other.
bool reads_images_alike(const Look& one, const Look& other) {
    return one.images == other.images && one.source_encoding == other.source_encoding &&
           one.source_rows == other.source_rows && one.source_format == other.source_format &&
           std::ranges::equal(one.passes, other.passes, {}, &Pass::inputs, &Pass::inputs);
}
}  // namespace

Specialization::Drawn Lab::drawn() const {
    return {*m_document, *m_applied, m_images, m_size.extent()};
}

// Nothing changes values, and nothing else needs the worker thread or the GPU.
void Lab::specialize(double wall_seconds) {
    if (!m_applied)
        return m_specialization.stop();
    const bool is_quiet = m_player.is_playing() && !m_loader.is_loading() && !m_morphing &&
                          !m_tryouts->is_busy() && !m_document->history().is_in_gesture();
    m_specialization.update(drawn(), *m_renderer, is_quiet, wall_seconds);
}

void Lab::apply(BuiltLook built) {
    if (built.kind != JobKind::look)
        return apply_constants(std::move(built));
    m_constants.clear();
    forget_heavy_pass();
    m_has_told_heavy_pass = false;
    if (m_document && !reads_images_alike(m_document->look(), *built.look)) {
        m_images.clear();
        m_chosen_images.forget();
        m_variant_images.forget();
    }
    forget_trip();
    m_loader.programs().set(std::move(*built.programs));
    m_specialization.stop();
    m_tryouts->stop();  // they draw with the previous programs
    if (built.is_reload && m_document && m_renderer)
        apply_edit(built);
    else
        open_document(built);
    set_pass_switches(m_switches);
    show_images(built.images);
    m_applied.reset();
    if (!m_opening_file.empty())
        m_opened_files.add(std::exchange(m_opening_file, {}));
    if (m_when_opened)
        std::exchange(m_when_opened, {})(*this);
}

// Specialised programs serve while the values are those that the picture was specialised for.
void Lab::apply_edit(BuiltLook& built) {
    const bool is_specialized = m_renderer->executor().is_settled() && !m_renderer->variant() &&
                                m_applied && m_applied->values == m_document->values();
    m_document->replace_look(std::move(*built.look));
    m_messages.succeeded(
        m_renderer->replace(m_document->drawn_look(), m_loader.programs().generic()));
    if (built.specialized && is_specialized)
        m_specialization.draw(std::move(*built.specialized), drawn(), *m_renderer);
}

void Lab::open_document(BuiltLook& built) {
    Look& look = *built.look;
    const OpenRequest& request = built.request;
    const bool is_same = m_document && m_document->look().manifest == look.manifest;
    const bool had_changes = m_document && m_document->is_modified();
    const bool loses_changes = had_changes && m_document->has_unlocked_changes();
    const Content content = m_document ? m_document->content() : m_content;
    const std::optional<Session> left =
        !is_same && had_changes ? std::optional(session_of(*this, {})) : std::nullopt;
    std::optional<Picture> left_picture = left ? small_copy() : std::nullopt;
    if (!is_same) {
        m_parameters.store();
        m_switches = {};
    }
    if (is_same)
        m_document->replace_look(std::move(look));
    else
        m_document.emplace(std::move(look));
    m_document->keep_content(content);
    remember_files(*m_document, m_drive.recent());
    begin_renderer(std::move(built.executor));
    constexpr double patience_seconds = 0.05;
    m_renderer->set_patience(patience_seconds);
    m_variant.reset();
    m_tryouts->stop();
    m_morphing.reset();
    if (!is_same)
        m_comparing.end();
    m_drawn_extent = {};
    m_images.clear();
    m_chosen_images.forget();
    m_drive.forget();
    m_player.restart();
    m_player.play();
    open_values(request);
    if (!is_same)
        m_parameters.load();
    watch_extra_files();
    if (!is_same && (!request.preset || !request.preset_file.empty()))
        m_document->forget_past();
    tell_preset(is_same && loses_changes && !m_when_opened);
    if (left)
        keep_unsaved(*left, [&] { return left_picture; });
    if (request.preset)
        offer_content(with_checked_media(*request.preset, m_document->look(),
                                         media_folder(request.preset_file), m_drive.recent()));
}

// The first draws' targets go on where nothing was overridden.
void Lab::begin_renderer(std::unique_ptr<Executor> drawn_first) {
    if (drawn_first && drawn_first->look() == m_document->drawn_look())
        m_renderer = std::make_unique<Renderer>(std::move(*drawn_first));
    else
        m_renderer =
            std::make_unique<Renderer>(m_document->drawn_look(), m_loader.programs().generic());
}

void Lab::open_values(const OpenRequest& request) {
    const auto content = request.brings_content ? Document::OpenedWith::own_content
                                                : Document::OpenedWith::locked_content;
    if (!request.preset) {
        m_document->open_defaults(content);
        return;
    }
    const fs::path folder = media_folder(request.preset_file);
    CheckedPreset checked =
        with_checked_media(*request.preset, m_document->look(), folder, m_drive.recent());
    Preset preset = std::move(checked.preset);
    const auto warn = [this](Diagnostics& problems) {
        for (Diagnostic& problem : problems)
            problem.severity = Severity::warning;
        m_messages.add_look_problems(problems);
    };
    // Items of lists by their labels, for one; what does not fit comes as near as it can.
    if (auto fitted = fitted_values(m_document->look(), preset, request.preset_file))
        preset.values = std::move(*fitted);
    else
        warn(fitted.error());
    if (auto fitted = fitted_modulations(m_document->look(), preset, request.preset_file))
        preset.modulations = std::move(*fitted);
    else
        warn(fitted.error());
    if (request.preset_file.empty()) {  // a line of text: kept nowhere yet
        m_document->set_identity(preset, {});
        m_document->take(preset, "Open preset");
    } else {
        m_document->open_preset(preset, request.preset_file, content);
    }
    m_messages.add_look_problems(
        compare_with_look(*request.preset, m_document->look(), request.preset_file));
    gather_problems();
}

void Lab::show_images(const ImageTextures& images) {
    for (const auto& [name, texture] : images)
        if (const auto shown = m_images.find(name);
            shown == m_images.end() || shown->second != texture)
            m_renderer->set_image(name, texture);
    m_images = images;
}

// Tells player and renderer what the person changed since last told.
namespace {
// Without constants of the texts, which are told when they are compiled.
std::vector<std::string> turned_uniforms(const Look& look, const Values& before,
                                         const Values& now) {
    std::vector<std::string> names = changed_parameters(look, before, now);
    std::erase_if(names,
                  [&](const std::string& name) { return find_parameter(look, name)->is_constant; });
    return names;
}

// As a copy, but for the many values of which mostly one has changed.
void follow(std::optional<DocumentState>& applied, const DocumentState& state) {
    if (!applied)
        applied = state;
    // Names every member, so that a new one cannot be forgotten.
    const auto& [values, signal, source, overrides, origin, stack, modulations, locks] = state;
    follow_values(applied->values, values);
    applied->signal = signal;
    applied->source = source;
    applied->overrides = overrides;
    applied->origin = origin;
    applied->stack = stack;
    applied->modulations = modulations;
    applied->locks = locks;
    assert(*applied == state);
}
}  // namespace

void Lab::apply_document() {
    const DocumentState& state = m_document->state();
    m_drawing.follow();
    Spec shown = m_drawing.board().shown(state.signal);
    if (m_applied == state && m_applied_signal == shown)
        return;
    const bool is_first = !m_applied;
    const std::vector<std::string> names =
        is_first ? parameter_names(m_document->look())
                 : turned_uniforms(m_document->look(), m_applied->values, state.values);
    m_renderer->set_values(state.values);
    m_renderer->set_modulations(state.modulations);
    const auto watched = m_chosen_images.files();
    m_messages.succeeded(m_chosen_images.show(m_document->look(), state.values, *m_renderer,
                                              Renderer::Whose::picture,
                                              ChosenImages::Reading::beside));
    show_variant_images();
    if (m_chosen_images.files() != watched)
        watch_extra_files();
    m_drawn_extent = {};  // sizes may depend on values
    Redraw redraw = redraw_after(m_document->look(), names);
    if (is_first || m_applied_signal != shown || m_applied->source != state.source) {
        m_applied_signal = std::move(shown);
        m_messages.succeeded(follow_signal());
        watch_extra_files();
        m_renderer->restart_samples();
        redraw.needs_replay = true;
    }
    if (!is_first && m_applied->modulations != state.modulations)
        redraw.needs_replay = true;
    if (!is_first && m_applied->overrides != state.overrides) {
        m_specialization.stop();
        m_messages.succeeded(
            m_renderer->replace(m_document->drawn_look(), m_loader.programs().generic()));
        redraw.needs_replay = true;
    }
    follow(m_applied, state);
    gather_problems();
    reconsider_trip(redraw);
    want(redraw);
}

Result<void> Lab::follow_signal() {
    m_renderer->set_beam_fit(beam_fit_of(m_document->state().signal));
    auto followed = m_drive.follow(*m_document, m_player, *m_renderer);
    if (!followed || !m_drawing.board().has_pen())
        return followed;
    return m_player.set_signal(m_applied_signal);
}

void Lab::show_rate_pair(std::size_t pair) {
    if (const auto& outcome = m_jobs.rates().outcome(); outcome && *outcome)
        m_messages.succeeded(m_rate_pictures.show(**outcome, pair));
}
