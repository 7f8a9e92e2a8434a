#include "lab/export/verification.h"

#include "base/file_uri.h"
#include "formats/look_format.h"
#include "io/files/atomic_file.h"
#include "io/files/scratch_folder.h"
#include "io/pictures/picture_file.h"
#include "io/system/browser.h"
#include "lab/document/live_content.h"
#include "lab/export/page_picture.h"
#include "lab/offline/offline.h"
#include "model/picture/display_bytes.h"
#include "model/picture/source_spec.h"
#include "signals/patterns/patterns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace fs = std::filesystem;

namespace {
using Outcome = Verification::Outcome;

Verification not_verified(const Diagnostics& reasons) {
    return {Outcome::not_verified, "not verified: " + reasons.front().message};
}

// The shape of the export, at most 640x360.
Extent compared_size(Extent size) {
    constexpr double width = 640.0;
    constexpr double height = 360.0;
    const double scale = std::min({1.0, width / size.width, height / size.height});
    return {std::max(1, static_cast<int>(std::lround(size.width * scale))),
            std::max(1, static_cast<int>(std::lround(size.height * scale)))};
}

// Frames with a history differ more the more frames there are.
int compared_frames(const Look& look) {
    return std::clamp(look.settle_frames, 16, 60);
}

Verification compared(const std::vector<std::uint8_t>& ours,
                      const std::vector<std::uint8_t>& theirs) {
    constexpr int channels = 3;
    if (ours.size() != theirs.size())
        return {Outcome::failed, "failed: the picture has another size"};
    int maximum = 0;
    std::size_t different = 0;
    std::size_t far_off = 0;
    for (std::size_t at = 0; at < ours.size(); at += channels) {
        int largest = 0;
        for (std::size_t i = at; i < at + channels; ++i)
            largest = std::max(largest, std::abs(ours[i] - theirs[i]));
        maximum = std::max(maximum, largest);
        different += largest > 0 ? 1 : 0;
        far_off += largest > 1 ? 1 : 0;
    }
    const double pixels = static_cast<double>(ours.size()) / channels;
    const bool is_good = maximum <= 3 && static_cast<double>(far_off) <= 0.001 * pixels;
    return {
        is_good ? Outcome::verified : Outcome::failed,
        fmt::format("{}: max {}/255, {:.2g} % of pixels differ", is_good ? "verified" : "failed",
                    maximum, 100.0 * static_cast<double>(different) / pixels)};
}

// Drawn by the system's GL, or by the browser's own software GL. The error is that of the browser.
Result<PagePicture> drawn_by_browser(const std::string& url, const fs::path& profiles,
                                     double seconds, const JobProgress* work) {
    PagePicture drawn;
    for (const bool uses_software : {false, true}) {
        const fs::path profile = profiles / (uses_software ? "software" : "system");
        const auto html = run_in_browser(
            {url, profile, seconds, uses_software, work ? &work->is_cancelled : nullptr});
        if (!html)
            return fail(html.error());
        drawn = picture_in_page(*html);
        if (!drawn.lacks_webgl())
            break;
    }
    return drawn;
}

Result<Picture> decoded(const std::string& png, const fs::path& file) {
    if (auto written = write_atomically(file, png); !written)
        return fail(written.error());
    return load_picture(file);
}
}  // namespace

bool can_verify() {
    return !find_browser().empty();
}

namespace {
// The last frame of a page.
Verification compared_with_page(const Picture& ours, const fs::path& page, int frames,
                                const fs::path& scratch, double seconds, const JobProgress* work) {
    const std::string url =
        fmt::format("file://{}?frames={}&size={}x{}", percent_encoded(page.string()), frames,
                    ours.extent.width, ours.extent.height);
    const auto drawn = drawn_by_browser(url, scratch, seconds, work);
    if (!drawn)
        return not_verified(drawn.error());
    if (!drawn->fault.empty())
        return {Outcome::failed, "failed: " + drawn->fault};
    const auto theirs = decoded(drawn->png, scratch / "page.png");
    return theirs ? compared(display_bytes(ours), display_bytes(*theirs))
                  : not_verified(theirs.error());
}

// The source as other programs have it, with 8 bits. nullopt: it has no more than that, or is a
// video.
std::optional<Picture> reduced_source(const Document& document) {
    constexpr double seconds = 1.0;  // of a moving pattern, which is empty at first
    constexpr std::string_view prefix = "pattern:";
    const auto source = parse_source(document.state().source);
    if (document.look().driven_by != Driver::picture || !source)
        return std::nullopt;
    const auto picture = source->is_pattern()
                             ? make_pattern(source->picture.substr(prefix.size()), seconds)
                             : load_picture(source->picture);
    if (!picture || picture->encoding == Encoding::display)
        return std::nullopt;
    Picture reduced{
        .extent = picture->extent, .channels = 3, .encoding = Encoding::display, .pixels = {}};
    for (const std::uint8_t byte : display_bytes(*picture))
        reduced.pixels.push_back(static_cast<float>(byte) / 255.0f);
    return reduced;
}

// The last frame. `source`: instead of the document's.
Result<Picture> drawn_frame(PreparedLook prepared, Extent size, int frames,
                            const std::optional<Picture>& source) {
    auto offline = Offline::create(std::move(prepared), size, 60.0);
    if (!offline)
        return fail(offline.error());
    if (source)
        if (auto shown = offline->override_source(*source); !shown)
            return fail(shown.error());
    return offline->picture_after(frames);
}

// Opens the written file as a look. Both looks get the same source, without modulation, which the
// file does not have.
Verification compared_with_file(const ExportRequest& request, Extent size, int frames,
                                JobProgress* work) {
    LoadedLook read = load_look(request.path, {});
    if (!read.look)
        return {Outcome::failed, "failed: " + read.look.error().front().message};
    PreparedLook ours = request.prepared;
    ours.document.amend([](DocumentState& state) { state.modulations.clear(); });
    PreparedLook theirs{.document = Document(std::move(*read.look))};
    theirs.document.amend(
        [&](DocumentState& state) { state.source = request.prepared.document.state().source; });
    const std::optional<Picture> source = reduced_source(ours.document);
    const auto our_frame = drawn_frame(std::move(ours), size, frames, source);
    if (!our_frame)
        return not_verified(our_frame.error());
    if (work)
        work->share = 0.6;
    const auto their_frame = drawn_frame(std::move(theirs), size, frames, source);
    return their_frame ? compared(display_bytes(*our_frame), display_bytes(*their_frame))
                       : not_verified(their_frame.error());
}

Verification verified_page(const ExportTarget& target, const ExportRequest& request, Extent size,
                           int frames, double seconds, JobProgress* work) {
    const auto scratch = ScratchFolder::create();
    if (!scratch)
        return not_verified(scratch.error());
    const auto page = target.page(request, scratch->path());
    if (!page)
        return {Outcome::failed, "failed: " + page.error().front().message};
    if (!can_verify())
        return {Outcome::not_verified, "not verified: chromium is not installed"};
    const auto ours = drawn_frame(request.prepared, size, frames, {});
    if (!ours)
        return not_verified(ours.error());
    if (work)
        work->share = 0.5;
    return compared_with_page(*ours, *page, frames, scratch->path(), seconds, work);
}
}  // namespace

Verification verify_export(const ExportTarget& target, const ExportRequest& request, double seconds,
                           JobProgress* work) {
    if (const std::string reason = why_not_repeatable(request.prepared.document); !reason.empty())
        return {Outcome::not_verified, "not verified: " + reason};
    if (!target.why_not_drawn.empty())
        return {Outcome::not_verified, "not verified: " + target.why_not_drawn};
    const Extent size = compared_size(request.size);
    const int frames = compared_frames(request.prepared.document.look());
    return target.page ? verified_page(target, request, size, frames, seconds, work)
                       : compared_with_file(request, size, frames, work);
}
