#include "ui/picture/picture_panel.h"

#include "lab/document/parameter_edits.h"
#include "lab/drawing/drawing_tool.h"
#include "ui/frame/action.h"
#include "ui/frame/look_keys.h"
#include "ui/picture/cell_texts.h"
#include "ui/picture/compare_bar.h"
#include "ui/picture/drawing_overlay.h"
#include "ui/picture/overlays.h"
#include "ui/picture/pass_switch_items.h"
#include "ui/picture/picture_canvas.h"
#include "ui/picture/picture_menus.h"
#include "ui/picture/pins_panel.h"
#include "ui/picture/scan_line.h"
#include "ui/picture/wipe.h"
#include "ui/widgets/scoped.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace {
struct PointedPixel {
    std::array<double, 2> pixel;
    bool is_of_variant;
};

void probe_inspected(const PointedPixel& pointed, const Scene& scene, Edits& edits) {
    const Probe probe{
        scene.window.views.inspected.label(), static_cast<int>(std::floor(pointed.pixel[0])),
        static_cast<int>(std::floor(pointed.pixel[1])), pointed.is_of_variant, large_extent(scene)};
    edits.arrange([probe](WindowState& window) { window.probes.pointer = probe; });
}

// Gives the look the pointer in pixels from the bottom left, and the status bar the probe.
void tell_pointer(const PointedPixel& pointed, const Scene& scene, Edits& edits) {
    const Extent extent = scene.lab.size.extent();
    const double x = pointed.pixel[0];
    const double y = pointed.pixel[1];
    if (x < 0.0 || y < 0.0 || x >= extent.width || y >= extent.height)
        return;
    const std::array<double, 2> mouse{x, extent.height - y};
    // An unchanged position would keep the lab awake.
    if (scene.lab.renderer && scene.lab.renderer->input_state().position() != mouse)
        edits.change([mouse](Renderer& renderer) {
            renderer.change_input_state(
                [mouse](InputState& input_state) { input_state.move(mouse); });
        });
    if (!scene.lab.renderer || scene.lab.renderer->executor().plan().targets.empty())
        return;
    Probe probed = picture_probe(scene.lab.renderer->executor(),
                                 scene.lab.frames.passes().picture_pass(), extent, pointed.pixel);
    probed.is_of_variant = pointed.is_of_variant;
    edits.arrange([probed](WindowState& window) { window.probes.pointer = probed; });
}

// Call it after the picture's item if the look reads the mouse button.
void tell_press(const Scene& scene, Edits& edits) {
    const bool is_down = ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left);
    if (scene.lab.renderer && scene.lab.renderer->input_state().press().is_down != is_down)
        edits.change([is_down](Renderer& renderer) {
            renderer.change_input_state(
                [is_down](InputState& input_state) { input_state.set_button(is_down); });
        });
}

void follow_pen(const CanvasInput& input, Edits& edits) {
    if (input.pen_down)
        edits.change([pixel = *input.pen_down](DrawingTool& drawing) { drawing.pen_down(pixel); });
    for (const auto& pixel : input.pen_path)
        edits.change([pixel](DrawingTool& drawing) { drawing.pen_move(pixel); });
    if (input.is_pen_up)
        edits.change([](DrawingTool& drawing) { drawing.pen_up(); });
    if (input.right_click)
        edits.change(
            [pixel = *input.right_click](DrawingTool& drawing) { drawing.right_click(pixel); });
}

// The text for a pass that replaces the picture; "": the picture is displayed.
std::string other_words(const Scene& scene) {
    const PassSwitches& switches = scene.lab.frames.passes().switches();
    if (scene.window.views.shows_pass_large)
        return fmt::format("{} · Back to picture", scene.window.views.inspected.label());
    if (!switches.solo.empty())
        return fmt::format("Solo: {} · Back to picture", switches.solo);
    if (!switches.last.empty())
        return fmt::format("Stopped at {} · Back to picture", switches.last);
    return {};
}

// A button that returns to the picture.
void draw_other_words(const Scene& scene, Edits& edits) {
    const std::string label = other_words(scene);
    if (label.empty())
        return;
    const float margin = ImGui::GetFontSize() * 0.5f;
    const float width =
        ImGui::CalcTextSize(label.c_str()).x + 2.0f * ImGui::GetStyle().FramePadding.x;
    ImGui::SetCursorPos({margin, margin});
    const ScopedStyle<ImVec2> padding(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
    ImGui::BeginChild("##back", {width, ImGui::GetFrameHeight()});  // above the picture
    if (ImGui::Button(label.c_str())) {
        if (scene.window.views.shows_pass_large)
            run(ActionId::pass_large, scene, edits);
        else
            show_whole_picture(scene, edits);
    }
    edits.mark("back_to_picture");
    ImGui::EndChild();
}

/// A displayed picture: the current one or the reference.
struct Shown {
    const char* name = "picture";
    ViewImage image;
    float left = 0.0f;  // in the pane
    bool is_other = false;
};

std::vector<Shown> shown_pictures(const Scene& scene) {
    const auto sides = scene.lab.frames.comparison().sides();
    Shown ours{.image = scene.views.main().picture(),
               .is_other = sides && scene.lab.frames.comparison().selection().is_reference_shown()};
    if (scene.views.main().reference().handle == 0)
        return {ours};
    const Extent whole = scene.window.views.sizes.picture;
    const float right =
        static_cast<float>(whole.width - main_pane_size(scene).width) / scene.density;
    Shown reference{"reference", scene.views.main().reference(), 0.0f, true};
    (sides && !sides->is_other_left ? reference : ours).left = right;
    return {ours, reference};
}

// Overlays that show texel values of the current picture.
void draw_over_texels(const ImVec2& low, const ImVec2& size, const Scene& scene) {
    draw_cell_texts(scene.views.texels().picture(), low, size, scene);
    draw_scan_line(low, size, scene);
}

void draw_shown(const Shown& shown, const Scene& scene, Edits& edits, const ImVec2& size) {
    const bool is_large = scene.window.views.shows_pass_large;
    const bool is_turned = !is_large && scene.lab.document->look().has_orbit;
    const bool has_pen = !is_large && scene.lab.drawing.board().has_pen();
    const bool has_press = !is_large && !has_pen && !is_turned && !shown.is_other &&
                           reads_press(scene.lab.document->look());
    const Extent room = device_pixels(scene, size.x, size.y);
    const auto wipe = drag_wipe(size, scene, edits);
    if (!shown.is_other)
        drag_scan_line(size, scene, edits);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const CanvasInput input = draw_picture_canvas({.id = shown.name,
                                                   .image = shown.image,
                                                   .picture = large_extent(scene),
                                                   .view = scene.window.views.large(),
                                                   .size = size,
                                                   .has_orbit = is_turned,
                                                   .has_pen = has_pen,
                                                   .has_press = has_press},
                                                  scene);
    edits.mark(shown.name);
    const bool is_picture_pointed = ImGui::IsItemHovered() || ImGui::IsItemActive();
    if (!shown.is_other)
        draw_over_texels(low, size, scene);
    if (!has_pen)
        pin_on_click(scene, edits);
    draw_pin_marks(scene, low, large_extent(scene), scene.window.views.large(), room);
    if (input.moved)
        edits.arrange([view = *input.moved](WindowState& window) { window.views.large() = view; });
    if (input.orbit)
        edits.change([orbit = input.orbit](Document& document) { set_orbit(document, orbit); });
    if (input.is_turn_finished)
        edits.finish();
    const bool is_other = shown.is_other || is_over_variant(wipe, scene);
    if (input.hovered && is_large)
        probe_inspected({*input.hovered, is_other}, scene, edits);
    else if (input.hovered)
        tell_pointer({*input.hovered, is_other}, scene, edits);
    if (has_press)
        tell_press(scene, edits);
    if (!shown.is_other)
        write_keys(is_picture_pointed && !is_large, scene, edits);
    if (wipe)
        draw_wipe(*wipe, scene);
    if (!has_pen)
        return;
    follow_pen(input, edits);
    const PicturePosition at = position_of(scene.window.views.large(), large_extent(scene), room);
    draw_drawing_overlay(scene, input, [&](const PicturePixel& pixel) {
        return ImVec2(low.x + static_cast<float>(at.left + pixel[0] * at.zoom) / scene.density,
                      low.y + static_cast<float>(at.top + pixel[1] * at.zoom) / scene.density);
    });
}
}  // namespace

void draw_picture_panel(const Scene& scene, const Rect& rect, Edits& edits) {
    const float height = std::max(rect.height - compare_bar_height(scene), 1.0f);
    const Extent room = device_pixels(scene, rect.width, height);
    const Extent cell = min_cell(scene);
    if (room != scene.window.views.sizes.picture || cell != scene.window.views.sizes.cell)
        edits.arrange([room, cell](WindowState& window) {
            window.views.sizes.picture = room;
            window.views.sizes.cell = cell;
        });
    if (!scene.lab.document) {
        draw_welcome(scene);
        draw_overlays(scene, edits);
        return;
    }
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 start = ImGui::GetCursorPos();
    const std::vector<Shown> pictures = shown_pictures(scene);
    const bool is_alone = pictures.size() == 1;
    const float width =
        is_alone ? rect.width : static_cast<float>(main_pane_size(scene).width) / scene.density;
    for (const Shown& shown : pictures) {
        ImGui::SetCursorPos({start.x + shown.left, start.y});
        draw_shown(shown, scene, edits, {width, height});
    }
    draw_halves_names(low, low.x + rect.width - width, scene);
    draw_other_words(scene, edits);
    draw_compare_bar(scene, edits);
    draw_overlays(scene, edits);
}
