#include "lab/views/list_thumbnails.h"

#include "lab/document/content_edits.h"
#include "lab/lab.h"

void ListThumbnails::update(const Lab& lab, Views& views, const WindowState& window,
                            double wall_seconds) {
    const bool are_own = window.presets.shows_own_content && lab.document();
    history.update(lab, views);
    presets.update(lab, window.layout.sees(panel_id::presets), wall_seconds,
                   are_own ? std::optional(content_of(*lab.document())) : std::nullopt);
}
