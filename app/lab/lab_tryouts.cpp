// The part of Lab that tries values out, and goes to others over some time.
#include "formats/preset_format.h"
#include "lab/lab.h"
#include "lab/morphing.h"
#include "lab/tryouts.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace fs = std::filesystem;

void Lab::ask_for_step(const StepQuestion& question) {
    if (m_document)
        m_tryouts->probe().ask(question);
}

void Lab::end_step() {
    m_tryouts->probe().stop();
}

void Lab::draw_sheet(const SheetRequest& request) {
    m_tryouts->sheet().begin(request);
}

void Lab::end_sheet() {
    m_tryouts->sheet().cancel();
}

void Lab::take_from_sheet(std::size_t number) {
    const auto& cells = m_tryouts->sheet().cells();
    if (!m_document || number >= cells.size())
        return;
    const SweepCell& cell = cells[number].values;
    m_document->set_values({cell.values.begin(), cell.values.end()}, "Take " + cell.caption);
    m_document->finish();
}

// The picture itself has been drawn.
void Lab::try_out() {
    if (m_document->is_restacking() || m_renderer->executor().plan().targets.empty() ||
        m_renderer->replay().is_running())
        return;
    m_tryouts->update({*m_document, m_player, m_drive, *m_renderer, m_images, picture_extent()});
}

void Lab::morph_to(const fs::path& file, double seconds) {
    const auto preset = load_preset(file);
    if (!m_document || !succeeded(preset))
        return;
    if (preset->look != m_document->look().id)
        return say("'" + preset->name + "' is a preset of another look: it can only be opened");
    const auto values = fitted_values(m_document->look(), *preset, file);
    if (!succeeded(values))
        return;
    end_morph();
    m_morphing = std::make_unique<Morphing>(*m_document, preset->name,
                                            renamed_values(m_document->look(), *values), seconds);
    if (!m_morphing->changes_anything()) {
        m_morphing.reset();
        say("The values of '" + preset->name + "' are what is here already");
    }
}

void Lab::end_morph() {
    if (m_morphing && m_document)
        m_document->finish();
    m_morphing.reset();
}

void Lab::go_on_morphing(double wall_seconds) {
    if (!m_morphing || m_morphing->go_on(*m_document, wall_seconds))
        return;
    say(m_morphing->has_arrived() ? "Arrived at '" + m_morphing->name() + "'"
                                  : "Something else was turned: the morph has ended there");
    end_morph();
}
