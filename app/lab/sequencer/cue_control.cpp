#include "lab/sequencer/cue_control.h"

#include "base/file.h"
#include "io/files/atomic_file.h"
#include "lab/document/opened_preset.h"
#include "lab/library/cue_plans.h"
#include "lab/library/named_preset.h"

#include <fmt/format.h>

#include <algorithm>
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
    set_playing(true);
    m_work.messages.say(fmt::format("Opened cues \"{}\"", file.filename().string()));
    change(m_saved, "Open cues");
    update();
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
    const std::string before = current().file;
    m_saved = {file.string(), text};
    // In all undo steps, so that saving after an undo writes the new file.
    m_work.document->amend(
        [&](DocumentState& state) {
            if (!state.cues.is_empty() && state.cues.file == before)
                state.cues.file = m_saved.file;
        },
        AmendedStates::all);
    m_work.messages.say(fmt::format("Saved cues \"{}\"", file.filename().string()));
}

std::vector<fs::path> CueControl::files() const {
    std::vector<fs::path> files = m_presets;
    if (const CueText text = current(); !text.file.empty())
        files.emplace_back(text.file);
    return files;
}

void CueControl::file_changed(const fs::path& file) {
    m_is_stale |= std::ranges::find(m_presets, file) != m_presets.end();
    if (!is_open() || file != fs::path(current().file))
        return;
    const auto text = read_text(file);
    if (!text || *text == m_saved.text)
        return;
    const bool has_edits = has_changes();
    m_saved.text = *text;
    if (has_edits)
        return m_work.messages.say(fmt::format("\"{}\" changed on disk. Your unsaved cues are "
                                               "kept. Save to overwrite it, or open it again.",
                                               file.filename().string()),
                                   true);
    change(m_saved, "Cues changed on disk");
}

std::string CueControl::open_preset() const {
    if (!m_work.document || preset_file(*m_work.document).empty())
        return {};
    return reference_to_preset(m_work.library, m_work.document->look().id,
                               preset_file(*m_work.document), preset_name(*m_work.document));
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
    m_is_stale = true;
}

void CueControl::update() {
    if (!m_work.document || m_work.document->has_pending_stack())
        return;
    const CueText& text = m_work.document->state().cues;
    if (!m_is_stale && text == m_read)
        return;
    m_is_stale = false;
    m_read = text;
    compare_with_file();
    read();
}

// After the restart of the program or an undo, the text may be of a file that was not read yet.
void CueControl::compare_with_file() {
    if (m_read.file == m_saved.file || m_read.file.empty())
        return;
    const auto text = read_text(m_read.file);
    m_saved = {m_read.file, text ? *text : std::string()};
    if (text && *text != m_read.text)
        m_work.messages.say(
            fmt::format("The cues differ from \"{}\". Save to overwrite it, or open it again.",
                        fs::path(m_read.file).filename().string()),
            true);
}

void CueControl::read() {
    const fs::path file = m_read.file.empty() ? fs::path("cues") : fs::path(m_read.file);
    const bool had_cues = m_work.cues != nullptr;
    const Diagnostics before = std::exchange(m_problems, {});
    m_work.cues.reset();
    m_sheet.reset();
    m_presets.clear();
    if (!m_read.is_empty()) {
        auto sheet = parse_cue_sheet(m_read.text, file);
        auto plan =
            sheet ? plan_cues(*sheet, file, m_work.document->look(), m_work.library, m_presets)
                  : Result<CuePlan>(fail(sheet.error()));
        if (sheet)
            m_sheet = std::move(*sheet);
        if (!plan)
            m_problems = plan.error();
        else if (m_is_playing && !plan->is_empty())
            m_work.cues = std::make_shared<const CuePlan>(std::move(*plan));
    }
    if (!m_problems.empty() && m_problems != before)
        m_work.messages.say(m_problems.front());
    if (had_cues || m_work.cues)
        m_frames.reapply();  // values without cues, or with other ones
}
