#include "lab/offline/still_export.h"

#include "base/text.h"
#include "io/files/atomic_file.h"
#include "io/pictures/picture_file.h"
#include "io/pictures/png_encoder.h"
#include "io/video/avif_file.h"
#include "io/video/frame_bytes.h"
#include "lab/document/sharing.h"
#include "lab/offline/offline.h"
#include "lab/offline/output_precision.h"
#include "model/picture/display_bytes.h"

#include <algorithm>
#include <cmath>

namespace fs = std::filesystem;

const std::vector<StillFormat>& still_formats() {
    static const std::vector<StillFormat> formats{
        {"PNG, 8 bit", ".png", 8, "Display values. Opens as a preset."},
        {"PNG, 16 bit", ".png", 16, "Display values in 16 bits. Opens as a preset."},
        {"EXR", ".exr", 8, "Stored values, including those above 1."},
        {"AVIF", ".avif", 8, "Small 10-bit file for web pages."},
    };
    return formats;
}

namespace {
std::string ending_of(const fs::path& file) {
    return to_lower(file.extension().string());
}

Result<void> save_png_16(const RawPicture& picture, const Document& document,
                         const StillSettings& settings, const RecentMedia& recent) {
    const bool has_alpha =
        document.look().passes.back().has_alpha && is_transparent(picture_of(picture));
    auto png = encode_png_16(picture.extent, display_words(picture, FrameAlpha::own), has_alpha);
    if (!png)
        return fail(png.error());
    const auto whole = png_with_preset(*png, document, recent);
    return whole ? write_atomically(settings.file, *whole) : fail(whole.error());
}
}  // namespace

Result<void> check_still(const fs::path& file) {
    const auto& formats = still_formats();
    if (std::ranges::find(formats, ending_of(file), &StillFormat::ending) == formats.end())
        return fail({{}, 0, "picture files must end in .png, .exr or .avif"});
    return check_writable(file);
}

Result<void> save_still(const RawPicture& picture, const Document& document,
                        const StillSettings& settings, const RecentMedia& recent) {
    if (auto good = check_still(settings.file); !good)
        return good;
    const std::string ending = ending_of(settings.file);
    if (ending == ".avif")
        return save_avif(picture, settings.file);
    if (ending == ".png" && settings.png_bits == 16)
        return save_png_16(picture, document, settings, recent);
    if (ending == ".png")
        return save_picture_with_preset(picture_of(picture), document, settings.file, recent);
    const auto bytes = encode_picture(picture, ending);
    return bytes ? write_atomically(settings.file, *bytes)
                 : fail({settings.file, 0, bytes.error().front().message});
}

bool is_deep_still(const StillSettings& settings) {
    const std::string ending = ending_of(settings.file);
    return ending == ".avif" || (ending == ".png" && settings.png_bits > 8);
}

Result<ExportResult> export_still(const CuedDocument& cued, const StillSettings& settings,
                                  const Roots& roots, JobProgress& work) {
    constexpr double fps = 60.0;
    const Document& document = cued.document;
    if (auto good = check_still(settings.file); !good)
        return fail(good.error());
    Document changed = document;  // the window may not have applied its constants yet
    if (auto done = apply_constants(changed); !done)
        return fail(done.error());
    if (is_deep_still(settings))
        raise_precision(changed);
    const auto end = std::max<std::int64_t>(1, std::llround(settings.seconds * fps));
    const auto frames = std::min<std::int64_t>(end, std::max(document.look().settle_frames, 1));
    auto offline = Offline::create({.document = std::move(changed),
                                    .cues = cued.plan(),
                                    .start_frame = end - frames,
                                    .switches = settings.switches},
                                   settings.size, fps);
    if (!offline)
        return fail(offline.error());
    for (std::int64_t drawn = 0; drawn < frames; ++drawn) {
        if (work.is_cancelled)
            return fail({{}, 0, "saving the picture was cancelled"});
        work.share = static_cast<double>(drawn) / static_cast<double>(frames);
        drawn + 1 < frames ? offline->advance_unseen() : offline->advance();
    }
    RawPicture picture;
    offline->read(static_cast<int>(picture_pass(document.look(), settings.switches)), picture);
    if (auto saved = save_still(picture, with_precision_of(offline->drawn_document(), document),
                                settings, RecentMedia(roots));
        !saved)
        return fail(saved.error());
    if (const Diagnostics problems = offline->take_problems(); has_errors(problems))
        return fail(problems);
    return ExportResult{settings.file, 0, picture.extent, {}};
}
