#include "lab/frame/heavy_pass.h"

#include "lab/frame/pass_control.h"
#include "lab/media/render_size.h"
#include "lab/messages/messages.h"

#include <fmt/format.h>

std::optional<std::size_t> heavy_pass(const PassTimes& times) {
    constexpr std::size_t enough_frames = 4;
    constexpr double max_milliseconds = 100000.0;  // times above are not plausible
    const std::size_t frames = times.frames();
    if (frames < enough_frames)
        return std::nullopt;
    for (std::size_t pass = 0; pass < times.passes(); ++pass) {
        std::size_t heavy = 0;
        for (std::size_t frame = frames - enough_frames; frame < frames; ++frame) {
            const double time = times.milliseconds(pass, frame);
            heavy += time > heavy_pass_milliseconds && time < max_milliseconds ? 1U : 0U;
        }
        if (heavy == enough_frames)
            return pass;
    }
    return std::nullopt;
}

MenuSection heavy_pass_section(const Pass& pass, const PictureSize& size) {
    MenuSection section{"Heavy pass"};
    if (passed_input(pass))
        section.entries.push_back(
            {.name = fmt::format("Bypass {}", pass.name),
             .commands = {[name = pass.name](PassControl& passes, Messages& messages) {
                 passes.toggle(PassSwitch::bypass, name);
                 messages.say(fmt::format(
                     "Bypassed \"{}\". Right-click it in the pass strip to undo this.", name));
             }}});
    if (const auto half = size.halved())
        section.entries.push_back(
            {.name = "Halve render size",
             .commands = {[half = *half](RenderSize& changed, Messages& messages) {
                 use_half_size(changed, messages, half);
             }}});
    return section;
}

void use_half_size(RenderSize& size, Messages& messages, const PictureSize& half) {
    size.choose(half);
    messages.say("Render size halved. Change it in View > Render size.");
}
