#include "graph/targets/target_set.h"

#include "gpu/debug_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace {
// A look that needs more would exhaust the machine before the driver refuses it.
constexpr std::size_t max_bytes = std::size_t{8} << 30;

Diagnostics at_pass(Diagnostics problems, const Pass& pass) {
    for (Diagnostic& problem : problems) {
        problem.file = pass.declared.file;
        problem.line = pass.declared.line;
        problem.message = fmt::format("target of pass '{}': {}", pass.name, problem.message);
    }
    return problems;
}

// Only the size has changed. Integer formats cannot be filtered.
bool is_stretched(const Pass& pass, const PlannedTarget& old, const PlannedTarget& now) {
    return pass.keeps_when_resized && old.format == now.format && now.slots > 1 &&
           !info_of(now.format).is_integer;
}
// nullopt: the previous pictures are kept.
Result<std::optional<std::vector<gpu::Canvas>>> make_common(
    const Look& look, const std::vector<CommonPicture>& planned,
    const std::vector<CommonPicture>& old) {
    if (planned == old)
        return std::nullopt;
    std::vector<gpu::Canvas> made;
    for (const CommonPicture& picture : planned) {
        auto canvas = gpu::Canvas::make(picture.extent, picture.format, picture.mipmapped);
        if (!canvas)
            return fail({{look.manifest, 0,
                          fmt::format("shared targets: {}", canvas.error().front().message)}});
        made.push_back(std::move(*canvas));
    }
    return made;
}
}  // namespace

Target* TargetSet::find(const std::string& pass) {
    const auto found = std::ranges::find(m_targets, pass, &Named::pass);
    return found == m_targets.end() ? nullptr : &found->target;
}

Result<TargetSet> TargetSet::make(const Look& look, const Plan& plan, TargetSet& old) {
    if (memory_of(plan) > max_bytes)
        return fail(
            {look.manifest, 0,
             fmt::format("the targets need {:.1f} GiB; the limit is {} GiB",
                         static_cast<double>(memory_of(plan)) / (1 << 30), max_bytes >> 30)});
    // New targets first, as creating them may fail. Existing ones are moved last.
    std::vector<std::optional<Target>> made(plan.targets.size());
    for (std::size_t i = 0; i < made.size(); ++i) {
        const Target* had = old.find(look.passes[i].name);
        if (had && had->planned() == plan.targets[i])
            continue;
        auto target = Target::make(plan.targets[i]);
        if (!target)
            return fail(at_pass(target.error(), look.passes[i]));
        made[i] = std::move(*target);
    }
    auto common = make_common(look, plan.common, old.m_planned_common);
    if (!common)
        return fail(common.error());
    TargetSet set;
    set.m_planned_common = plan.common;
    set.m_common = *common ? std::move(**common) : std::move(old.m_common);
    for (std::size_t i = 0; i < made.size(); ++i) {
        const std::string& name = look.passes[i].name;
        Target* had = old.find(name);
        if (made[i] && had && is_compatible(had->planned(), plan.targets[i]))
            made[i]->adopt(std::move(*had));
        else if (made[i] && had && is_stretched(look.passes[i], had->planned(), plan.targets[i]))
            made[i]->adopt_stretched(*had);
        set.m_targets.push_back({name, made[i] ? std::move(*made[i]) : std::move(*had)});
    }
    set.bind_shared();
    set.set_labels();
    return set;
}

void TargetSet::set_labels() {
    if (!gpu::is_debugged())
        return;
    std::vector<std::string> users(m_common.size());
    for (Named& named : m_targets) {
        named.target.set_label(named.pass);
        if (const auto common = named.target.planned().common)
            users[*common] += (users[*common].empty() ? "" : ", ") + named.pass;
    }
    for (std::size_t i = 0; i < m_common.size(); ++i)
        gpu::set_label(m_common[i], users[i]);
}

void TargetSet::bind_shared() {
    for (Named& named : m_targets) {
        const std::optional<std::size_t> common = named.target.planned().common;
        named.target.set_shared(common ? &m_common[*common] : nullptr);
    }
}
