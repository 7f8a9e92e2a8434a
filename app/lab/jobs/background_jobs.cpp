#include "lab/jobs/background_jobs.h"

#include "base/text.h"
#include "lab/editor/external_programs.h"
#include "lab/packs/pack_writer.h"

#include <fmt/format.h>

#include <utility>

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

void BackgroundJobs::export_frames(const ExportSettings& settings,
                                   std::shared_ptr<const CuePlan> cues) {
    if (m_document)
        m_exports.add(settings.file, [cued = CuedDocument{*m_document, std::move(cues)},
                                      picture = m_size.extent(), settings](JobProgress& work) {
            return export_document(cued, picture, settings, work);
        });
}

void BackgroundJobs::export_still(const StillSettings& settings,
                                  std::shared_ptr<const CuePlan> cues) {
    if (m_document)
        m_exports.add(settings.file, [cued = CuedDocument{*m_document, std::move(cues)}, settings,
                                      roots = m_roots](JobProgress& work) {
            return ::export_still(cued, settings, roots, work);
        });
}

void BackgroundJobs::export_pack(const std::string& look, const std::filesystem::path& file) {
    m_exports.add(file, [look, file, roots = m_roots](JobProgress& work) -> Result<ExportResult> {
        auto written = write_pack({{look}, file}, Library(roots), [&](double share) {
            work.share = share;
            return !work.is_cancelled;
        });
        if (!written)
            return fail(written.error());
        return ExportResult{file, 0, {}, std::move(written->warnings)};
    });
}

void BackgroundJobs::save_still(RawPicture picture, Document document,
                                const StillSettings& settings) {
    m_stills.add(settings.file,
                 [document = std::move(document), picture = std::move(picture), settings,
                  roots = m_roots](JobProgress&) -> Result<ExportResult> {
                     const auto saved =
                         ::save_still(picture, document, settings, RecentMedia(roots));
                     if (!saved)
                         return fail(saved.error());
                     return ExportResult{settings.file, 0, picture.extent, {}};
                 });
}

namespace {
// A picture has no number of frames.
std::string ended_text(const ExportResult& result) {
    const std::string file = result.file.filename().string();
    const std::string size = fmt::format("{} × {}", result.size.width, result.size.height);
    std::string text =
        result.size == Extent{} ? fmt::format("Saved \"{}\"", file)
        : result.frames == 0    ? fmt::format("Saved \"{}\" ({})", file, size)
        : result.frames == 1
            ? fmt::format("Exported 1 frame ({}) to \"{}\"", size, file)
            : fmt::format("Exported {} frames ({}) to \"{}\"", result.frames, size, file);
    for (const Diagnostic& warning : result.warnings)
        text = with_sentence(text, warning.message);
    return text;
}
}  // namespace

void BackgroundJobs::report(const QueuedExport& ended) {
    if (ended.state == QueuedExport::State::failed)
        return m_messages.say(ended.reasons.front());
    m_messages.offer(ended_text(ended.result),
                     {.name = "Open folder",
                      .commands = {[folder = ended.file.parent_path()](ExternalPrograms& programs) {
                          programs.open_folder(folder);
                      }}});
}

void BackgroundJobs::update() {
    const bool was_comparing = m_rates.is_running();
    m_rates.update();
    if (const auto& compared = m_rates.outcome(); was_comparing && compared && *compared)
        show_rate_pair((*compared)->worst_index());
    m_impulse.update();
    m_look_export.update();
    m_matcher.update();
    for (ExportQueue* queue : {&m_exports, &m_stills})
        for (const QueuedExport& ended : queue->update())
            report(ended);
    m_stills.remove_ended();
}
