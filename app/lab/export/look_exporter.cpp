#include "lab/export/look_exporter.h"

#include "base/text.h"
#include "lab/offline/export_plan.h"

#include <utility>

namespace fs = std::filesystem;

void LookExporter::find_losses(const Document& document, std::size_t target) {
    m_losses.start([document, &chosen = export_targets()[target]](JobProgress&) {
        return losses_of(chosen, PreparedLook{.document = document});
    });
}

void LookExporter::start(const Document& document, const PassSwitches& switches,
                         const LookExportSettings& settings) {
    m_export.start([document, switches, settings](JobProgress& work) -> Result<LookExportResult> {
        constexpr double timeout = 120.0;  // s
        const PreparedLook prepared{.document = document, .switches = switches};
        const ExportTarget& target = export_targets()[settings.target];
        const ExportRequest request{prepared, settings.size, settings.path};
        auto made = export_look(target, request);
        if (!made)
            return fail(made.error());
        work.share = 0.2;
        LookExportResult result{std::move(*made), {}};
        if (settings.verifies)
            result.verification = verify_export(target, request, timeout, &work);
        return result;
    });
}

void LookExporter::update() {
    m_losses.update();
    m_export.update();
}

namespace {
const std::string& ending_of(std::size_t target) {
    return export_targets()[target].extension;
}
}  // namespace

LookExportForm initial_look_export(LookExportForm last, const Document& document,
                                   const Date& date) {
    if (const fs::path typed(last.file); typed.has_parent_path())
        last.folder = typed_file(last.file, last.folder).parent_path();
    last.folder = usual_folder(last.folder);
    const std::string stem = output_stem(document, date);
    last.file = unused_name(last.folder, stem, ending_of(last.target));
    return last;
}

LookExportForm with_target(LookExportForm form, std::size_t target) {
    fs::path file(form.file);
    if (file.extension() == ending_of(form.target))
        file.replace_extension();
    form.target = target;
    form.file = file.string() + ending_of(target);
    return form;
}

Result<LookExportSettings> planned_look_export(const LookExportForm& form, Extent size) {
    if (trim(form.file).empty())
        return fail({{}, 0, "Type a file name."});
    LookExportSettings settings{form.target, typed_file(form.file, form.folder), size,
                                form.verifies};
    const std::string& ending = ending_of(form.target);
    if (!ending.empty() && settings.path.extension() != ending)
        settings.path += ending;
    std::error_code error;
    if (!fs::is_directory(settings.path.parent_path(), error))
        return fail({{}, 0, "This folder does not exist. Choose another folder."});
    return settings;
}
