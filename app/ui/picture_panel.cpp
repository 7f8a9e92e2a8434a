#include "ui/picture_panel.h"

#include "ui/overlays.h"
#include "ui/picture_canvas.h"

#include <cmath>

namespace {
// The look gets the pointer in pixels from the bottom left; the status line what lies under it.
void tell_pointer(const std::array<double, 2>& pixel, const Scene& scene, Edits& edits) {
    const Extent extent = scene.lab.picture_extent();
    const double x = pixel[0];
    const double y = pixel[1];
    if (x < 0.0 || y < 0.0 || x >= extent.width || y >= extent.height)
        return;
    edits.add([x, y, extent](Lab& lab) { lab.set_mouse(x, extent.height - y); });
    const Probe probe{scene.lab.document()->look().passes.back().name,
                      static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y))};
    edits.arrange([probe](WindowState& window) { window.probe = probe; });
}
}  // namespace

void draw_picture_panel(const Scene& scene, const Rect& place, Edits& edits) {
    const Extent room = scene.device_pixels(place.width, place.height);
    if (room != scene.window.views.picture)
        edits.arrange([room](WindowState& window) { window.views.picture = room; });
    if (!scene.lab.document()) {
        draw_welcome(scene);
        draw_overlays(scene, edits);
        return;
    }
    const CanvasInput input = draw_picture_canvas({.id = "##picture",
                                                   .image = scene.views.picture(),
                                                   .picture = scene.lab.picture_extent(),
                                                   .view = scene.window.picture,
                                                   .size = {place.width, place.height}},
                                                  scene);
    edits.mark("picture");
    if (input.moved)
        edits.arrange([view = *input.moved](WindowState& window) { window.picture = view; });
    if (input.hovered)
        tell_pointer(*input.hovered, scene, edits);
    draw_overlays(scene, edits);
}
