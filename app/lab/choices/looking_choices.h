#pragma once

#include "lab/inspect/inspected_texture.h"
#include "lab/lab.h"
#include "lab/messages/choice.h"

/// What the inspector can look into beside the passes themselves: the source, images, former frames
/// and mip levels.
struct InspectedParts {
    std::vector<TextureChoice> textures;
    TextureChoice present;
    int frames = 1;  // of `present` that are held
    int levels = 1;
};
InspectedParts inspected_parts(const Executor& executor, const PassView& view);

/// What is looked into, its channels and its numbers.
std::vector<ChoiceList> inspector_choices(const InspectedParts& parts, const PassView& view);

/// Size, format and filter of a pass; nothing where the look has none of that name.
ChoiceList pass_setting_choices(const Document& document, const std::string& pass);

/// How large the picture is to be, and is.
struct SizeInForce {
    PictureSize chosen;
    ViewShape shape = ViewShape::view;
    Extent extent;

    bool is_shaped(ViewShape as) const { return chosen.follows_view && shape == as; }
};
SizeInForce size_in_force(const Lab& lab);

/// Offers the display's size for a picture of a fixed size that the output window begins to show.
void offer_display_size(Lab& lab, Extent display);

/// Size of the picture, zoom, panes, pins, the waveform's line and what else the window holds.
std::vector<ChoiceList> window_choices(const WindowState& window, const SizeInForce& size);

/// How a picture that follows the view may be shaped, as a person reads it.
inline constexpr std::array picture_shapes{
    std::pair{ViewShape::view, "Fit pane"}, std::pair{ViewShape::source, "Fit, keep source aspect"},
    std::pair{ViewShape::whole_pixels, "Fit, integer scale"}};
/// The size with that shape.
PictureSize with_shape(PictureSize size, ViewShape shape);

/// Keeps four, the first one gives way; and shows them.
void add_pin(WindowState& window, const Pin& pin);

inline constexpr std::array<Extent, 9> picture_sizes{Extent{320, 240}, {640, 480},   {800, 600},
                                                     {1024, 1024},     {1280, 720},  {1920, 1080},
                                                     {2560, 1440},     {3840, 2160}, {1080, 1920}};
inline constexpr std::array picture_scales{0.25, 0.5, 1.0, 1.5, 2.0};
inline constexpr std::array picture_zooms{0.25, 0.5, 1.0, 2.0, 3.0, 4.0, 8.0, 16.0};
inline constexpr std::array pass_scales{0.125, 0.25, 0.5, 1.0, 2.0};

/// "1/4×", "1.5×".
std::string times_text(double factor);

/// How a pass is drawn now: as its look has it, or as the person tries it.
struct PassSetting {
    std::optional<double> scale;  // of the picture; none: its size is given otherwise
    Format format = Format::rgba16f;
    Filter filter = Filter::linear;  // as the first pass reads it that does
    PassOverride tried;
};
/// None where the look has no pass of that name.
std::optional<PassSetting> pass_setting(const Document& document, const std::string& pass);
