#include "lab/offline/background_jobs.h"

void BackgroundJobs::compare_rates() {
    if (m_document)
        m_rates.start([document = *m_document, picture = m_size.extent()](Work& work) {
            return ::compare_rates(document, picture, work);
        });
}

void BackgroundJobs::fire_impulse(const Pin& place) {
    if (m_document)
        m_impulse.start([document = *m_document, picture = m_size.extent(), place](Work& work) {
            return ::fire_impulse(document, picture, {.place = place}, work);
        });
}

void BackgroundJobs::export_frames(const ExportWishes& wishes) {
    if (m_document)
        m_export.start([document = *m_document, picture = m_size.extent(), wishes](Work& work) {
            return export_document(document, picture, wishes, work);
        });
}

void BackgroundJobs::update() {
    m_rates.update();
    m_impulse.update();
    m_export.update();
}
