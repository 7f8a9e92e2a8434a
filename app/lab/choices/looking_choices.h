#pragma once

#include "lab/inspect/inspected_texture.h"
#include "lab/lab.h"
#include "lab/messages/choice.h"

/// What can be inspected besides the passes: source, images, earlier frames and mip levels.
struct InspectedParts {
    std::vector<TextureChoice> textures;
    TextureChoice present;
    int frames = 1;  // stored frames of `present`
    int levels = 1;
};
InspectedParts inspected_parts(const Executor& executor, const PassView& view);

/// Choices of inspected texture, channels and levels.
std::vector<ChoiceList> inspector_choices(const InspectedParts& parts, const PassView& view);

/// Size, format and filter of a pass; empty if the look has no such pass.
ChoiceList pass_setting_choices(const Document& document, const std::string& pass);

/// The chosen and the resulting render size.
struct SizeInForce {
    PictureSize chosen;
    ViewShape shape = ViewShape::view;
    Extent extent;

    bool is_shaped(ViewShape as) const { return chosen.follows_view && shape == as; }
};
SizeInForce size_in_force(const Lab& lab);

/// Offers the display's size if the output window shows a picture of fixed size.
void offer_display_size(Lab& lab, Extent display);

/// Render size, zoom, panes, pins, waveform line and other settings of the window.
std::vector<ChoiceList> window_choices(const WindowState& window, const SizeInForce& size);

/// The labels of the shapes of a picture that follows the view.
inline constexpr std::array picture_shapes{
    std::pair{ViewShape::view, "Fit pane"}, std::pair{ViewShape::source, "Fit, keep source aspect"},
    std::pair{ViewShape::whole_pixels, "Fit, integer scale"}};
/// The size with this shape.
PictureSize with_shape(PictureSize size, ViewShape shape);

/// Adds a pin and shows the pins. At most four are kept; the oldest is removed.
void add_pin(WindowState& window, const Pin& pin);

inline constexpr std::array<Extent, 9> picture_sizes{Extent{320, 240}, {640, 480},   {800, 600},
                                                     {1024, 1024},     {1280, 720},  {1920, 1080},
                                                     {2560, 1440},     {3840, 2160}, {1080, 1920}};
inline constexpr std::array picture_scales{0.25, 0.5, 1.0, 1.5, 2.0};
inline constexpr std::array picture_zooms{0.25, 0.5, 1.0, 2.0, 3.0, 4.0, 8.0, 16.0};
inline constexpr std::array pass_scales{0.125, 0.25, 0.5, 1.0, 2.0};

/// "1/4×", "1.5×".
std::string times_text(double factor);

/// The current settings of a pass, including the user's overrides.
struct PassSetting {
    std::optional<double> scale;  // relative to the picture; nullopt: another kind of size
    Format format = Format::rgba16f;
    Filter filter = Filter::linear;  // of the first input that reads it
    PassOverride tried;
};
/// nullopt: the look has no such pass.
std::optional<PassSetting> pass_setting(const Document& document, const std::string& pass);
