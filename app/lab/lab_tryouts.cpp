// The part of Lab that tries values out beside the picture.
#include "lab/lab.h"
#include "lab/trials/tryouts.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

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
    m_document->set_values({cell.values.begin(), cell.values.end()},
                           fmt::format("Apply {}", cell.caption));
    m_document->finish();
}

// The picture itself has been drawn.
void Lab::try_out() {
    if (m_document->is_restacking() || TextConstants::are_pending(*m_document) ||
        m_renderer->executor().plan().targets.empty() || m_renderer->replay().is_running())
        return;
    m_tryouts->update({*m_document, m_player, m_drive, *m_renderer, m_images, m_size.extent()});
}
