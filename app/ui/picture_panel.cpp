#include "ui/picture_panel.h"

#include "ui/actions.h"
#include "ui/drawing_overlay.h"
#include "ui/overlays.h"
#include "ui/picture_canvas.h"
#include "ui/picture_menus.h"
#include "ui/pins_panel.h"
#include "ui/scoped.h"
#include "ui/wipe.h"

#include <cmath>

namespace {
struct Place {
    std::array<double, 2> pixel;
    bool is_of_variant;
};

void probe(const std::string& pass, const Place& place, Edits& edits) {
    const Probe probe{pass, static_cast<int>(std::floor(place.pixel[0])),
                      static_cast<int>(std::floor(place.pixel[1])), place.is_of_variant};
    edits.arrange([probe](WindowState& window) { window.probe = probe; });
}

// The look gets the pointer in pixels from the bottom left; the status line what lies under it.
void tell_pointer(const Place& place, const Scene& scene, Edits& edits) {
    const Extent extent = scene.lab.picture_extent();
    const double x = place.pixel[0];
    const double y = place.pixel[1];
    if (x < 0.0 || y < 0.0 || x >= extent.width || y >= extent.height)
        return;
    edits.add([x, y, extent](Lab& lab) { lab.set_mouse(x, extent.height - y); });
    probe(scene.lab.document()->look().passes.back().name, place, edits);
}

void follow_pen(const CanvasInput& input, Edits& edits) {
    if (input.pen_down)
        edits.add([pixel = *input.pen_down](Lab& lab) { lab.pen_down(pixel); });
    for (const auto& pixel : input.pen_path)
        edits.add([pixel](Lab& lab) { lab.pen_move(pixel); });
    if (input.is_pen_up)
        edits.add([](Lab& lab) { lab.pen_up(); });
    if (input.other_button)
        edits.add([pixel = *input.other_button](Lab& lab) { lab.other_button(pixel); });
}

// Says that this is not the picture, and how to get it back.
void draw_large_pass_words(const Scene& scene, Edits& edits) {
    if (!scene.window.shows_pass_large)
        return;
    const float margin = ImGui::GetFontSize() * 0.5f;
    const std::string label = "Pass " + scene.window.inspected.pass + " · back to the picture";
    const float width =
        ImGui::CalcTextSize(label.c_str()).x + 2.0f * ImGui::GetStyle().FramePadding.x;
    ImGui::SetCursorPos({margin, margin});
    const ScopedStyle<ImVec2> padding(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
    ImGui::BeginChild("##back", {width, ImGui::GetFrameHeight()});  // lies above the picture
    if (ImGui::Button(label.c_str()))
        run(ActionId::pass_large, scene, edits);
    edits.mark("back_to_picture");
    ImGui::EndChild();
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
    const auto wipe = drag_wipe({place.width, place.height}, scene, edits);
    const bool is_turned = !scene.window.shows_pass_large && scene.lab.document()->look().has_orbit;
    const bool has_pen = !scene.window.shows_pass_large && scene.lab.drawing_board().has_pen();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const CanvasInput input = draw_picture_canvas({.id = "##picture",
                                                   .image = scene.views.picture(),
                                                   .picture = large_extent(scene),
                                                   .view = scene.window.large_view(),
                                                   .size = {place.width, place.height},
                                                   .has_orbit = is_turned,
                                                   .has_pen = has_pen},
                                                  scene);
    edits.mark("picture");
    if (!has_pen)
        pin_on_click(scene, edits);
    draw_pin_marks(scene, low, large_extent(scene), scene.window.large_view(), room);
    if (input.moved)
        edits.arrange([view = *input.moved](WindowState& window) { window.large_view() = view; });
    if (input.turned)
        edits.document([turned = input.turned](Document& document) { document.set_orbit(turned); });
    if (input.is_turn_finished)
        edits.finish();
    if (input.hovered && scene.window.shows_pass_large)
        probe(scene.window.inspected.pass, {*input.hovered, is_over_variant(wipe, scene)}, edits);
    else if (input.hovered)
        tell_pointer({*input.hovered, is_over_variant(wipe, scene)}, scene, edits);
    if (wipe)
        draw_wipe(*wipe, scene);
    if (has_pen) {
        follow_pen(input, edits);
        const PicturePlace at = place_of(scene.window.large_view(), large_extent(scene), room);
        draw_drawing_overlay(scene, input, [&](const PicturePixel& pixel) {
            return ImVec2(low.x + static_cast<float>(at.left + pixel[0] * at.zoom) / scene.density,
                          low.y + static_cast<float>(at.top + pixel[1] * at.zoom) / scene.density);
        });
    }
    draw_large_pass_words(scene, edits);
    draw_overlays(scene, edits);
}
