#include "lab/export/export_target.h"

#include "lab/export/effect_export.h"
#include "lab/export/portable_export.h"
#include "lab/export/web_export.h"
#include "model/look/subframe.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
// Formats that draw the look with its own player.
std::vector<ExportTarget> player_targets() {
    return {
        {.name = "portable",
         .label = "Portable look",
         .extension = {},
         .help = "a folder with JSON, GLSL 4.10 and media",
         .keeps = {"all passes, parameters and values", "the signal or source with its files",
                   "licences and authors"},
         .losses = portable_losses,
         .write = export_portable,
         .check = check_portable,
         .page = page_of_portable},
        {.name = "web",
         .label = "Web page",
         .extension = ".html",
         .help = "one HTML file that draws the look live in a browser",
         .keeps = {"all passes and parameters, with sliders",
                   "live signals, sound, pictures, videos and the camera",
                   "presets as links and as lines of text"},
         .losses = web_losses,
         .write = export_web,
         .check = check_web,
         .page = page_of_web},
    };
}
}  // namespace

const std::vector<ExportTarget>& export_targets() {
    static const std::vector<ExportTarget> targets = [] {
        std::vector<ExportTarget> all = player_targets();
        for (ExportTarget& effect : effect_targets())
            all.push_back(std::move(effect));
        return all;
    }();
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

Result<std::vector<std::string>> losses_of(const ExportTarget& target,
                                           const PreparedLook& prepared) {
    auto losses = target.losses(prepared);
    const Document& document = prepared.document;
    if (losses && !target.has_subframes && subframes_of(document.look(), document.values()) > 1)
        losses->emplace_back("Sub-frames. Each frame shows the mean light of a source frame.");
    return losses;
}

Result<ExportedLook> export_look(const ExportTarget& target, const ExportRequest& request) {
    auto made = target.write(request);
    if (!made)
        return made;
    if (auto good = target.check(request); !good)
        return fail(good.error());
    return made;
}
