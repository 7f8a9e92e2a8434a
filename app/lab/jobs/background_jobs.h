#pragma once

#include "lab/export/look_exporter.h"
#include "lab/match/photo_matcher.h"
#include "lab/media/render_size.h"
#include "lab/messages/messages.h"
#include "lab/offline/export_queue.h"
#include "lab/offline/impulse.h"
#include "lab/offline/rate_comparison.h"
#include "lab/offline/rate_pictures.h"
#include "lab/offline/still_export.h"
#include "lab/storage/background_work.h"

/// Jobs that draw a copy of the document in the background: comparison of frame rates, impulse
/// response, export of frames and pictures, matching a photo.
class BackgroundJobs {
public:
    BackgroundJobs(const OpenDocument& document, const RenderSize& size, const Roots& roots,
                   Messages& messages)
        : m_document(document), m_size(size), m_roots(roots), m_messages(messages) {}

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
    /// Adds a film or an image sequence to the queue. `cues` that play, null: none.
    void export_frames(const ExportSettings& settings, std::shared_ptr<const CuePlan> cues);
    /// Adds a picture in another size or at another time to the queue.
    void export_still(const StillSettings& settings, std::shared_ptr<const CuePlan> cues);
    /// Adds the pack of a look, stack or shader of another program, with its presets, to the queue.
    void export_pack(const std::string& look, const std::filesystem::path& file);
    /// Encodes a picture that was read of a document, without waiting for the exports.
    void save_still(RawPicture picture, Document document, const StillSettings& settings);
    ExportQueue& exports() { return m_exports; }
    const ExportQueue& exports() const { return m_exports; }
    bool is_exporting() const { return m_exports.is_pending() || m_stills.is_pending(); }
    /// Whether an export that has not ended writes a file.
    bool is_target(const std::filesystem::path& file) const {
        return m_exports.is_target(file) || m_stills.is_target(file);
    }

    /// Exports a look for other programs.
    LookExporter& look_export() { return m_look_export; }
    const LookExporter& look_export() const { return m_look_export; }

    /// Matches the document to a photo.
    PhotoMatcher& matcher() { return m_matcher; }
    const PhotoMatcher& matcher() const { return m_matcher; }

    void update();
    bool is_running() const {
        return m_matcher.is_running() || m_look_export.is_running() || m_rates.is_running() ||
               m_impulse.is_running() || is_exporting();
    }

private:
    void report(const QueuedExport& ended);

    const OpenDocument& m_document;
    const RenderSize& m_size;
    const Roots& m_roots;
    Messages& m_messages;
    BackgroundWork<RateComparison> m_rates;
    RatePictures m_rate_pictures;
    BackgroundWork<ImpulseResponse> m_impulse;
    ExportQueue m_exports;
    LookExporter m_look_export;
    PhotoMatcher m_matcher{m_document, m_messages};
    ExportQueue m_stills;  // pictures that are drawn already
};
