#include "ui/library/preset_filter.h"

#include "ui/widgets/icons.h"
#include "ui/widgets/theme.h"

void draw_preset_search(const SearchBox& box, const PresetBrowsing& wanted, Edits& edits) {
    std::string search = wanted.search;
    if (draw_search_box(box, search, edits))
        edits.arrange([search](WindowState& window) { window.presets.search = search; });
}

void draw_star_filter(const char* mark, const PresetBrowsing& wanted, Edits& edits) {
    const bool is_on = wanted.only_starred;
    if (icon_button("##only_starred", is_on ? Icon::star : Icon::star_outline,
                    is_on
                        ? "Only favourites are shown, also for the previous and next preset keys. "
                          "Click to show all presets."
                        : "Show only favourites. The previous and next preset keys then skip "
                          "other presets.",
                    is_on ? theme::accent : theme::label))
        edits.arrange([is_on](WindowState& window) { window.presets.only_starred = !is_on; });
    edits.mark(mark);
}

std::string why_no_preset(const PresetBrowsing& wanted) {
    if (!wanted.search.empty())
        return "No matches.";
    return "No favourites yet. Hover over a preset and click its star.";
}
