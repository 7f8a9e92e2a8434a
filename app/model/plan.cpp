#include "model/plan.h"

#include "model/expression.h"
#include "model/parameter_use.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

Look with_overrides(Look look, const PassOverrides& overrides) {
    for (Pass& pass : look.passes) {
        const auto own = overrides.find(pass.name);
        if (own != overrides.end()) {
            if (own->second.format) {
                pass.format = *own->second.format;
                pass.one_channel.clear();
            }
            if (own->second.scale)
                pass.size.fill({Side::By::viewport, *own->second.scale, {}});
        }
        for (Input& input : pass.inputs) {
            const auto read = overrides.find(input.name);
            if (input.from == Input::From::pass && read != overrides.end())
                input.sampler.filter = read->second.filter.value_or(input.sampler.filter);
        }
    }
    return look;
}

namespace {
struct Measures {
    Extent viewport;
    Extent source;
    std::map<std::string, double> values;  // of all parameters

    // What an expression of a pass may speak of: in a stack the parameters of its own look.
    std::map<std::string, double> names_for(const Pass& pass) const {
        std::map<std::string, double> names{{"WIDTH", viewport.width}, {"HEIGHT", viewport.height}};
        for (const auto& [name, value] : values)
            if (name.starts_with(pass.scope))
                names[name.substr(pass.scope.size())] = value;
        return names;
    }
};

/// What a side may be measured by, px.
struct Lengths {
    int viewport;
    int source;
    int before;
};

Result<double> length_of(const Side& side, const Lengths& of, const Pass& pass,
                         const Measures& measures) {
    switch (side.by) {
        case Side::By::viewport:
            return of.viewport * side.factor;
        case Side::By::source:
            return of.source * side.factor;
        case Side::By::before:
            return of.before * side.factor;
        case Side::By::pixels:
            return side.factor;
        case Side::By::expression:
            return evaluate(side.expression, measures.names_for(pass));
    }
    return 0.0;
}

Result<Extent> extent_of(const Pass& pass, const Extent& source, const Extent& before,
                         const Measures& measures, int largest_side) {
    const auto width = length_of(
        pass.size[0], {measures.viewport.width, source.width, before.width}, pass, measures);
    const auto height = length_of(
        pass.size[1], {measures.viewport.height, source.height, before.height}, pass, measures);
    for (const auto* length : {&width, &height})
        if (!*length)
            return fail(
                {pass.declared.file, pass.declared.line,
                 fmt::format("size of pass '{}': {}", pass.name, length->error().front().message)});
    const double most = largest_side + 0.5;  // before rounding
    if (!(*width > 0.0 && *width<most&& * height> 0.0 && *height < most))
        return fail({pass.declared.file, pass.declared.line,
                     fmt::format("pass '{}' would be {} x {} px; a side is 1 to {} px", pass.name,
                                 *width, *height, largest_side)});
    return Extent{std::max(1, static_cast<int>(std::lround(*width))),
                  std::max(1, static_cast<int>(std::lround(*height)))};
}

Result<Format> format_of(const Pass& pass, const Measures& measures) {
    if (pass.one_channel.empty())
        return pass.format;
    const auto is_one = evaluate(pass.one_channel, measures.names_for(pass));
    if (!is_one)
        return fail({pass.declared.file, pass.declared.line,
                     fmt::format("\"one_channel\" of pass '{}': {}", pass.name,
                                 is_one.error().front().message)});
    return *is_one > 0.0 ? one_channel_of(pass.format).value_or(pass.format) : pass.format;
}

Measures measures_of(const Look& look, Extent viewport, Extent source, const Values& values) {
    Measures measures{viewport, source, {}};
    for (const Parameter& parameter : look.parameters)
        measures.values[parameter.name] = value_of(parameter, values).number();
    return measures;
}
}  // namespace

Extent source_extent_of(const Look& look, const Pass& pass, const Plan& plan, Extent source) {
    const auto read = pass.source.empty() ? std::nullopt : find_pass(look, pass.source);
    const bool is_planned = read && static_cast<std::size_t>(*read) < plan.targets.size();
    return is_planned ? plan.targets[static_cast<std::size_t>(*read)].extent : source;
}

Result<Plan> plan_targets(const Look& look, Extent viewport, Extent source, const Values& values,
                          int largest_side) {
    Plan plan;
    const Measures measures = measures_of(look, viewport, source, values);
    for (std::size_t i = 0; i < look.passes.size(); ++i) {
        const Pass& pass = look.passes[i];
        const Extent read = source_extent_of(look, pass, plan, source);
        const bool is_first = i == 0 || look.passes[i - 1].scope != pass.scope;
        const auto extent = extent_of(pass, read, is_first ? read : plan.targets.back().extent,
                                      measures, largest_side);
        if (!extent)
            return fail(extent.error());
        const auto format = format_of(pass, measures);
        if (!format)
            return fail(format.error());
        plan.targets.push_back({*extent, *format});
    }
    for (const Pass& pass : look.passes) {
        for (const Input& input : pass.inputs) {
            if (input.from == Input::From::source)
                plan.source_slots = std::max(plan.source_slots, input.frames_ago + 1);
            const auto read = find_pass(look, input.name);
            if (input.from != Input::From::pass || !read)
                continue;
            PlannedTarget& target = plan.targets[static_cast<std::size_t>(*read)];
            target.slots = std::max(target.slots, input.frames_ago + 1);
            const bool has_levels =
                !facts_of(target.format).is_integer;  // their mean would be none
            target.mipmapped = target.mipmapped || (input.sampler.mipmap && has_levels);
        }
    }
    return plan;
}

namespace {
double bytes_of(const PlannedTarget& target) {
    return static_cast<double>(target.extent.width) * target.extent.height *
           facts_of(target.format).bytes;
}
}  // namespace

std::size_t memory_of(const PlannedTarget& target) {
    const double levels = target.mipmapped ? 4.0 / 3.0 : 1.0;
    return static_cast<std::size_t>(bytes_of(target) * target.slots * levels);
}

std::size_t memory_of(const Plan& plan) {
    std::size_t bytes = 0;
    for (const PlannedTarget& target : plan.targets)
        bytes += memory_of(target);
    return bytes;
}

namespace {
bool is_driven(const Look& look, std::size_t pass, const std::vector<std::string>& parameters) {
    const Pass& read = look.passes[pass];
    return std::ranges::any_of(parameters, [&](const std::string& name) {
        // How many samples there are does not change what they are samples of.
        if (read.accumulate && (read.repeat == Count(name) || read.converge == Count(name)))
            return false;
        const Parameter* parameter = find_parameter(look, name);
        return parameter && is_used_by(look, pass, *parameter);
    });
}
}  // namespace

std::vector<bool> reached_from(const Look& look, std::vector<bool> changed) {
    for (std::size_t i = 0; i < look.passes.size(); ++i)
        for (const Input& input : look.passes[i].inputs) {
            const auto read = find_pass(look, input.name);
            if (input.from == Input::From::pass && input.frames_ago == 0 && read &&
                static_cast<std::size_t>(*read) < i && changed[static_cast<std::size_t>(*read)])
                changed[i] = true;
        }
    return changed;
}

Redraw redraw_after(const Look& look, const std::vector<std::string>& parameters) {
    std::vector<bool> driven;
    for (std::size_t i = 0; i < look.passes.size(); ++i)
        driven.push_back(is_driven(look, i, parameters));
    return redraw_of(look, std::move(driven));
}

Redraw redraw_of(const Look& look, std::vector<bool> changed) {
    Redraw redraw{reached_from(look, std::move(changed))};
    for (std::size_t i = 0; i < look.passes.size(); ++i) {
        redraw.needs_replay =
            redraw.needs_replay || (redraw.passes[i] && look.passes[i].accumulate);
        for (const Input& input : look.passes[i].inputs) {
            const auto read = find_pass(look, input.name);
            if (input.from == Input::From::pass && input.frames_ago > 0 && read)
                redraw.needs_replay =
                    redraw.needs_replay || redraw.passes[static_cast<std::size_t>(*read)];
        }
    }
    return redraw;
}

std::vector<bool> needed_for(const Look& look, int pass) {
    std::vector<bool> needed(look.passes.size(), false);
    std::vector<int> open{pass};
    while (!open.empty()) {
        const auto current = static_cast<std::size_t>(open.back());
        open.pop_back();
        if (needed[current])
            continue;
        needed[current] = true;
        for (const Input& input : look.passes[current].inputs)
            if (const auto read = find_pass(look, input.name);
                input.from == Input::From::pass && read)
                open.push_back(*read);
    }
    return needed;
}

std::vector<bool> carried_passes(const Look& look) {
    std::vector<bool> carried(look.passes.size(), false);
    const auto add = [&](int pass) {
        const std::vector<bool> needed = needed_for(look, pass);
        for (std::size_t i = 0; i < needed.size(); ++i)
            carried[i] = carried[i] || needed[i];
    };
    for (std::size_t i = 0; i < look.passes.size(); ++i) {
        if (look.passes[i].accumulate)
            add(static_cast<int>(i));
        for (const Input& input : look.passes[i].inputs)
            if (const auto read = find_pass(look, input.name);
                input.from == Input::From::pass && input.frames_ago > 0 && read)
                add(*read);
    }
    return carried;
}
