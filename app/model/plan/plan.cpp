#include "model/plan/plan.h"

#include "model/plan/common_pictures.h"
#include "model/plan/expression.h"
#include "model/plan/numbers.h"
#include "model/plan/parameter_use.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

Look with_overrides(Look look, const PassOverrides& overrides) {
    for (Pass& pass : look.passes) {
        const bool shares_changed =
            pass.onto && (overrides.contains(pass.name) || overrides.contains(pass.onto->pass));
        if (shares_changed)
            pass.onto.reset();  // the look did not intend it for an overridden pass
        const auto own = overrides.find(pass.name);
        if (own != overrides.end()) {
            if (own->second.format) {
                pass.format = *own->second.format;
                pass.one_channel.clear();
                pass.half_floats.clear();
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

Look with_kept_light(Look look) {
    Format& format = look.passes.back().format;
    if (format == Format::rgba8 || format == Format::rgb10_a2)
        format = Format::rgba16f;
    return look;
}

namespace {
struct Measures {
    Extent viewport;
    Extent source;
    const Look& look;
    const Values& values;
    mutable std::map<std::string, std::map<std::string, double>> names_of_scopes = {};  // cache

    // The names in expressions of a pass: in a stack the parameters of its own look.
    const std::map<std::string, double>& names_for(const Pass& pass) const {
        const auto [found, is_new] = names_of_scopes.try_emplace(pass.scope);
        std::map<std::string, double>& names = found->second;
        if (!is_new)
            return names;
        names = numbers_of(look, values, pass.scope);
        names["WIDTH"] = viewport.width;
        names["HEIGHT"] = viewport.height;
        return names;
    }
};

/// Reference lengths of a side, px.
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
    const double maximum = largest_side + 0.5;  // before rounding
    if (!(*width > 0.0 && *width<maximum&& * height> 0.0 && *height < maximum))
        return fail({pass.declared.file, pass.declared.line,
                     fmt::format("pass '{}' would be {} x {} px; each side must be 1 to {} px",
                                 pass.name, *width, *height, largest_side)});
    return Extent{std::max(1, static_cast<int>(std::lround(*width))),
                  std::max(1, static_cast<int>(std::lround(*height)))};
}

// Whether an expression of the pass is above 0; an empty one never is.
Result<bool> is_in_force(const std::string& expression, const char* key, const Pass& pass,
                         const Measures& measures) {
    if (expression.empty())
        return false;
    const auto value = evaluate(expression, measures.names_for(pass));
    if (!value)
        return fail(
            {pass.declared.file, pass.declared.line,
             fmt::format("'{}' of pass '{}': {}", key, pass.name, value.error().front().message)});
    return *value > 0.0;
}

Result<Format> format_of(const Pass& pass, const Measures& measures) {
    const auto is_one = is_in_force(pass.one_channel, "one_channel", pass, measures);
    if (!is_one)
        return fail(is_one.error());
    const auto is_half = is_in_force(pass.half_floats, "half_floats", pass, measures);
    if (!is_half)
        return fail(is_half.error());
    const Format format = *is_one ? one_channel_of(pass.format).value_or(pass.format) : pass.format;
    return *is_half ? half_floats_of(format).value_or(format) : format;
}

// 0 if it is not a finite length.
Result<double> spot_length(const Pass& pass, std::size_t axis, int texels,
                           const Measures& measures) {
    if (pass.spot[axis].empty())
        return 1.0 / texels;
    const auto length = evaluate(pass.spot[axis], measures.names_for(pass));
    if (!length)
        return fail(
            {pass.declared.file, pass.declared.line,
             fmt::format("'spot' of pass '{}': {}", pass.name, length.error().front().message)});
    return std::isfinite(*length) ? std::max(*length, 0.0) : 0.0;
}

Result<BeamSpot> spot_in(const Pass& pass, Extent extent, const Measures& measures) {
    const auto across = spot_length(pass, 0, extent.width, measures);
    if (!across)
        return fail(across.error());
    const auto up = spot_length(pass, 1, extent.height, measures);
    if (!up)
        return fail(up.error());
    return BeamSpot{*across, *up};
}

// The pass whose target it shares in this plan.
Result<std::optional<std::size_t>> host_of(const Look& look, std::size_t guest,
                                           const Measures& measures, const PlanTerms& terms) {
    const Pass& pass = look.passes[guest];
    const auto host = pass.onto ? find_pass(look, pass.onto->pass) : std::nullopt;
    if (!host)
        return std::nullopt;
    const auto allowed = is_in_force(pass.onto->where, "onto", pass, measures);
    if (!allowed)
        return fail(allowed.error());
    const auto at = static_cast<std::size_t>(*host);
    if (!*allowed || terms.must_stand_alone(guest) || terms.must_stand_alone(at))
        return std::nullopt;
    return at;
}

Result<void> let_share(const Look& look, const Measures& measures, const PlanTerms& terms,
                       Plan& plan) {
    for (std::size_t i = 0; i < look.passes.size(); ++i) {
        const auto host = host_of(look, i, measures, terms);
        if (!host)
            return fail(host.error());
        if (!*host)
            continue;
        const PlannedTarget& shared = plan.targets[**host];
        if (plan.targets[i].extent == shared.extent && plan.targets[i].format == shared.format)
            plan.targets[i] = {.extent = shared.extent, .format = shared.format, .onto = **host};
    }
    return {};
}

void add_lifetimes(const Look& look, const PlanTerms& terms, Plan& plan) {
    for (std::size_t i = 0; i < look.passes.size(); ++i) {
        for (std::size_t k = 0; k < look.passes[i].inputs.size(); ++k) {
            const Input& input = look.passes[i].inputs[k];
            if (input.from == Input::From::source)
                plan.source_slots = std::max(plan.source_slots, input.frames_ago + 1);
            const auto read = find_pass(look, input.name);
            if (input.from != Input::From::pass || !read || !terms.reads(i, k))
                continue;
            PlannedTarget& target = plan.targets[static_cast<std::size_t>(*read)];
            target.slots = std::max(target.slots, input.frames_ago + 1);
            const bool has_levels = !info_of(target.format).is_integer;  // integers have no mean
            target.mipmapped = target.mipmapped || (input.sampler.mipmap && has_levels);
        }
    }
}
}  // namespace

bool PlanTerms::must_stand_alone(std::size_t pass) const {
    return is_seen(pass) || (pass < kept.size() && kept[pass]);
}

bool PlanTerms::reads(std::size_t pass, std::size_t input) const {
    return !draws_once || pass >= read.size() || input >= read[pass].size() || read[pass][input];
}

Result<BeamSpot> spot_of(const Look& look, const Pass& pass, Extent viewport, Extent extent,
                         const Values& values) {
    return spot_in(pass, extent, Measures{viewport, viewport, look, values});
}

Extent source_extent_of(const Look& look, const Pass& pass, const Plan& plan, Extent source) {
    const auto read = pass.source.empty() ? std::nullopt : find_pass(look, pass.source);
    const bool is_planned = read && static_cast<std::size_t>(*read) < plan.targets.size();
    return is_planned ? plan.targets[static_cast<std::size_t>(*read)].extent : source;
}

Result<Plan> plan_targets(const Look& look, Extent viewport, Extent source, const Values& values,
                          const PlanTerms& terms) {
    Plan plan;
    const Measures measures{viewport, source, look, values};
    for (std::size_t i = 0; i < look.passes.size(); ++i) {
        const Pass& pass = look.passes[i];
        const Extent read = source_extent_of(look, pass, plan, source);
        const bool is_first = i == 0 || look.passes[i - 1].scope != pass.scope;
        const auto extent = extent_of(pass, read, is_first ? read : plan.targets.back().extent,
                                      measures, terms.largest_side);
        if (!extent)
            return fail(extent.error());
        const auto format = format_of(pass, measures);
        if (!format)
            return fail(format.error());
        plan.targets.push_back({*extent, *format});
        if (const auto spot = spot_in(pass, *extent, measures); !spot)
            return fail(spot.error());
    }
    add_lifetimes(look, terms, plan);
    if (auto shared = let_share(look, measures, terms, plan); !shared)
        return fail(shared.error());
    return terms.draws_once ? with_common_pictures(look, std::move(plan), terms) : plan;
}

std::vector<std::size_t> draw_order(const Plan& plan) {
    std::vector<std::size_t> order;
    for (const bool is_last : {false, true})
        for (std::size_t i = 0; i < plan.targets.size(); ++i) {
            if (plan.targets[i].onto || plan.targets[i].is_drawn_last != is_last)
                continue;
            order.push_back(i);
            for (std::size_t guest = 0; guest < plan.targets.size(); ++guest)
                if (plan.targets[guest].onto == i)
                    order.push_back(guest);
        }
    return order;
}

bool is_drawn_onto(const Look& look, const Plan& plan, std::size_t pass) {
    const auto has_guest = [&plan](std::size_t host) {
        return std::ranges::any_of(
            plan.targets, [host](const PlannedTarget& target) { return target.onto == host; });
    };
    return has_guest(pass) ||
           std::ranges::any_of(look.passes[pass].inputs, [&](const Input& input) {
               const auto read = find_pass(look, input.name);
               return input.from == Input::From::pass && read &&
                      has_guest(static_cast<std::size_t>(*read));
           });
}

namespace {
double bytes_of(Extent extent, Format format, bool is_mipmapped) {
    const double levels = is_mipmapped ? 4.0 / 3.0 : 1.0;
    return static_cast<double>(extent.width) * extent.height * info_of(format).bytes * levels;
}
}  // namespace

std::size_t memory_of(const PlannedTarget& target) {
    if (target.onto || target.is_unused)
        return static_cast<std::size_t>(info_of(target.format).bytes);
    const int own = target.slots - (target.common ? 1 : 0);
    return static_cast<std::size_t>(bytes_of(target.extent, target.format, target.mipmapped) * own);
}

std::size_t memory_of(const Plan& plan) {
    std::size_t bytes = 0;
    for (const PlannedTarget& target : plan.targets)
        bytes += memory_of(target);
    for (const CommonPicture& picture : plan.common)
        bytes +=
            static_cast<std::size_t>(bytes_of(picture.extent, picture.format, picture.mipmapped));
    return bytes;
}

namespace {
std::vector<const Parameter*> found_parameters(const Look& look,
                                               const std::vector<std::string>& names) {
    std::vector<const Parameter*> found;
    for (const std::string& name : names)
        if (const Parameter* parameter = find_parameter(look, name))
            found.push_back(parameter);
    return found;
}

bool is_driven(const Look& look, std::size_t pass,
               const std::vector<const Parameter*>& parameters) {
    const Pass& read = look.passes[pass];
    return std::ranges::any_of(parameters, [&](const Parameter* parameter) {
        // The number of samples does not change their content.
        const bool counts_samples = read.accumulate && (read.repeat == Count(parameter->name) ||
                                                        read.converge == Count(parameter->name));
        return !counts_samples && is_used_by(look, pass, *parameter);
    });
}
}  // namespace

std::vector<bool> dependents_of(const Look& look, std::vector<bool> changed) {
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
    const auto found = found_parameters(look, parameters);
    std::vector<bool> driven;
    for (std::size_t i = 0; i < look.passes.size(); ++i)
        driven.push_back(is_driven(look, i, found));
    return redraw_of(look, std::move(driven));
}

Redraw redraw_of(const Look& look, std::vector<bool> changed) {
    Redraw redraw{dependents_of(look, std::move(changed))};
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

std::vector<bool> dependencies_of(const Look& look, int pass) {
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

std::vector<bool> feedback_passes(const Look& look) {
    std::vector<bool> carried(look.passes.size(), false);
    const auto add = [&](int pass) {
        const std::vector<bool> needed = dependencies_of(look, pass);
        for (std::size_t i = 0; i < needed.size(); ++i)
            carried[i] = carried[i] || needed[i];
    };
    for (std::size_t i = 0; i < look.passes.size(); ++i) {
        if (look.passes[i].accumulate || look.passes[i].per_source_frame)
            add(static_cast<int>(i));
        for (const Input& input : look.passes[i].inputs)
            if (const auto read = find_pass(look, input.name);
                input.from == Input::From::pass && input.frames_ago > 0 && read)
                add(*read);
    }
    return carried;
}
