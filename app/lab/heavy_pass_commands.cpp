#include "lab/frame/heavy_pass.h"
#include "lab/lab.h"

#include <fmt/format.h>

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
             .commands = {[half = *half](RenderSize& size, Messages& messages) {
                 use_half_size(size, messages, half);
             }}});
    return section;
}

void use_half_size(RenderSize& size, Messages& messages, const PictureSize& half) {
    size.choose(half);
    messages.say("Render size halved. Change it in View > Render size.");
}
