#include "formats/effect/effect_limits.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
constexpr const char* alternative = "Export it with --to web or --to portable.";

std::string obstacle_in(const Input& input, const EffectHost& host) {
    if (input.from == Input::From::keyboard)
        return "reads the keyboard";
    if (input.from == Input::From::sound)
        return "reads a sound";
    if (input.frames_ago > 0 && !host.has_feedback)
        return "reads the previous frame";
    if (input.frames_ago > host.most_frames_ago)
        return host.most_frames_ago == 1
                   ? "reads a picture from more than one frame ago"
                   : fmt::format("reads a picture from {} frames ago", input.frames_ago);
    if (input.from == Input::From::image && !host.has_images)
        return "reads a picture file";
    return {};
}

std::string obstacle_in(const Pass& pass, const EffectHost& host) {
    if (is_of_beam(pass.draw))
        return "draws a beam";
    if (pass.accumulate || pass.converge)
        return "accumulates samples over many frames";
    if (pass.repeat != Count(1))
        return "is drawn several times per frame";
    if (pass.blend == Blend::alpha)
        return "blends with transparency";
    if (info_of(pass.format).is_integer && !host.has_integers)
        return "stores whole numbers";
    for (const Input& input : pass.inputs)
        if (std::string found = obstacle_in(input, host); !found.empty())
            return found;
    return {};
}
}  // namespace

std::string effect_obstacle(const Look& look, const EffectHost& host) {
    const bool has_beam =
        std::ranges::any_of(look.passes, [](const Pass& pass) { return is_of_beam(pass.draw); });
    if (has_beam && look.has_other_driver)
        return fmt::format(
            "a beam draws a signal, which {} can't do. Use a source picture (--source or a preset "
            "with one), --to web or --to portable.",
            host.name);
    for (const Pass& pass : look.passes)
        if (const std::string found = obstacle_in(pass, host); !found.empty())
            return fmt::format("the pass '{}' {}, which {} can't do. {}", pass.name, found,
                               host.name, alternative);
    if (look.has_orbit)
        return fmt::format("it shows an object that can be rotated, which {} can't do. {}",
                           host.name, alternative);
    for (const Image& image : look.images)
        if (image.shape != PictureShape::flat)
            return fmt::format("the picture '{}' isn't flat, which {} can't read. {}", image.name,
                               host.name, alternative);
    return {};
}
