#include "lab/offline/frame_export.h"

#include "base/text.h"
#include "io/files/atomic_file.h"
#include "io/video/video_file.h"
#include "lab/offline/export_output.h"
#include "lab/offline/loop.h"
#include "lab/offline/offline.h"
#include "lab/offline/output_precision.h"
#include "model/picture/source_spec.h"
#include "signals/signal_table.h"

namespace fs = std::filesystem;

fs::path source_video(const Document& document) {
    const auto source = parse_source(document.state().source);
    const bool is_video = document.look().driven_by == Driver::picture && source &&
                          source->rate == 0.0 && source->is_file() &&
                          is_video_file(source->picture);
    return is_video ? fs::path(source->picture) : fs::path();
}

namespace {
tl::unexpected<Diagnostics> cancelled() {
    return fail({{}, 0, "the export was cancelled"});
}

Result<void> check_file(const ExportSettings& settings) {
    const std::string ending = to_lower(settings.file.extension().string());
    if (ending == ".png" || ending == ".exr") {
        const auto names = parse_frame_names(settings.file.string());
        if (!names)
            return fail(names.error());
        if (!names->is_sequence())
            return fail({settings.file, 0, "image sequences need %04d in the name"});
        return check_writable(names->name(0));
    }
    if (settings.file.filename().string().find('%') != std::string::npos)
        return fail({settings.file, 0, "image sequences must end in .png or .exr"});
    const auto encoding = film_encoding(settings.file, settings.film);
    if (!encoding)
        return fail(encoding.error());
    if (!settings.size.is_empty())
        if (auto fits = check_film_extent(*encoding, settings.size); !fits)
            return fits;
    return check_writable(settings.file);
}

// The frames of an export that does not loop.
Result<ExportPart> part_to_export(const Offline& offline, const ExportSettings& settings) {
    if (settings.seconds > 0.0)
        return part_of(settings.start, settings.seconds, settings.fps);
    const auto usual = default_video_seconds(offline, settings.start);
    if (!usual)
        return fail(usual.error());
    return part_of(settings.start, *usual, settings.fps);
}

// The frames of one period.
Result<ExportPart> loop_to_export(Offline& offline, Extent size, const ExportSettings& settings,
                                  JobProgress& work) {
    const LoopSearch search{.extent = size,
                            .fps = settings.fps,
                            .seconds = settings.seconds,
                            .should_continue = [&work](std::int64_t drawn, std::int64_t limit) {
                                work.share =
                                    static_cast<double>(drawn) / static_cast<double>(limit);
                                return !work.is_cancelled;
                            }};
    const auto part = find_loop(offline.document(), search);
    offline.make_current();
    if (!part)
        return fail(part.error());
    return *part ? Result<ExportPart>(**part) : cancelled();
}
}  // namespace

bool draws_live_signal(const Document& document) {
    const SignalKind* kind = find_kind(document.state().signal.kind);
    return document.look().driven_by == Driver::signal && kind && (kind->is_live || kind->is_sent);
}

Result<void> check_export(const Document& document, const ExportSettings& settings) {
    if (draws_live_signal(document))
        return fail({{}, 0, "live input can't be exported. Choose another signal."});
    if (settings.loops)
        if (auto fits = check_loop_rate(settings.file.string(), settings.fps); !fits)
            return fits;
    return check_file(settings);
}

Result<ExportResult> export_document(const CuedDocument& cued, Extent size,
                                     const ExportSettings& settings, JobProgress& work) {
    const Document& document = cued.document;
    if (auto good = check_export(document, settings); !good)
        return fail(good.error());
    if (settings.loops && cued.cues)
        return fail({{}, 0, "can't loop: cues don't repeat. Turn off Play cues first."});
    Document changed = document;  // the window may not have applied its constants yet
    if (auto done = apply_constants(changed); !done)
        return fail(done.error());
    if (is_deep_film(settings.file, settings.film))
        raise_precision(changed);
    if (!settings.size.is_empty())
        size = settings.size;
    PreparedLook prepared{.document = std::move(changed), .cues = cued.plan()};
    if (settings.film.hdr)
        prepared.hdr = settings.film.hdr->light;
    prepared.draws_subframes = settings.draws_subframes;
    auto offline = Offline::create(std::move(prepared), size, settings.fps);
    if (!offline)
        return fail(offline.error());
    const auto part = settings.loops ? loop_to_export(*offline, size, settings, work)
                                     : part_to_export(*offline, settings);
    if (!part)
        return fail(part.error());
    ExportJob job{.part = *part,
                  .pass = static_cast<int>(document.look().passes.size()) - 1,
                  .fps = settings.fps,
                  .film = settings.film};
    if (settings.draws_subframes)
        job.subframes = subframes_of(document.look(), document.values());
    job.should_continue = [&work, end = part->end](std::int64_t drawn) {
        work.share = std::min(1.0, static_cast<double>(drawn) / static_cast<double>(end));
        return !work.is_cancelled;
    };
    ExportResult exported{settings.file, part->count(), size, {}};
    const auto done =
        settings.loops
            ? export_loop(settings.file.string(), *offline, job, exported.warnings)
            : export_to(settings.file.string(), *offline, std::move(job), exported.warnings);
    if (!done)
        return fail(done.error());
    if (!*done)
        return cancelled();
    if (const Diagnostics problems = offline->take_problems(); has_errors(problems))
        return fail(problems);
    return exported;
}
