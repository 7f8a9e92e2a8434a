#include "lab/media/look_media.h"

#include "base/text.h"
#include "io/pictures/picture_file.h"
#include "lab/media/source.h"
#include "lab/playback/signal_file.h"
#include "lab/rendering/sanitize.h"
#include "signals/patterns/generated_picture.h"
#include "signals/patterns/patterns.h"
#include "signals/patterns/solids.h"
#include "signals/signal_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace {
void append(const Diagnostics& more, Diagnostics& problems) {
    problems.insert(problems.end(), more.begin(), more.end());
}

void check_source(const std::string& text, Diagnostics& problems) {
    if (const auto spec = parse_source(text); spec && spec->is_live()) {
        if (const auto live = parse_live(spec->picture); !live)
            append(live.error(), problems);
        return;  // depends on another program or a device
    }
    auto source = Source::open(text);
    append(source ? source->take_problems() : source.error(), problems);
}

void check_signal(const Spec& signal, Diagnostics& problems) {
    SignalMedia media;
    if (const std::string file = file_of(signal); !file.empty()) {
        auto read = load_signal_media(file, nullptr, &problems);
        if (!read)
            return append(read.error(), problems);
        media = std::move(*read);
    }
    const SignalKind* kind = find_kind(signal.kind);
    if (kind && (kind->is_sent || kind->is_live))
        return;  // depends on another program or a device
    if (const auto made = make_signal(signal, media); !made)
        append(made.error(), problems);
    append(notes_about(signal), problems);
}

void check_chosen_images(const Look& look, const Values& values, Diagnostics& problems) {
    for (const Parameter& parameter : look.parameters) {
        const std::string& file = value_of(parameter, values).path;
        if (parameter.control != Control::image || file.empty() || made_name(file))
            continue;
        const auto picture = load_picture(file);
        if (!picture)
            append(picture.error(), problems);
        else if (const auto note = note_about(*picture, file))
            problems.push_back(*note);
    }
}
}  // namespace

Diagnostics check_media(const Document& document) {
    Diagnostics problems;
    const Look& look = document.look();
    for (const Image& image : look.images)
        if (const auto read = load_image(image, problems); !read)
            append(read.error(), problems);
    if (look.driven_by == Driver::picture)
        check_source(document.state().source, problems);
    for (Diagnostic& problem : problems)
        if (problem.file.empty())  // from a test pattern
            problem.file = look.manifest;
    if (look.driven_by == Driver::signal)
        check_signal(document.state().signal, problems);
    check_chosen_images(look, document.values(), problems);
    return problems;
}

std::filesystem::file_time_type last_write_time_of(const Image& image, std::error_code& error) {
    std::filesystem::file_time_type latest = std::filesystem::last_write_time(image.file, error);
    for (const std::filesystem::path& face : image.faces)
        if (!error)
            latest = std::max(latest, std::filesystem::last_write_time(face, error));
    return latest;
}

namespace {
void append_rgba(const Picture& picture, std::vector<float>& rgba) {
    const auto channels = static_cast<std::size_t>(picture.channels);
    for (std::size_t i = 0; i < picture.pixels.size(); i += channels) {
        const float* const pixel = picture.pixels.data() + i;
        for (std::size_t channel = 0; channel < 3; ++channel)
            rgba.push_back(pixel[channels < 3 ? 0 : channel]);
        rgba.push_back(channels == 4 ? pixel[3] : 1.0f);
    }
}

// Faces of equal size, stacked vertically.
Result<Picture> load_faces(const Image& image) {
    Picture cube{.extent = {},
                 .channels = 4,
                 .encoding = Encoding::display,
                 .pixels = {},
                 .shape = PictureShape::cube};
    for (const std::filesystem::path& file : image.faces) {
        auto face = load_picture(file);
        if (!face)
            return face;
        const Extent extent = face->extent;
        if (extent.width != extent.height || (!cube.extent.is_empty() && extent != cube.extent))
            return fail(
                {file, 0,
                 fmt::format("is {} x {} px; cube map faces must be squares of the same size",
                             extent.width, extent.height)});
        cube.extent = extent;
        cube.encoding = face->encoding;
        if (cube.note.empty())
            cube.note = face->note;
        append_rgba(*face, cube.pixels);
    }
    cube.extent.height *= static_cast<int>(image.faces.size());
    return cube;
}

Result<Picture> read_image(const Image& image) {
    if (!image.faces.empty())
        return load_faces(image);
    return image.made.empty() ? load_picture(image.file) : made_picture(image.made);
}
}  // namespace

Diagnostic warning_of_black(Diagnostic reason, std::string_view name) {
    reason.severity = Severity::warning;
    reason.message = with_sentence(reason.message, fmt::format("'{}' shows black.", name));
    return reason;
}

Result<std::optional<Picture>> load_image(const Image& image, Diagnostics& warnings) {
    if (image.file.empty() && image.made.empty())
        return std::optional<Picture>();
    auto picture = read_image(image);
    if (picture) {
        if (auto note = note_about(*picture, image.file))
            warnings.push_back(std::move(*note));
        return std::optional(std::move(*picture));
    }
    if (image.is_needed)
        return fail(picture.error());
    for (Diagnostic& reason : picture.error())
        warnings.push_back(warning_of_black(std::move(reason), image.name));
    return std::optional<Picture>();
}
