// The part of Lab that offers to do what it does not do by itself.
#include "lab/lab.h"

#include <fmt/format.h>

void Lab::ask(std::string text, std::vector<Choice> choices) {
    say(std::move(text), true);
    m_notice->choices = std::move(choices);
    m_notice->goes_by = false;
}

void Lab::offer_outside(const OutsideContent& content) {
    const auto use = [content](Lab& lab) {
        lab.put_notice_away();
        lab.edit([&content](Document& document) {
            if (content.source.empty() && content.signal)
                document.set_signal(*content.signal);
            else
                document.set_source(content.source);
        });
    };
    ask(fmt::format("The preset names {}, which lies outside its folder. It is not used.",
                    content.words()),
        {Choice{.name = "Use it", .deeds = {use}}});
}

// Content that the preset brings: one click away while the user's own is locked, else asked for
// where it lies outside.
void Lab::offer_content(const CheckedPreset& checked) {
    if (!m_document->is_content_locked()) {
        if (checked.outside)
            offer_outside(*checked.outside);
        return;
    }
    Preset whole = checked.preset;
    if (checked.outside) {
        whole.signal = checked.outside->signal;
        whole.source = checked.outside->source;
    }
    offer_own_content(whole);
}
