#include "lab/views/list_thumbnails.h"

#include "lab/document/content_edits.h"
#include "lab/lab.h"

namespace {
// Whether frames leave time to draw small pictures besides. It stays so until frames take much
// longer, because drawing them slows down frames a little. Without GPU times, it is unknown.
bool has_time_left(const Lab& lab, bool had_time) {
    const double longest_seconds = had_time ? 0.012 : 0.004;
    if (!lab.renderer() || !lab.renderer()->has_drawn() || lab.loader().is_loading())
        return false;
    const FrameTimes& times = lab.renderer()->times();
    return times.gpu_seconds() > 0.0 && times.gpu_seconds() < longest_seconds &&
           times.frame_seconds() < longest_seconds;
}
}  // namespace

void ListThumbnails::update(const Lab& lab, Views& views, const WindowState& window,
                            const LibraryView& library, double wall_seconds) {
    using Use = PresetThumbnails::Use;
    const bool are_own = window.presets.shows_own_content && lab.document();
    const auto own_content = [&] {
        Content content = content_of(*lab.document());
        if (driver_of(*lab.document()) == Driver::signal)
            content.source.clear();  // use_content() then drives each look by the signal
        return content;
    };
    const bool is_listed = window.layout.sees(panel_id::library);
    has_time = has_time_left(lab, has_time);
    history.update(lab, views);
    const Use use = window.layout.sees(panel_id::presets) || (is_listed && has_time) ? Use::drawn
                    : is_listed                                                      ? Use::cached
                                                                                     : Use::hidden;
    presets.update(lab, use, wall_seconds, are_own ? std::optional(own_content()) : std::nullopt);
    looks.read();
    if (is_listed)
        looks.draw(lab.work().library, library.looks(), has_time, wall_seconds);
}
