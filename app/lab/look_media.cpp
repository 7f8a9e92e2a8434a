#include "lab/look_media.h"

#include "io/picture_file.h"
#include "lab/signal_file.h"
#include "lab/source.h"
#include "signals/kinds.h"
#include "signals/patterns.h"
#include "signals/solids.h"

#include <cassert>

namespace {
template <class T>
void append_faults(const Result<T>& read, Diagnostics& problems) {
    if (!read)
        problems.insert(problems.end(), read.error().begin(), read.error().end());
}
}  // namespace

Diagnostics check_media(const Look& look) {
    Diagnostics problems;
    for (const Image& image : look.images)
        append_faults(load_image(image, problems), problems);
    if (look.driven_by == Driver::picture)
        append_faults(Source::open(look.default_source), problems);
    if (look.default_signal)
        if (const std::string file = file_of(*look.default_signal); !file.empty())
            append_faults(load_signal_media(file), problems);
    for (Diagnostic& problem : problems)
        if (problem.file.empty())  // a test pattern's
            problem.file = look.manifest;
    return problems;
}

namespace {
constexpr std::string_view pattern = "pattern:";
constexpr std::string_view solid = "solid:";
}  // namespace

std::optional<std::string_view> made_name(std::string_view choice) {
    for (const std::string_view prefix : {pattern, solid})
        if (choice.starts_with(prefix))
            return choice.substr(prefix.size());
    return std::nullopt;
}

Result<Picture> made_picture(const std::string& name) {
    if (name.starts_with(pattern))
        return make_pattern(std::string_view(name).substr(pattern.size()));
    assert(name.starts_with(solid));
    return make_solid(std::string_view(name).substr(solid.size()));
}

Result<std::optional<Picture>> load_image(const Image& image, Diagnostics& warnings) {
    if (image.file.empty() && image.made.empty())
        return std::optional<Picture>();
    auto picture = image.made.empty() ? load_picture(image.file) : made_picture(image.made);
    if (picture)
        return std::optional(std::move(*picture));
    if (image.is_needed)
        return fail(picture.error());
    for (Diagnostic& reason : picture.error()) {
        reason.severity = Severity::warning;
        reason.message += "; '" + image.name + "' reads black";
        warnings.push_back(std::move(reason));
    }
    return std::optional<Picture>();
}
