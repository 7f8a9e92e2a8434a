#pragma once

#include "lab/media/render_size.h"
#include "lab/messages/messages.h"
#include "lab/offline/frame_export.h"
#include "lab/offline/impulse.h"
#include "lab/offline/rate_comparison.h"
#include "lab/offline/rate_pictures.h"
#include "lab/storage/background_work.h"

/// Jobs that draw a copy of the document in the background: comparison of frame rates, impulse
/// response, export of frames.
class BackgroundJobs {
public:
    BackgroundJobs(const OpenDocument& document, const RenderSize& size, Messages& messages)
        : m_document(document), m_size(size), m_messages(messages) {}

    /// Draws the document at several frame rates.
    void compare_rates();
    void cancel_rates() { m_rates.cancel(); }
    const BackgroundWork<RateComparison>& rates() const { return m_rates; }
    /// Shows a pair of the compared rates. At first, the pair that differs most.
    void show_rate_pair(std::size_t pair);
    const RatePictures& rate_pictures() const { return m_rate_pictures; }
    /// Draws an impulse and measures its decay in every pass.
    void fire_impulse(const Pin& pin);
    void cancel_impulse() { m_impulse.cancel(); }
    const BackgroundWork<ImpulseResponse>& impulse() const { return m_impulse; }
    /// Writes a film or an image sequence.
    void export_frames(const ExportSettings& wishes);
    void cancel_export() { m_export.cancel(); }
    const BackgroundWork<ExportResult>& frame_export() const { return m_export; }

    void update();
    bool is_running() const {
        return m_rates.is_running() || m_impulse.is_running() || m_export.is_running();
    }

private:
    const OpenDocument& m_document;
    const RenderSize& m_size;
    Messages& m_messages;
    BackgroundWork<RateComparison> m_rates;
    RatePictures m_rate_pictures;
    BackgroundWork<ImpulseResponse> m_impulse;
    BackgroundWork<ExportResult> m_export;
};
