// The part of Lab that offers to do what it does not do by itself.
#include "lab/lab.h"

#include <fmt/format.h>

void Lab::offer_outside(const OutsideContent& content) {
    const auto use = [content](Lab& lab) {
        lab.messages().dismiss();
        lab.edit([&content](Document& document) {
            if (content.source.empty() && content.signal)
                document.set_signal(*content.signal);
            else if (!content.source.empty())
                document.set_source(content.source);
            if (!content.files.empty())
                document.set_values(content.files, "Use the preset's files");
        });
        for (const auto& [name, value] : content.files)
            lab.drive().recent().remember(value.path, {});
    };
    m_messages.ask(content.notice(),
                   {Choice{.name = content.count() == 1 ? "Use it" : "Use them", .deeds = {use}}});
}

// Content that the preset brings: one click away while the user's own is locked, else asked for
// where it lies outside. Files that its values choose are asked for in either case.
void Lab::offer_content(const CheckedPreset& checked) {
    const bool is_locked = m_document->is_content_locked();
    if (checked.outside && (!is_locked || !checked.outside->files.empty())) {
        OutsideContent asked = *checked.outside;
        if (is_locked)
            asked = {.files = std::move(asked.files)};
        return offer_outside(asked);
    }
    if (!is_locked)
        return;
    Preset whole = checked.preset;
    if (checked.outside) {
        whole.signal = checked.outside->signal;
        whole.source = checked.outside->source;
    }
    offer_own_content(whole);
}
