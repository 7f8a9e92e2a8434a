#include "lab/heavy_pass.h"

#include "lab/lab.h"

#include <fmt/format.h>

std::optional<std::size_t> heavy_pass(const PassTimes& times) {
    constexpr std::size_t enough_frames = 4;
    constexpr double most_milliseconds = 100000.0;  // nobody would wait for it
    const std::size_t frames = times.frames();
    if (frames < enough_frames)
        return std::nullopt;
    for (std::size_t pass = 0; pass < times.passes(); ++pass) {
        std::size_t heavy = 0;
        for (std::size_t frame = frames - enough_frames; frame < frames; ++frame) {
            const double time = times.milliseconds(pass, frame);
            heavy += time > heavy_pass_milliseconds && time < most_milliseconds ? 1U : 0U;
        }
        if (heavy == enough_frames)
            return pass;
    }
    return std::nullopt;
}

ChoiceList heavy_pass_choices(const Pass& pass, const PictureSize& size) {
    ChoiceList list{"Heavy pass"};
    if (handed_on(pass))
        list.choices.push_back(
            {.name = fmt::format("Bypass {}", pass.name),
             .deeds = {[name = pass.name](Lab& lab) {
                 lab.switch_pass(PassSwitch::bypass, name);
                 lab.messages().say(fmt::format(
                     "Bypassed \"{}\". Right-click it in the pass strip to undo this.", name));
             }}});
    if (const auto half = size.halved())
        list.choices.push_back({.name = "Halve render size",
                                .deeds = {[half = *half](Lab& lab) { use_half_size(lab, half); }}});
    return list;
}

void use_half_size(Lab& lab, const PictureSize& half) {
    lab.size().choose(half);
    lab.messages().say("Render size halved. Change it in View > Render size.");
}
