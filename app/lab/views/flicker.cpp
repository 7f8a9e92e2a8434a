#include "lab/views/flicker.h"

#include "lab/frame/workspace.h"
#include "lab/window/window_state.h"
#include "model/look/subframe.h"

namespace {
MenuEntry answer(const char* name, Flicker flicker) {
    return {.name = name,
            .commands = {[flicker](WindowState& window) { window.flashes.flicker = flicker; }}};
}

bool would_flicker(const Workspace& work, const FlashDisplay& flashes) {
    return work.document && work.player.transport().is_playing() && !flashes.limit.is_on &&
           work.display.most_subframes() > 1 &&
           subframes_of(work.document->look(), work.document->values()) > 1;
}

constexpr const char* subject = "flicker";
}  // namespace

void ask_about_flicker(Messages& messages) {
    messages.ask(
        "This look draws sub-frames, so the display flickers. Flicker can cause seizures in people "
        "with photosensitive epilepsy.",
        {answer("Allow flicker", Flicker::allowed), answer("Keep it steady", Flicker::refused)},
        subject);
}

void follow_flicker(Workspace& work, FlashDisplay& flashes) {
    work.draws_subframes = flashes.flicker == Flicker::allowed && !flashes.limit.is_on;
    if (flashes.flicker != Flicker::not_asked)
        return work.messages.withdraw(subject);
    if (!would_flicker(work, flashes))
        return work.messages.withdraw(subject);
    if (flashes.has_asked || work.messages.notice())
        return;
    flashes.has_asked = true;
    ask_about_flicker(work.messages);
}
