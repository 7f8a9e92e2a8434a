#pragma once

#include "lab/messages/menu_entry.h"
#include "lab/rendering/picture_size.h"

class Messages;
class RenderSize;
struct Pin;
struct WindowState;

/// The chosen and the resulting render size.
struct EffectiveSize {
    PictureSize chosen;
    ViewShape shape = ViewShape::view;
    Extent extent;

    bool is_shaped(ViewShape as) const { return chosen.follows_view && shape == as; }
};
EffectiveSize effective_size(const RenderSize& size);

/// Offers the display's size if the output window shows a picture of fixed size.
void offer_display_size(const RenderSize& size, Messages& messages, Extent display);

/// Render size, zoom, panes, pins, waveform line and other settings of the window.
std::vector<MenuSection> window_sections(const WindowState& window, const EffectiveSize& size);

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

/// "1/4×", "1.5×".
std::string times_text(double factor);
