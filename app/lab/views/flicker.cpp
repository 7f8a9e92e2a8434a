#include "lab/views/flicker.h"

#include "lab/frame/workspace.h"
#include "lab/window/window_state.h"
#include "model/look/subframe.h"

namespace {
MenuEntry answer(const char* name, Flicker flicker) {
    return {.name = name,
            .commands = {[flicker](WindowState& window) { window.flashes.flicker = flicker; }}};
}

bool would_flicker(const Workspace& work) {
    return work.document && work.player.transport().is_playing() &&
           work.display.most_subframes() > 1 &&
           subframes_of(work.document->look(), work.document->values()) > 1;
}
}  // namespace

void follow_flicker(Workspace& work, FlashDisplay& flashes) {
    constexpr const char* subject = "flicker";
    work.draws_subframes = flashes.flicker == Flicker::allowed && !flashes.limit.is_on;
    if (flashes.flicker != Flicker::not_asked)
        return work.messages.withdraw(subject);
    if (would_flicker(work) && !work.messages.notice())
        work.messages.ask(
            "This look draws sub-frames, so the display flickers. Flicker can cause seizures in "
            "people with photosensitive epilepsy.",
            {answer("Allow flicker", Flicker::allowed), answer("Keep it steady", Flicker::refused)},
            subject);
}
