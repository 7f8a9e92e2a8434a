#include "lab/offline/export_output.h"

#include "base/text.h"
#include "io/system/descriptor.h"
#include "io/system/standard_streams.h"
#include "lab/offline/offline.h"
#include "model/picture/display_bytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

bool is_stream_output(const std::string& output) {
    return output == export_pipe || is_virtual_camera(output);
}

bool is_film_output(const std::string& output) {
    return is_stream_output(output) || is_film_name(output);
}

Result<void> check_loop_rate(const std::string& output, double fps) {
    constexpr double max_gif_rate = 50.0;
    if (fps <= max_gif_rate || !to_lower(output).ends_with(".gif"))
        return {};
    return fail({{},
                 0,
                 fmt::format("a GIF holds at most 50 frames per second, so a loop at {} fps would "
                             "lose frames. Use 50 fps or less.",
                             format_number(fps))});
}

bool is_drawn_as_xy(const Spec& signal) {
    const auto mode = signal.settings.find("mode");
    const auto* const word =
        mode == signal.settings.end() ? nullptr : std::get_if<std::string>(&mode->second);
    return signal.kind == "audio" && word && *word == "xy";
}

std::string lossy_sound_warning(const FilmEncoding& encoding, const Spec& signal) {
    if (!encoding.sound || encoding.sound->is_lossless || !is_drawn_as_xy(signal))
        return {};
    return fmt::format(
        "{} changes the sound. An oscilloscope that plays this film draws a distorted figure. Use "
        ".mov or .mkv for lossless sound.",
        encoding.sound->label);
}

namespace {
/// An opened output. The stages use `film` and `camera`.
struct OpenOutput {
    std::unique_ptr<FilmFile> film = {};         // null: no film
    std::unique_ptr<VirtualCamera> camera = {};  // null: no camera
    FramePipeline::Stages stages;
};

FrameAlpha alpha_of(const Pass& pass, bool keeps_alpha) {
    if (pass.has_alpha)
        return FrameAlpha::own;
    return keeps_alpha ? FrameAlpha::from_black : FrameAlpha::none;
}

const Pass& pass_of(const Offline& offline, const ExportJob& job) {
    return offline.executor().look().passes[static_cast<std::size_t>(job.pass)];
}

// How the pass stores its light.
StoredLight stored_light(const Offline& offline, const ExportJob& job, const HdrLight& light) {
    constexpr double scrgb_unit = 80.0;  // cd/m2
    const Look& look = offline.executor().look();
    const bool is_picture = job.pass + 1 == static_cast<int>(look.passes.size());
    if (is_picture && look.is_scrgb_in_hdr)
        return {Encoding::linear, scrgb_unit};
    return {encoding_of(look, job.pass), light.paper_white};
}

Result<OpenOutput> open_film(const std::string& output, const Offline& offline,
                             const ExportJob& job, Diagnostics& warnings) {
    const auto encoding = film_encoding(output, job.film);
    if (!encoding)
        return fail(Diagnostic{output, 0, encoding.error().front().message});
    const FilmSound sound = sound_of(offline, job.part, job.fps);
    if (sound.rate > 0)
        if (std::string warning = lossy_sound_warning(*encoding, offline.signal().spec());
            !warning.empty())
            add_new(warnings, {{{}, 0, std::move(warning), Severity::warning}});
    auto film = FilmFile::create(output, {.extent = offline.executor().target(job.pass).extent(),
                                          .rate = frame_rate_fraction(job.fps),
                                          .sound = sound,
                                          .encoding = *encoding});
    if (!film)
        return fail(film.error());
    // Stored pictures have their alpha already.
    const FrameAlpha kept = job.stored ? FrameAlpha::own : alpha_of(pass_of(offline, job), true);
    const FrameAlpha alpha = encoding->keeps_alpha ? kept : FrameAlpha::none;
    FramePipeline::Stages stages =
        encoding->hdr ? hdr_film_stages(**film, stored_light(offline, job, encoding->hdr->light))
                      : film_stages(**film, alpha);
    return OpenOutput{std::move(*film), {}, std::move(stages)};
}

Result<OpenOutput> open_camera(const std::string& output, Extent extent, double fps) {
    const auto spec = parse_virtual_camera(output);
    if (!spec)
        return fail(spec.error());
    auto camera = open_virtual_camera(*spec, extent, frame_rate_fraction(fps));
    if (!camera)
        return fail(camera.error());
    FramePipeline::Stages stages = camera_stages(**camera, extent, fps);
    return OpenOutput{{}, std::move(*camera), std::move(stages)};
}

Result<OpenOutput> open_output(const std::string& output, const Offline& offline,
                               const ExportJob& job, Diagnostics& warnings) {
    const Extent extent = offline.executor().target(job.pass).extent();
    if (output == export_pipe)
        return OpenOutput{
            {}, {}, pipe_stages(standard_output, extent, frame_rate_fraction(job.fps))};
    if (is_virtual_camera(output))
        return open_camera(output, extent, job.fps);
    if (is_film_output(output))
        return open_film(output, offline, job, warnings);
    const auto names = parse_frame_names(output);
    if (!names)
        return fail(names.error());
    return OpenOutput{{},
                      {},
                      sequence_stages(*names, job.loops ? 0 : job.part.first,
                                      alpha_of(pass_of(offline, job), job.film.keeps_alpha))};
}

// Flashes are counted if the pass is the picture.
bool counts_flashes(const Offline& offline, const ExportJob& job) {
    return job.pass + 1 == static_cast<int>(offline.executor().look().passes.size());
}

// The sub-frames of a source frame are seen as one frame if source frames follow fast enough.
int joined_subframes(const ExportJob& job) {
    constexpr double fast = 50.0;  // source frames per second
    return job.fps >= fast * job.subframes ? job.subframes : 1;
}

// Also shows the last picture of a camera for its time.
Result<void> finish(const OpenOutput& opened, double fps, const FlashLog& flashes,
                    Diagnostics& warnings) {
    if (opened.camera) {
        std::this_thread::sleep_for(std::chrono::duration<double>(1.0 / fps));
        return opened.camera->finish();
    }
    if (opened.film)
        if (auto finished = opened.film->finish(); !finished)
            return finished;
    if (const auto warning = flashes.warning())
        warnings.push_back({{}, 0, *warning, Severity::warning});
    return {};
}
}  // namespace

Result<bool> export_to(const std::string& output, Offline& offline, ExportJob job,
                       Diagnostics& warnings) {
    auto opened = open_output(output, offline, job, warnings);
    if (!opened)
        return fail(opened.error());
    job.stages = opened->stages;
    FlashLog flashes;
    if (counts_flashes(offline, job) && !opened->camera)
        job.flashes = &flashes;
    job.subframes = joined_subframes(job);
    auto done = export_frames(offline, job);
    if (!done || !*done)
        return done;
    if (auto finished = finish(*opened, job.fps, flashes, warnings); !finished)
        return fail(finished.error());
    return true;
}

namespace {
// Of any channel, in units of 1/255.
int largest_difference(const RawPicture& a, const RawPicture& b) {
    const auto first = display_bytes(a);
    const auto second = display_bytes(b);
    int largest = first.size() == second.size() ? 0 : 255;
    for (std::size_t i = 0; largest < 255 && i < first.size(); ++i)
        largest = std::max(largest, std::abs(int{first[i]} - int{second[i]}));
    return largest;
}

/// Draws the periods of a loop.
class LoopDrawing {
public:
    LoopDrawing(Offline& offline, const ExportJob& job) : m_offline(offline), m_job(job) {}

    /// Draws up to the first frame of the loop; false: cancelled.
    bool start() {
        while (m_drawn < m_job.part.first) {
            if (!should_continue())
                return false;
            m_offline.advance_unseen();
            ++m_drawn;
        }
        draw(m_first);
        return true;
    }

    /// Writes a period from its first frame, which is already drawn; false: cancelled.
    Result<bool> write(const ExportJob& job) {
        FramePipeline pipeline(watched_stages(job));
        for (std::int64_t i = 0; i < job.part.count(); ++i) {
            if (!should_continue()) {
                pipeline.cancel();
                return false;
            }
            FramePipeline::Frame* const frame = pipeline.next();
            if (!frame)
                break;
            frame->number = i;
            if (i == 0)
                frame->picture = m_first;
            else
                draw(frame->picture);
            pipeline.push(frame);
        }
        if (auto done = pipeline.finish(); !done)
            return fail(done.error());
        return true;
    }

    /// Draws the first frame of the next period. Returns its largest difference to the previous
    /// period's first frame, in 1/255.
    int next_period() {
        RawPicture next;
        draw(next);
        const int difference = largest_difference(m_first, next);
        m_first = std::move(next);
        return difference;
    }

private:
    bool should_continue() const { return m_job.should_continue(m_drawn); }
    void draw(RawPicture& picture) {
        m_offline.advance();
        m_offline.read(m_job.pass, picture);
        ++m_drawn;
    }

    Offline& m_offline;
    const ExportJob& m_job;
    std::int64_t m_drawn = 0;
    RawPicture m_first;
};
}  // namespace

Result<bool> export_loop(const std::string& output, Offline& offline, const ExportJob& job,
                         Diagnostics& warnings) {
    constexpr int max_periods = 4;
    constexpr int tolerance = 1;  // in 1/255
    LoopDrawing drawing(offline, job);
    if (!drawing.start())
        return false;
    ExportJob period = job;
    period.loops = true;
    period.subframes = joined_subframes(job);
    int difference = 0;
    for (int i = 0; i < max_periods; ++i) {
        auto opened = open_output(output, offline, period, warnings);
        if (!opened)
            return fail(opened.error());
        period.stages = opened->stages;
        FlashLog flashes;
        period.flashes = counts_flashes(offline, job) ? &flashes : nullptr;
        auto written = drawing.write(period);
        if (!written || !*written)
            return written;
        difference = drawing.next_period();
        if (difference <= tolerance) {
            if (auto finished = finish(*opened, period.fps, flashes, warnings); !finished)
                return fail(finished.error());
            return true;
        }
        period.part.first += job.part.count();
        period.part.end += job.part.count();
    }
    return fail({{},
                 0,
                 fmt::format("the loop does not close: after {} frames the picture differs by "
                             "{}/255. Set the period with --seconds, or in the field Period.",
                             job.part.count(), difference)});
}
