#include "lab/export/export_target.h"

#include "lab/export/effect_export.h"
#include "lab/export/portable_export.h"
#include "lab/export/web_export.h"

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

// Formats of programs that draw chains of passes, which Afterglow reads too.
std::vector<ExportTarget> shader_targets() {
    return {
        {.name = "slang",
         .label = "RetroArch preset",
         .extension = ".slangp",
         .help = "a .slangp preset with its shaders, for RetroArch and other programs with "
                 "libretro shaders",
         .keeps = {"looks that process a picture", "all parameters, with label, range and step",
                   "the author's shader text with its #include files"},
         .losses = slang_losses,
         .write = export_slang,
         .check = check_effect,
         .page = nullptr},
        {.name = "isf",
         .label = "ISF shader",
         .extension = ".fs",
         .help = "one .fs file, for VDMX and other programs with ISF shaders",
         .keeps = {"looks that process a picture", "all parameters, with label and range",
                   "the author's shader text"},
         .losses = isf_losses,
         .write = export_isf,
         .check = check_effect,
         .page = nullptr},
        {.name = "shadertoy",
         .label = "Shadertoy shader",
         .extension = ".json",
         .help = "one .json file with up to four buffers and an image, for Shadertoy and its "
                 "players",
         .keeps = {"looks that process a picture, with up to four buffers",
                   "Phosphor with Lissajous figures, harmonics, AM and FM",
                   "all parameters, as constants with annotations", "the author's shader text"},
         .losses = shadertoy_losses,
         .write = export_shadertoy,
         .check = check_effect,
         .page = nullptr},
    };
}

// Formats of programs that draw over their own picture.
std::vector<ExportTarget> overlay_targets() {
    return {
        {.name = "mpv",
         .label = "mpv shader",
         .extension = ".glsl",
         .help = "one .glsl file, for mpv and other programs with its user shaders",
         .keeps = {"looks that process a picture", "the author's shader text",
                   "present values, as lines that you can edit"},
         .losses = mpv_losses,
         .write = export_mpv,
         .check = check_mpv,
         .page = nullptr,
         .why_not_drawn = "Afterglow can't draw user shaders of mpv. Compare the pictures in mpv"},
        {.name = "reshade",
         .label = "ReShade effect",
         .extension = ".fx",
         .help = "an .fx file with a preset and pictures, for ReShade and vkBasalt",
         .keeps = {"looks that process a picture", "all parameters, with label, range and step",
                   "licences and authors"},
         .losses = reshade_losses,
         .write = export_reshade,
         .check = check_reshade,
         .page = nullptr,
         .why_not_drawn = "Afterglow can't draw effects of ReShade"},
    };
}
}  // namespace

const std::vector<ExportTarget>& export_targets() {
    static const std::vector<ExportTarget> targets = [] {
        std::vector<ExportTarget> all = player_targets();
        for (const std::vector<ExportTarget>& more : {shader_targets(), overlay_targets()})
            all.insert(all.end(), more.begin(), more.end());
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

Result<ExportedLook> export_look(const ExportTarget& target, const ExportRequest& request) {
    auto made = target.write(request);
    if (!made)
        return made;
    if (auto good = target.check(request); !good)
        return fail(good.error());
    return made;
}
