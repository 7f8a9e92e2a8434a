#pragma once

#include "lab/document/document.h"
#include "lab/inspect/inspected_texture.h"
#include "lab/messages/menu_entry.h"

/// What can be inspected besides the passes: source, images, earlier frames and mip levels.
struct InspectedParts {
    std::vector<TextureChoice> textures;
    TextureChoice current;
    int frames = 1;  // stored frames of `current`
    int levels = 1;
};
InspectedParts inspected_parts(const Executor& executor, const PassView& view);

/// Inspected texture, channels and levels.
std::vector<MenuSection> inspector_sections(const InspectedParts& parts, const PassView& view);

/// Size, format and filter of a pass; empty if the look has no such pass.
MenuSection pass_setting_section(const Document& document, const std::string& pass);

/// The current settings of a pass, including the user's overrides.
struct PassSetting {
    std::optional<double> scale;  // relative to the picture; nullopt: another kind of size
    Format format = Format::rgba16f;
    Filter filter = Filter::linear;  // of the first input that reads it
    PassOverride tried;
};
/// nullopt: the look has no such pass.
std::optional<PassSetting> pass_setting(const Document& document, const std::string& pass);

inline constexpr std::array pass_scales{0.125, 0.25, 0.5, 1.0, 2.0};
