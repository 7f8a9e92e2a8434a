#include "ui/content_lock.h"

#include "lab/users_content.h"
#include "ui/icons.h"
#include "ui/theme.h"
#include "ui/widgets.h"

#include <fmt/format.h>

void draw_content_heading(const std::string& text, const Scene& scene, Edits& edits) {
    const Document& document = *scene.lab.document();
    const bool is_locked = document.is_content_locked();
    const std::string word = content_word(document.look());
    heading_with_button(text);
    const std::string help =
        is_locked
            ? fmt::format(
                  "Presets and looks keep this {0}. Click to let presets change the "
                  "{0}.\nAlt+click a preset to open it with its own {0}.",
                  word)
            : fmt::format("Keep my {0}\nPresets and looks then leave the {0} as it is.", word);
    if (icon_button("##keep_content", is_locked ? Icon::pinned : Icon::unpinned, help,
                    is_locked ? theme::accent : theme::label))
        edits.document([is_locked](Document& changed) { changed.lock_content(!is_locked); });
    edits.mark("keep_content");
}
