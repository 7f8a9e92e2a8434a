#include "lab/commands/content_commands.h"

#include "formats/preset/preset_format.h"
#include "formats/scene/scene_file.h"
#include "io/capture/screen_cast.h"
#include "lab/document/content_edits.h"
#include "lab/document/parameter_edits.h"
#include "lab/document/users_content.h"
#include "lab/frame/content_problems.h"
#include "lab/media/source.h"

#include <fmt/format.h>

namespace fs = std::filesystem;

namespace {
// The current signal with another file. A signal of another kind is replaced.
Spec playing(const fs::path& file, const Spec& current) {
    const Spec fresh =
        is_scene_file(file) ? Spec{"scene", {}} : Spec{"audio", {{"mode", std::string("xy")}}};
    Spec spec = current.kind == fresh.kind ? current : fresh;
    spec.settings.erase("");
    spec.settings["file"] = fs::absolute(file).string();
    return with_round_circles(std::move(spec));
}

bool can_use(const Look& look, Driver driver) {
    return look.driven_by == driver || look.has_other_driver;
}
}  // namespace

bool ContentCommands::is_content(const fs::path& file) {
    const bool is_source = is_source_file(file) && !(is_picture_file(file) && load_preset(file));
    return is_sound_file(file) || is_svg_file(file) || is_scene_file(file) || is_source;
}

std::string ContentCommands::look_for(const fs::path& file) const {
    const bool is_beam = is_sound_file(file) || is_svg_file(file) || is_scene_file(file);
    // A picture does not turn a beam look into one for pictures.
    if (m_work.document && (is_beam ? can_use(m_work.document->look(), Driver::signal)
                                    : driver_of(*m_work.document) == Driver::picture))
        return "";
    return is_beam ? "phosphor" : "crt";
}

void ContentCommands::open(const fs::path& file) {
    if (is_svg_file(file))
        return m_drawing.load(file);
    const bool is_sound = is_sound_file(file) || is_scene_file(file);
    const Driver needed = is_sound ? Driver::signal : Driver::picture;
    if (m_work.document && is_picture_file(file) && m_comparison.is_file_wanted())
        return m_comparison.compare_with_file(file);
    if (!m_work.document || !can_use(m_work.document->look(), needed)) {
        return m_work.messages.say(is_sound ? needs_signal_look : needs_picture_look, true);
    }
    if (is_sound)
        return m_work.media.choose({.driver = Driver::signal,
                                    .signal = playing(file, m_work.document->state().signal),
                                    .file = file});
    SourceSpec source = parse_source(m_work.document->state().source).value_or(SourceSpec{});
    const bool is_first =
        !is_users_content(m_work.document->state().source) && source.fit == Fit::stretch;
    source.picture = fs::absolute(file).string();
    const std::string text = to_string(source);
    m_work.media.choose(
        {.driver = Driver::picture,
         .source = is_first ? with_users_defaults(text, m_work.document->look()) : text,
         .file = file});
}

void ContentCommands::show_live(const std::string& text) {
    if (!m_work.document || !can_use(m_work.document->look(), Driver::picture))
        return m_work.messages.say(needs_picture_look, true);
    const auto source = parse_source(text);
    const auto live = source ? parse_live(source->picture) : fail(source.error());
    if (!live)
        return static_cast<void>(m_work.messages.succeeded(live));
    allow_screen_cast_question();
    m_work.media.choose(
        {.driver = Driver::picture, .source = with_users_defaults(text, m_work.document->look())});
}

void ContentCommands::choose_picture(const std::string& parameter, const fs::path& file) {
    if (m_work.document)
        m_work.pictures.chosen().choose(m_work.document->look(), {parameter, file});
}

void ContentCommands::cancel_loading() {
    const std::string name = m_work.media.loading();
    if (name.empty() || !m_work.document)
        return;
    m_work.media.cancel();
    m_work.messages.say(
        fmt::format("Cancelled loading \"{}\"", fs::path(name).filename().string()));
}

void ContentCommands::update() {
    take_pictures();
    if (!m_work.document->has_pending_stack())
        take_content();
}

void ContentCommands::take_pictures() {
    if (const auto chosen = m_work.pictures.chosen().take_chosen();
        chosen && m_work.messages.succeeded(*chosen)) {
        m_work.document->set_value((*chosen)->parameter, Value::of_path((*chosen)->file.string()));
        m_work.opened_files.add((*chosen)->file);
        m_work.media.recent().remember((*chosen)->file, {});
    }
    Diagnostics problems;
    const auto names = m_work.pictures.chosen().take_read(
        m_work.document->look(), m_work.renderer->executors().picture(), problems);
    if (names.empty())
        return;
    if (!problems.empty())
        m_work.messages.say(problems.front());
    report_content_problems(m_work);
    m_work.redraw.add(redraw_after(m_work.document->look(), names));
}

void ContentCommands::take_content() {
    const auto taken = m_work.media.take_chosen(m_work.document->look(), m_work.player);
    if (!taken || !m_work.messages.succeeded(*taken))
        return;
    const ChosenContent& chosen = **taken;
    if (!chosen.file.empty())
        m_work.opened_files.add(chosen.file);
    const bool is_signal = chosen.driver == Driver::signal;
    if (!can_use(m_work.document->look(), chosen.driver)) {
        Content content = content_of(*m_work.document);  // stored for the next look that uses it
        (is_signal ? content.locks.signal : content.locks.source) = true;
        is_signal ? void(content.signal = chosen.signal) : void(content.source = chosen.source);
        return keep_content(*m_work.document, content);
    }
    for (const Diagnostic& note : m_work.media.problems())
        m_work.messages.say(note);
    if (!is_signal)
        return set_source(*m_work.document, chosen.source);
    set_signal(*m_work.document, chosen.signal);
    m_work.player.restart();
    m_work.player.play();
}

void ContentCommands::offer_outside(const OutsideContent& content) {
    const auto use = [this, content] {
        m_work.messages.dismiss();
        if (!m_work.document)
            return;
        if (content.source.empty() && content.signal)
            set_signal(*m_work.document, *content.signal);
        else if (!content.source.empty())
            set_source(*m_work.document, content.source);
        if (!content.files.empty())
            set_values(*m_work.document, content.files, "Use the preset's files");
        for (const auto& [name, value] : content.files)
            m_work.media.recent().remember(value.path, {});
    };
    m_work.messages.ask(
        content.notice(),
        {MenuEntry{.name = content.count() == 1 ? "Use it" : "Use them", .commands = {use}}});
}

// While the user's own content is locked, a button offers the preset's.
void ContentCommands::offer_own(const Preset& preset) {
    const Look& look = m_work.document->look();
    const Driver current_driver = driver_of(*m_work.document);
    const bool is_signal =
        look.has_other_driver ? preset.source.empty() : current_driver == Driver::signal;
    const Driver driver = is_signal ? Driver::signal : Driver::picture;
    const bool names_content = is_signal ? preset.signal.has_value() : !preset.source.empty();
    if (!is_content_locked(*m_work.document) || !names_content)
        return;
    const Content own{preset.signal.value_or(Spec{}), preset.source, {}};
    const Content current = content_of(*m_work.document);
    if (driver == current_driver && (is_signal ? is_same_content(own.signal, current.signal)
                                               : is_same_content(own.source, current.source)))
        return;
    const std::string text = fmt::format("Kept {}", content_name(current, current_driver));
    m_work.messages.append(
        text, {.name = use_content_label(driver),
               .commands = {[own](Document& document) { use_content(document, own); }}});
}

void ContentCommands::offer(const CheckedPreset& checked) {
    const bool is_locked = is_content_locked(*m_work.document);
    if (checked.outside && (!is_locked || !checked.outside->files.empty())) {
        OutsideContent asked = *checked.outside;
        if (is_locked)
            asked = {.files = std::move(asked.files)};
        return offer_outside(asked);
    }
    if (!is_locked)
        return;
    Preset whole = checked.preset;
    if (checked.outside) {
        whole.signal = checked.outside->signal;
        whole.source = checked.outside->source;
    }
    offer_own(whole);
}
