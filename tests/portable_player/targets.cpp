#include "portable_player/targets.h"

#include "portable_player/error.h"

#include <algorithm>
#include <cmath>

namespace {
/// Sizes that a length may refer to.
struct References {
    Size view;
    Size source;
    Size previous;
};

int pixels_of(const Length& length, std::size_t side, const Pass& pass, const Values& values,
              const References& references) {
    double pixels = 0.0;
    if (!length.expression.empty())
        pixels = values.evaluated(length.expression, pass, references.view);
    else if (length.of == "viewport")
        pixels = references.view[side] * length.factor;
    else
        pixels =
            (length.of == "source" ? references.source : references.previous)[side] * length.factor;
    if (!(pixels > 0.0 && pixels < 16384.5))
        throw Error("pass '" + pass.name + "' has a side of " + std::to_string(pixels) + " pixels");
    return std::max(static_cast<int>(std::lround(pixels)), 1);
}

bool is_above_0(const std::string& expression, const Pass& pass, const Values& values,
                const Size& view) {
    return !expression.empty() && values.evaluated(expression, pass, view) > 0.0;
}

std::string format_of(const Pass& pass, const Values& values, const Size& view) {
    std::string format = pass.format;
    if (is_above_0(pass.one_channel, pass, values, view))
        format = one_channel_of(format);
    if (is_above_0(pass.half_floats, pass, values, view))
        format = half_floats_of(format);
    return format;
}

/// What the readers of a target need.
struct Use {
    int slots = 1;
    bool is_mipmapped = false;
};

Use use_of(const Description& description, std::size_t pass) {
    Use use;
    for (std::size_t i = 0; i < description.passes.size(); ++i)
        for (const Input& input : description.passes[i].inputs)
            if (input.from == "pass" && description.pass_named(input.name) == pass) {
                use.slots = std::max(use.slots, frames_ago(description, i, input) + 1);
                use.is_mipmapped = use.is_mipmapped || input.sampler.is_mipmapped;
            }
    return use;
}

// Only targets of the same size and format are shared.
void share_targets(const Description& description, const Values& values, const Size& view,
                   const std::vector<std::string>& formats, std::vector<Target>& targets) {
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const Pass& pass = description.passes[i];
        if (pass.onto.empty() || !is_above_0(pass.where, pass, values, view))
            continue;
        const std::size_t host = description.pass_named(pass.onto);
        if (targets[i].size == targets[host].size && formats[i] == formats[host])
            targets[i].host = host;
    }
}
}  // namespace

int frames_ago(const Description& description, std::size_t reader, const Input& input) {
    if (input.frames_ago > 0)
        return input.frames_ago;
    return description.pass_named(input.name) >= reader ? 1 : 0;
}

Size source_size(const Description& description, const Pass& pass,
                 const std::vector<Target>& targets, const Size& source) {
    return pass.source.empty() ? source : targets[description.pass_named(pass.source)].size;
}

std::vector<Target> make_targets(const Description& description, const Values& values,
                                 const Size& view, const Size& source) {
    std::vector<Target> targets;
    std::vector<std::string> formats;
    for (const Pass& pass : description.passes) {
        const Size read = source_size(description, pass, targets, source);
        const bool is_first =
            targets.empty() || description.passes[targets.size() - 1].scope != pass.scope;
        const References references{view, read, is_first ? read : targets.back().size};
        Target target;
        target.host = targets.size();
        target.size = {pixels_of(pass.width, 0, pass, values, references),
                       pixels_of(pass.height, 1, pass, values, references)};
        targets.push_back(std::move(target));
        formats.push_back(format_of(pass, values, view));
    }
    share_targets(description, values, view, formats, targets);
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const Use use = use_of(description, i);
        const Size size = targets[i].host == i ? targets[i].size : Size{1, 1};
        for (int slot = 0; slot < use.slots; ++slot)
            targets[i].slots.emplace_back(size, formats[i], use.is_mipmapped);
    }
    return targets;
}

std::vector<std::size_t> drawing_order(const std::vector<Target>& targets) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        if (targets[i].host != i)
            continue;
        order.push_back(i);
        for (std::size_t guest = 0; guest < targets.size(); ++guest)
            if (guest != i && targets[guest].host == i)
                order.push_back(guest);
    }
    return order;
}

bool is_drawn_onto(const Description& description, const std::vector<Target>& targets,
                   std::size_t pass) {
    const auto has_guest = [&](std::size_t host) {
        for (std::size_t i = 0; i < targets.size(); ++i)
            if (i != host && targets[i].host == host)
                return true;
        return false;
    };
    return has_guest(pass) ||
           std::ranges::any_of(description.passes[pass].inputs, [&](const Input& input) {
               return input.from == "pass" && has_guest(description.pass_named(input.name));
           });
}
