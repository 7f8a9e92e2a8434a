#include "ui/passes/strip_blocks.h"

#include "lab/previews/previews.h"
#include "model/look/own_name.h"
#include "model/look/pass_levels.h"
#include "model/plan/parameter_use.h"
#include "ui/passes/strip_layout.h"
#include "ui/passes/strip_text.h"
#include "ui/picture/pass_switch_items.h"
#include "ui/widgets/scoped.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace {
// Switched by the user. Passes after a stop are "not drawn" and do not count.
bool is_switched(const StripPass& pass) {
    return !pass.state.empty() && pass.state != "not drawn";
}

std::string number_of(const StripPass& level) {
    return level.pass.name.substr(name_without_number(level.pass.name).size());
}

// Own names of the passes that do not begin with `name`, so without its pyramid levels.
std::vector<std::string> others_than(const std::string& name, std::span<const StripPass> all) {
    std::vector<std::string> others;
    for (const StripPass& other : all)
        if (!other.pass.name.starts_with(name))
            others.push_back(own_name(other.pass.name));
    return others;
}

ElidedName pyramid_name(std::span<const StripPass> levels, std::span<const StripPass> all) {
    const std::string stem = name_without_number(levels.front().pass.name);
    return elided_name(own_name(stem), number_of(levels.front()), number_of(levels.back()),
                       others_than(stem, all));
}

bool is_louder(const TargetLevel& gain, const TargetLevel& other) {
    return std::pair(gain.clipped, gain.peak) > std::pair(other.clipped, other.peak);
}

// For a pyramid: the total time, and the highest of the other values.
StripText text_of_pyramid(std::span<const StripPass> levels, std::span<const StripPass> all) {
    StripText text{pyramid_name(levels, all),
                   strip_text::info(levels.front().target, levels.back().target)};
    for (const StripPass& level : levels) {
        text.milliseconds += level.milliseconds;
        text.longest = std::max(text.longest, level.milliseconds);
        if (level.gain && (!text.gain || is_louder(*level.gain, *text.gain)))
            text.gain = level.gain;
        if (level.change &&
            (!text.change || change_share(*level.change) > change_share(*text.change)))
            text.change = level.change;
    }
    return text;
}

// An inspected level of a pyramid shows its own text instead of that of the pyramid.
StripText text_of(std::span<const StripPass> passes, std::span<const StripPass> all) {
    const auto chosen = std::ranges::find(passes, true, &StripPass::is_chosen);
    if (passes.size() > 1 && chosen == passes.end())
        return text_of_pyramid(passes, all);
    const StripPass& shown = passes.size() > 1 ? *chosen : passes.front();
    return {.name = elided_name(own_name(shown.pass.name), others_than(shown.pass.name, all)),
            .info = strip_text::info(shown.target),
            .milliseconds = shown.milliseconds,
            .longest = shown.milliseconds,
            .gain = shown.gain,
            .change = shown.change,
            .is_chosen = shown.is_chosen};
}

// The common state of all passes, or that of the first switched one.
std::string state_of(std::span<const StripPass> passes) {
    const std::string& first = passes.front().state;
    if (std::ranges::all_of(passes, [&](const StripPass& pass) { return pass.state == first; }))
        return first;
    const auto switched = std::ranges::find_if(passes, is_switched);
    const StripPass& shown = switched != passes.end() ? *switched : passes.back();
    return number_of(shown) + " " + shown.state;
}

std::vector<StripBlock> blocks_of(std::span<const StripPass> passes) {
    std::vector<SizedName> sized;
    for (const StripPass& pass : passes)
        sized.push_back({pass.pass.name, pass.target.extent});
    std::vector<StripBlock> blocks;
    std::size_t first = 0;
    for (const std::size_t count : count_levels(sized)) {
        const auto own = passes.subspan(first, count);
        blocks.push_back({own, text_of(own, passes), state_of(own)});
        first += count;
    }
    return blocks;
}

float text_width(const std::string& text) {
    return ImGui::CalcTextSize(text.c_str()).x;
}

// Width of the name, up to a limit, and the time. It does not depend on the time.
float text_width_of(const StripText& text, const Scene& scene) {
    const float longest = ImGui::GetFontSize() * 11.0f;
    const float gap = strip_gap();
    const float name = std::min(text_width(text.name.front + text.name.end), longest);
    const ScopedFont font(scene.fonts.numbers);
    const float time = text_width("00.00 ms");
    return std::max(name + time + gap, text_width(text.info));
}

float image_width(std::span<const StripPass> passes, const Scene& scene) {
    int widest = 0;
    for (const StripPass& pass : passes)
        widest = std::max(widest, scene.views.strip().thumbnail(pass.index).extent.width);
    return static_cast<float>(widest) / scene.density;
}

float gain_width(const Scene& scene) {
    const ScopedFont font(scene.fonts.numbers);
    return text_width("peak 00.0, 0.0 % clipped");
}

AskedWidth asked_by(const StripBlock& block, float text_size, float each, const Scene& scene) {
    const float minimum = std::floor(ImGui::GetFontSize() * 4.8f);
    const float picture = std::ceil(image_width(block.passes, scene));
    if (block.is_pass())
        return {.minimum = std::max(picture, minimum),
                .wanted = std::max({picture, minimum, std::ceil(text_size)}),
                .best = std::min(std::ceil(gain_width(scene)), each)};
    const auto count = static_cast<float>(block.passes.size());
    const float a_level = std::floor(ImGui::GetFontSize() * 0.8f);
    AskedWidth asked{.minimum = std::max(count * a_level, minimum), .is_pass = false};
    asked.wanted = std::max(asked.minimum, count * picture);
    return asked;
}

void share_room(std::vector<StripBlock>& blocks, float room, const Scene& scene) {
    const auto count = static_cast<float>(blocks.size());
    room -= strip_gap() * (count - 1.0f);
    std::vector<AskedWidth> asked;
    std::vector<float> text_widths;
    for (const StripBlock& block : blocks) {
        text_widths.push_back(text_width_of(block.text, scene));
        asked.push_back(asked_by(block, text_widths.back(), std::floor(room / count), scene));
    }
    const StripWidths shared = strip_widths(asked, room);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        StripBlock& block = blocks[i];
        const auto levels = static_cast<float>(block.passes.size());
        block.width = std::floor(shared.widths[i] / levels) * levels;
        block.is_narrow = block.is_pass() ? shared.is_narrow : block.width < text_widths[i];
    }
}
}  // namespace

std::vector<StripPass> present_passes(const Scene& scene) {
    const Renderer& renderer = *scene.lab.renderer;
    const Look& look = renderer.executor().look();
    const std::vector<PlannedTarget>& targets = renderer.executor().plan().targets;
    const std::vector<double>& times = renderer.times().pass_milliseconds();
    const auto& changes = scene.lab.frames.previews().probe().changes();
    std::vector<StripPass> passes;
    for (std::size_t i = 0; i < std::min(look.passes.size(), targets.size()); ++i) {
        const StripPass pass{
            .index = i,
            .pass = look.passes[i],
            .target = targets[i],
            .milliseconds = i < times.size() ? times[i] : 0.0,
            .gain = scene.views.strip().gain(i),
            .change = i < changes.size() ? changes[i] : std::nullopt,
            .is_chosen = look.passes[i].name == scene.window.views.inspected.pass,
            .state = pass_switch_text(i, look, scene.lab.frames.passes().switches())};
        if (pass.is_chosen || is_switched(pass) || !is_idle(look, i, targets[i].extent))
            passes.push_back(pass);
    }
    return passes;
}

std::vector<StripBlock> arrange_strip(std::span<const StripPass> passes, float room,
                                      const Scene& scene) {
    std::vector<StripBlock> blocks = blocks_of(passes);
    share_room(blocks, room, scene);
    return blocks;
}

float strip_gap() {
    return ImGui::GetFontSize() * 0.6f;
}
