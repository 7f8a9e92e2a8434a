#include "lab/lab.h"

#include "base/file.h"
#include "base/printable.h"
#include "formats/look/manifest_edit.h"
#include "formats/preset/preset_format.h"
#include "formats/preset/share_line.h"
#include "formats/scene/scene_file.h"
#include "gpu/objects/readback.h"
#include "lab/document/morphing.h"
#include "lab/document/sharing.h"
#include "lab/document/users_content.h"
#include "lab/media/source.h"
#include "lab/messages/source_lines.h"
#include "lab/offline/small_picture.h"
#include "lab/session.h"
#include "lab/storage/editor.h"
#include "lab/storage/include_store.h"
#include "lab/storage/sound_store.h"
#include "lab/storage/told_name.h"
#include "lab/trials/tryouts.h"
#include "lab/window/window_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fcntl.h>
#include <unistd.h>

namespace fs = std::filesystem;

Lab::Lab(Library library, const gpu::Context& screen, std::unique_ptr<gpu::Context> worker,
         std::unique_ptr<MidiInputs> midi)
    : m_library(std::move(library)),
      m_includes(load_include_folders(m_library.roots())),
      m_kept_sessions(m_library.roots()),
      m_audio(m_player, m_library.roots(), m_messages),
      m_remote(m_document, m_library.roots(), m_messages, std::move(midi)),
      m_drive(RecentMedia(m_library.roots())),
      m_tryouts(std::make_unique<Tryouts>()),
      m_loader(std::move(worker), screen, m_library.roots(), m_messages) {
    search_includes();
}

Lab::~Lab() = default;

void Lab::open(const std::string& argument) {
    const auto request = resolve(argument, m_library);
    if (m_messages.succeeded(request))
        open(*request);
}

void Lab::open_with_content(const std::string& argument) {
    auto request = resolve(argument, m_library);
    if (!m_messages.succeeded(request))
        return;
    request->brings_content = true;
    open(*request);
}

void Lab::open(const OpenRequest& request) {
    m_when_opened = {};
    m_preset_step.reset();
    m_opening_file.clear();
    m_loader.worker().builder().set_picture(m_size.extent());
    m_loader.set_displayed(m_seen);
    m_loader.open(request);
}

void Lab::dismiss_problems() {
    m_messages.dismiss_problems();
    m_loader.dismiss_failed();
}

void Lab::cancel_opening() {
    const bool is_restacking = m_document && m_document->is_restacking();
    if (!m_loader.is_reading() || is_restacking)  // undo takes a stack's change back
        return;
    const std::string name = m_loader.cancel();
    m_constants.clear();
    m_when_opened = {};
    m_preset_step.reset();
    m_messages.say(fmt::format("Cancelled opening \"{}\"", name));
}

namespace {
// The present setting with another file; other kinds of signal leave nothing to a sound.
Spec playing(const fs::path& file, const Spec& present) {
    const Spec fresh =
        is_scene_file(file) ? Spec{"scene", {}} : Spec{"audio", {{"mode", std::string("xy")}}};
    Spec spec = present.kind == fresh.kind ? present : fresh;
    spec.settings.erase("");
    spec.settings["file"] = fs::absolute(file).string();
    return with_round_circles(std::move(spec));
}
}  // namespace

bool Lab::opens_document(const fs::path& file) const {
    const bool is_source = is_source_file(file) && !(is_picture_file(file) && load_preset(file));
    return !is_sound_file(file) && !is_svg_file(file) && !is_scene_file(file) && !is_source;
}

std::optional<Picture> Lab::small_copy() const {
    constexpr int lines = 135;
    if (!m_renderer || !m_renderer->has_drawn())
        return std::nullopt;
    auto viewer = Viewer::make();
    if (!viewer)
        return std::nullopt;
    const auto canvas = small_picture(*viewer, m_renderer->executor(), lines);
    if (!canvas)
        return std::nullopt;
    Picture picture = gpu::read_picture(canvas->texture());
    picture.encoding = Encoding::display;
    return picture;
}

void Lab::keep_unsaved(const Session& session,
                       const std::function<std::optional<Picture>()>& picture) {
    const auto kept = m_kept_sessions.keep(session, picture);
    if (m_messages.succeeded(kept) && *kept)
        m_messages.say("Your unsaved changes are kept in File > Unsaved changes");
}

void Lab::take_up(const fs::path& kept) {
    const auto session = KeptSessions::read(kept);
    if (!m_messages.succeeded(session))
        return;
    // What another look takes the place of is kept when it opens.
    if (m_document && m_document->look().manifest == session->look)
        keep_unsaved(session_of(*this, {}), [this] { return small_copy(); });
    restore(*this, *session, [kept](Lab& opened) { opened.m_kept_sessions.forget(kept); });
}

std::string Lab::look_for(const fs::path& file) const {
    const bool is_beam = is_sound_file(file) || is_svg_file(file) || is_scene_file(file);
    const Driver needed = is_beam ? Driver::signal : Driver::picture;
    if (m_document && m_document->look().driven_by == needed)
        return "";
    return is_beam ? "phosphor" : "crt";
}

void Lab::open_file(const fs::path& file) {
    if (opens_document(file)) {
        const auto request = resolve(file.string(), m_library);
        if (!m_messages.succeeded(request))
            return;
        open(*request);
        m_opening_file = file;
        return;
    }
    if (is_svg_file(file))
        return m_drawing.load(file);
    const bool is_sound = is_sound_file(file) || is_scene_file(file);
    const Driver needed = is_sound ? Driver::signal : Driver::picture;
    if (m_document && is_picture_file(file) && is_reference_wanted())
        return compare_with_file(file);
    if (!m_document || m_document->look().driven_by != needed) {
        return m_messages.say(is_sound ? needs_signal_look : needs_picture_look, true);
    }
    if (is_sound)
        return m_drive.choose({.driver = Driver::signal,
                               .signal = playing(file, m_document->state().signal),
                               .file = file});
    SourceSpec source = parse_source(m_document->state().source).value_or(SourceSpec{});
    const bool is_first =
        !is_users_content(m_document->state().source) && source.fit == Fit::stretch;
    source.picture = fs::absolute(file).string();
    const std::string text = to_string(source);
    m_drive.choose({.driver = Driver::picture,
                    .source = is_first ? with_users_defaults(text, m_document->look()) : text,
                    .file = file});
}

// A file that cannot be read changes nothing.
void Lab::take_chosen_content() {
    const auto taken = m_drive.take_chosen(m_document->look(), m_player);
    if (!taken || !m_messages.succeeded(*taken))
        return;
    const ChosenContent& chosen = **taken;
    m_opened_files.add(chosen.file);
    const bool is_signal = chosen.driver == Driver::signal;
    if (m_document->look().driven_by != chosen.driver) {
        Content content = m_document->content();  // for the next look that it drives
        (is_signal ? content.locks.signal : content.locks.source) = true;
        is_signal ? void(content.signal = chosen.signal) : void(content.source = chosen.source);
        return m_document->keep_content(content);
    }
    for (const Diagnostic& note : m_drive.problems())
        m_messages.say(note);
    if (!is_signal)
        return m_document->set_source(chosen.source);
    m_document->set_signal(chosen.signal);
    m_player.restart();
    m_player.play();
}

// What the preset names is one click away while the user's own is locked.
void Lab::offer_own_content(const Preset& preset) {
    const Look& look = m_document->look();
    const bool is_signal = look.driven_by == Driver::signal;
    const bool names_content = is_signal ? preset.signal.has_value() : !preset.source.empty();
    if (!m_document->is_content_locked() || !names_content)
        return;
    const Content own{preset.signal.value_or(Spec{}), preset.source, {}};
    const Content present = m_document->content();
    if (is_signal ? is_same_content(own.signal, present.signal)
                  : is_same_content(own.source, present.source))
        return;
    const std::string kept = fmt::format("Kept {}", content_name(present, look));
    m_messages.append(kept, {.name = use_content_words(look),
                             .deeds = {[own](Document& document) { document.use_content(own); }}});
}

void Lab::cancel_loading() {
    const std::string name = m_drive.loading();
    if (name.empty() || !m_document)
        return;
    m_drive.cancel();
    m_messages.say(fmt::format("Cancelled loading \"{}\"", fs::path(name).filename().string()));
}

Preset Lab::portable(const Preset& preset, const fs::path& folder) const {
    remember_files(*m_document, m_drive.recent());
    return with_portable_media(preset, folder, m_drive.recent());
}

void Lab::edit(const std::function<void(Document&)>& change) {
    if (m_document)
        change(*m_document);
}

void Lab::undo() {
    if (!m_presets.undo_removal())
        edit([](Document& document) { document.undo(); });
}

void Lab::restart() {
    m_trip.trip.reset();
    m_player.restart();
    if (m_renderer)
        m_renderer->clear_history();
    if (!m_player.is_playing())
        m_player.step();
}

void Lab::set_mouse(double x, double y) {
    if (m_renderer)
        m_renderer->set_mouse(x, y);
}

void Lab::set_mouse_button(bool is_down) {
    if (m_renderer)
        m_renderer->set_mouse_button(is_down);
}

void Lab::set_key(std::size_t key, bool is_down) {
    if (m_renderer)
        m_renderer->set_key(key, is_down);
}

void Lab::cancel_replay() {
    if (!m_renderer)
        return;
    m_renderer->cancel_replay();
    if (!m_renderer->has_drawn())  // with what there is of its past, rather than nothing
        want({std::vector<bool>(m_renderer->executor().look().passes.size(), true), false});
}

std::string Lab::share_line() const {
    return m_document ? share_line_of(*m_document, m_drive.recent()) : std::string();
}

void Lab::paste(const std::string& line) {
    const auto preset = parse_share_line(line);
    if (!m_messages.succeeded(preset))
        return;
    if (m_document && preset->look == m_document->look().id) {
        const CheckedPreset checked =
            with_checked_media(*preset, m_document->look(), fs::current_path(), m_drive.recent());
        m_document->take(checked.preset, "Paste");
        return offer_content(checked);
    }
    open(line);
}

void Lab::new_look(const std::string& id) {
    const auto folder = m_library.new_look(id);
    if (m_messages.succeeded(folder))
        open(OpenRequest{*folder, {}, {}});
}

void Lab::duplicate_look(const std::string& id) {
    if (!m_document)
        return;
    if (m_document->look().stack.size() > 1)
        return m_messages.say("A stack can't be duplicated. Open one of its looks first.", true);
    if (is_foreign_look(m_document->look().manifest))
        return m_messages.say("Looks of other programs can't be duplicated", true);
    const auto folder = m_library.duplicate_look(m_document->look().manifest.parent_path(), id);
    if (!m_messages.succeeded(folder))
        return;
    Preset present = m_document->preset();
    present.look = id;
    open(OpenRequest{*folder, present, {}});
}

void Lab::write_overrides() {
    if (!m_document || m_document->state().overrides.empty())
        return;
    const Stack& stack = m_document->look().stack;
    for (const StackPart& part : stack)
        if (m_library.is_shipped(manifest_of(part.place)))
            return offer_duplicate(
                fmt::format("\"{}\" is a shipped look and can't be changed", part.look));
    for (std::size_t i = 0; i < stack.size(); ++i) {
        PassOverrides own;
        const std::string scope = scope_of(stack, i);
        for (const auto& [pass, override] : m_document->state().overrides)
            if (pass.starts_with(scope))
                own.emplace(pass.substr(scope.size()), override);
        if (!own.empty() && is_foreign_look(stack[i].place))
            return m_messages.say("Pass settings can't be saved to looks of other programs", true);
        if (!own.empty() &&
            !m_messages.succeeded(::write_overrides(manifest_of(stack[i].place), own)))
            return;
    }
    m_document->clear_overrides();
    m_messages.say("Saved to look.json");
}

// A shipped file that the user may not write to.
bool Lab::must_duplicate(const fs::path& file) const {
    return m_library.is_shipped(file) && faccessat(AT_FDCWD, file.c_str(), W_OK, AT_EACCESS) != 0;
}

void Lab::offer_duplicate(const std::string& words) {
    const std::string id = m_document->look().id + "-copy";
    m_messages.offer(words, {.name = "Duplicate look",
                             .deeds = {[id](WindowState& window) {
                                 window.dialog = {.kind = Dialog::Kind::duplicate_look, .text = id};
                             }}});
}

void Lab::open_in_editor(const Location& place) {
    if (m_document && must_duplicate(place.file))
        return offer_duplicate(
            fmt::format("\"{}\" is a shipped look in a read-only folder", m_document->look().name));
    m_messages.succeeded(::open_in_editor(place));
}
