#include "lab/offline/frame_export.h"

#include "base/text.h"
#include "io/files/atomic_file.h"
#include "lab/offline/export.h"
#include "lab/offline/offline.h"
#include "signals/signal_table.h"

namespace {
Result<void> check_export(const Document& document, const std::filesystem::path& file) {
    const SignalKind* kind = find_kind(document.state().signal.kind);
    if (document.look().driven_by == Driver::signal && kind && (kind->is_live || kind->is_sent))
        return fail({{}, 0, "live input can't be exported. Choose another signal."});
    const auto names = parse_frame_names(file.string());
    if (!names)
        return fail(names.error());
    const std::string ending = to_lower(file.extension().string());
    if (names->is_sequence() ? ending != ".png" && ending != ".exr" : !is_film_name(file))
        return fail({file, 0,
                     "video files must end in .mp4, .webm or .gif. Image sequences need %04d in "
                     "the name and must end in .png or .exr."});
    return check_writable(names->name(0));
}
}  // namespace

Result<ExportResult> export_document(const Document& document, Extent size,
                                     const ExportSettings& wishes, JobProgress& work) {
    if (auto good = check_export(document, wishes.file); !good)
        return fail(good.error());
    Document changed = document;  // the window may not have applied its constants yet
    if (auto done = apply_constants(changed); !done)
        return fail(done.error());
    auto offline = Offline::create({std::move(changed), {}}, size, wishes.fps);
    if (!offline)
        return fail(offline.error());
    const auto usual = default_video_seconds(*offline, 0.0);
    if (!usual)
        return fail(usual.error());
    const double seconds = wishes.seconds > 0.0 ? wishes.seconds : *usual;
    ExportJob job{.part = part_of(0.0, seconds, wishes.fps),
                  .pass = static_cast<int>(document.look().passes.size()) - 1,
                  .fps = wishes.fps};
    const std::int64_t count = job.part.count();
    job.should_continue = [&work, count](std::int64_t drawn) {
        work.share = static_cast<double>(drawn) / static_cast<double>(count);
        return !work.is_cancelled;
    };
    ExportResult exported{wishes.file, count, size, {}};
    const auto done = export_to(wishes.file.string(), *offline, std::move(job), exported.warnings);
    if (!done)
        return fail(done.error());
    if (!*done)
        return fail({{}, 0, "the export was cancelled"});
    if (const Diagnostics problems = offline->take_problems(); has_errors(problems))
        return fail(problems);
    return exported;
}
