#include "lab/offline/background_jobs.h"

void BackgroundJobs::compare_rates() {
    m_rate_pictures.clear();
    if (m_document)
        m_rates.start([document = *m_document, picture = m_size.extent()](JobProgress& work) {
            return ::compare_rates(document, picture, work);
        });
}

void BackgroundJobs::show_rate_pair(std::size_t pair) {
    if (const auto& outcome = m_rates.outcome(); outcome && *outcome)
        m_messages.succeeded(m_rate_pictures.show(**outcome, pair));
}

void BackgroundJobs::fire_impulse(const Pin& pin) {
    if (m_document)
        m_impulse.start(
            [document = *m_document, picture = m_size.extent(), pin](JobProgress& work) {
                return ::fire_impulse(document, picture, {.pin = pin}, work);
            });
}

void BackgroundJobs::export_frames(const ExportSettings& wishes) {
    if (m_document)
        m_export.start(
            [document = *m_document, picture = m_size.extent(), wishes](JobProgress& work) {
                return export_document(document, picture, wishes, work);
            });
}

void BackgroundJobs::update() {
    const bool was_comparing = m_rates.is_running();
    m_rates.update();
    if (const auto& compared = m_rates.outcome(); was_comparing && compared && *compared)
        show_rate_pair((*compared)->worst_index());
    m_impulse.update();
    m_export.update();
}
