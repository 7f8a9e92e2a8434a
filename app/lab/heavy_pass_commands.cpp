#include "lab/frame/heavy_pass.h"
#include "lab/lab.h"

#include <fmt/format.h>

ChoiceList heavy_pass_choices(const Pass& pass, const PictureSize& size) {
    ChoiceList list{"Heavy pass"};
    if (passed_input(pass))
        list.choices.push_back(
            {.name = fmt::format("Bypass {}", pass.name),
             .commands = {[name = pass.name](Lab& lab) {
                 lab.frames().passes().toggle(PassSwitch::bypass, name);
                 lab.messages().say(fmt::format(
                     "Bypassed \"{}\". Right-click it in the pass strip to undo this.", name));
             }}});
    if (const auto half = size.halved())
        list.choices.push_back({.name = "Halve render size", .commands = {[half = *half](Lab& lab) {
                                                                 use_half_size(lab, half);
                                                             }}});
    return list;
}

void use_half_size(Lab& lab, const PictureSize& half) {
    lab.work().size.choose(half);
    lab.messages().say("Render size halved. Change it in View > Render size.");
}
