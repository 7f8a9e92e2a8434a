#pragma once

#include "lab/document/output_name.h"
#include "lab/export/verification.h"
#include "lab/storage/background_work.h"
#include "lab/window/export_form.h"

#include <optional>
#include <string>
#include <vector>

/// What to export, and how.
struct LookExportSettings {
    std::size_t target = 0;  // index of export_targets()
    std::filesystem::path path;
    Extent size;
    bool verifies = false;
};

struct LookExportResult {
    ExportedLook made;
    std::optional<Verification> verification;
};

/// Exports a copy of the document on a background thread, and finds out before what would be lost.
class LookExporter {
public:
    /// Starts to find what a target would lose.
    void find_losses(const Document& document, std::size_t target);
    /// Sentences; the error is the reason why the look can't be exported.
    const BackgroundWork<std::vector<std::string>>& losses() const { return m_losses; }

    void start(const Document& document, const PassSwitches& switches,
               const LookExportSettings& settings);
    void cancel() { m_export.cancel(); }
    const BackgroundWork<LookExportResult>& work() const { return m_export; }

    void update();
    bool is_running() const { return m_losses.is_running() || m_export.is_running(); }

private:
    BackgroundWork<std::vector<std::string>> m_losses;
    BackgroundWork<LookExportResult> m_export;
};

/// The form with a folder and an unused name.
LookExportForm initial_look_export(LookExportForm last, const Document& document, const Date& date);
/// The form for another target: its file name gets the target's ending.
LookExportForm with_target(LookExportForm form, std::size_t target);
/// The settings of a form. The error is a sentence about its file name.
Result<LookExportSettings> planned_look_export(const LookExportForm& form, Extent size);
