#include "ui/playback/content_lock.h"

#include "lab/document/content_edits.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace {
const char* lock_help(bool is_source, bool is_locked) {
    if (is_source)
        return is_locked ? "Presets and looks keep this source. Click to let presets change it.\n"
                           "Alt+click a preset to open it with its own source."
                         : "Keep my source\nPresets and looks then don't change it.";
    return is_locked ? "Presets and looks keep this signal. Click to let presets change it.\n"
                       "Alt+click a preset to open it with its own signal."
                     : "Keep my signal\nPresets and looks then don't change it.";
}
}  // namespace

void draw_content_heading(const std::string& text, const Scene& scene, Edits& edits) {
    const Document& document = *scene.lab.document;
    const bool is_locked = is_content_locked(document);
    const bool is_source = document.look().driven_by == Driver::picture;
    heading_with_button(text);
    if (icon_button("##keep_content", is_locked ? Icon::pinned : Icon::unpinned,
                    lock_help(is_source, is_locked), is_locked ? theme::accent : theme::label))
        edits.change([is_locked](Document& changed) { lock_content(changed, !is_locked); });
    edits.mark("keep_content");
}
