#include "lab/sequencer/cue_control.h"

#include "base/file.h"
#include "io/files/atomic_file.h"
#include "lab/library/cue_plans.h"

#include <fmt/format.h>

#include <utility>

namespace fs = std::filesystem;

CueText CueControl::current() const {
    return m_work.document ? m_work.document->state().cues : CueText{};
}

bool CueControl::is_open() const {
    return !current().is_empty();
}

bool CueControl::has_changes() const {
    return is_open() && current() != m_saved;
}

void CueControl::change(CueText next, const char* step) {
    if (!m_work.document || next == current())
        return;
    DocumentState state = m_work.document->state();
    state.cues = std::move(next);
    m_work.document->change(std::move(state), step);
    update();
}

void CueControl::change(const CueSheet& next, const char* step) {
    change({current().file, next.text()}, step);
}

void CueControl::open(const fs::path& file) {
    const auto text = read_text(file);
    if (!m_work.messages.succeeded(text))
        return;
    if (const auto sheet = parse_cue_sheet(*text, file); !m_work.messages.succeeded(sheet))
        return;
    if (!m_work.document)
        return m_work.messages.say("Open a look first. Cues change its parameters.", true);
    m_saved = {fs::absolute(file).string(), *text};
    m_is_playing = true;
    change(m_saved, "Open cues");
    m_work.messages.say(fmt::format("Opened cues \"{}\"", file.filename().string()));
}

void CueControl::close() {
    change(CueText{}, "Close cues");
}

void CueControl::save() {
    write(current().file);
}

void CueControl::save_as(const fs::path& given) {
    const fs::path file = given.has_extension() ? given : fs::path(given.string() + ".txt");
    write(fs::absolute(file));
}

void CueControl::write(const fs::path& file) {
    if (!m_work.document || file.empty())
        return;
    const std::string text = current().text;
    if (!m_work.messages.succeeded(write_atomically(file, text)))
        return;
    m_saved = {file.string(), text};
    m_work.document->amend([&](DocumentState& state) { state.cues = m_saved; });
    m_work.messages.say(fmt::format("Saved cues \"{}\"", file.filename().string()));
}

void CueControl::file_changed(const fs::path& file) {
    if (!is_open() || file != fs::path(current().file))
        return;
    const auto text = read_text(file);
    if (!text || *text == m_saved.text)
        return;
    const bool has_edits = has_changes();
    m_saved.text = *text;
    if (has_edits)
        return m_work.messages.say(
            fmt::format("\"{}\" changed on disk. Your unsaved cues were kept.",
                        file.filename().string()),
            true);
    change(m_saved, "Cues changed on disk");
}

void CueControl::add(const Cue& cue) {
    CueSheet next = m_sheet.value_or(CueSheet{});
    if (!m_problems.empty() && !m_sheet)
        return m_work.messages.say("Correct the errors in the cue file first.", true);
    next.add(cue);
    change(next, "Add cue");
}

namespace {
const Cue* cue_at(const std::optional<CueSheet>& sheet, std::size_t line) {
    if (!sheet || line == 0 || line > sheet->lines().size())
        return nullptr;
    const auto& cue = sheet->lines()[line - 1].cue;
    return cue ? &*cue : nullptr;
}
}  // namespace

void CueControl::move(std::size_t line, double seconds) {
    const Cue* cue = cue_at(m_sheet, line);
    if (!cue)
        return;
    Cue moved = *cue;
    moved.seconds = std::max(seconds, 0.0);
    CueSheet next = *m_sheet;
    next.change(line, moved);
    change(next, "Move cue");
}

void CueControl::retype(std::size_t line, const std::string& text) {
    if (!cue_at(m_sheet, line))
        return;
    const auto cue = parse_cue(text);
    if (!m_work.messages.succeeded(cue))
        return;
    CueSheet next = *m_sheet;
    next.change(line, *cue);
    change(next, "Edit cue");
}

void CueControl::remove(std::size_t line) {
    if (!cue_at(m_sheet, line))
        return;
    CueSheet next = *m_sheet;
    next.remove(line);
    change(next, "Delete cue");
}

void CueControl::set_playing(bool is_playing) {
    if (m_is_playing == is_playing)
        return;
    m_is_playing = is_playing;
    m_look.clear();  // reads again
}

void CueControl::update() {
    if (!m_work.document || m_work.document->has_pending_stack())
        return;
    const CueText text = current();
    const std::string look = text.is_empty() ? "" : look_digest(m_work.document->look());
    if (text == m_read && look == m_look)
        return;
    m_read = text;
    m_look = look;
    read();
}

void CueControl::read() {
    const fs::path file = m_read.file.empty() ? fs::path("cues") : fs::path(m_read.file);
    const bool had_cues = m_work.cues != nullptr;
    m_work.cues.reset();
    m_sheet.reset();
    m_problems.clear();
    if (!m_read.is_empty()) {
        auto sheet = parse_cue_sheet(m_read.text, file);
        auto plan = sheet ? plan_cues(*sheet, file, m_work.document->look(), m_work.library)
                          : Result<CuePlan>(fail(sheet.error()));
        if (sheet)
            m_sheet = std::move(*sheet);
        if (!plan)
            m_problems = plan.error();
        else if (m_is_playing && !plan->is_empty())
            m_work.cues = std::make_shared<const CuePlan>(std::move(*plan));
    }
    if (had_cues || m_work.cues)
        m_frames.reapply();  // values without cues, or with other ones
}
