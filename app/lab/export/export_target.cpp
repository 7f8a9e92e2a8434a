#include "lab/export/export_target.h"

#include "lab/export/portable_export.h"
#include "lab/export/web_export.h"

#include <fmt/format.h>

#include <algorithm>

const std::vector<ExportTarget>& export_targets() {
    static const std::vector<ExportTarget> targets{
        {"portable", "a folder with JSON, GLSL 4.10 and media",
         [](const PreparedLook&) { return std::vector<std::string>(); }, export_portable},
        {"web", "one HTML file that draws the look live in a browser", web_losses, export_web},
    };
    return targets;
}

Result<const ExportTarget*> find_export_target(const std::string& name) {
    const auto& targets = export_targets();
    const auto found = std::ranges::find(targets, name, &ExportTarget::name);
    if (found != targets.end())
        return &*found;
    std::string names;
    for (const ExportTarget& target : targets)
        names += (names.empty() ? "" : ", ") + target.name;
    return fail({{}, 0, fmt::format("can't export to '{}'. Choose from: {}.", name, names)});
}
