#include "ui/picture/picture_canvas.h"

#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <cmath>

namespace {
PictureView zoomed(const PictureCanvas& canvas, const PicturePosition& position,
                   const std::array<double, 2>& pixel, int notches) {
    PictureView view = canvas.view;
    double zoom = position.zoom;
    for (int i = 0; i < std::abs(notches); ++i)
        zoom = next_zoom(zoom, notches > 0);
    view.zoom_about(pixel[0] / canvas.picture.width, pixel[1] / canvas.picture.height,
                    position.zoom, zoom);
    return view;
}

// One frame can contain several notches, or a fraction of one from a touchpad. Fractions add up.
int turned_notches() {
    float& rest = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("wheel"));
    rest += ImGui::GetIO().MouseWheel;
    const float whole = std::trunc(rest);
    rest -= whole;
    return static_cast<int>(whole);
}

PictureView panned(const PictureCanvas& canvas, const PicturePosition& position, float density) {
    const ImVec2 delta = ImGui::GetIO().MouseDelta;
    PictureView view = canvas.view;
    const auto moved = [&](double middle, float by, int length) {
        return std::clamp(middle - by * density / (position.zoom * length), 0.0, 1.0);
    };
    view.x = moved(view.x, delta.x, canvas.picture.width);
    view.y = moved(view.y, delta.y, canvas.picture.height);
    return view;
}
}  // namespace

namespace {
bool is_dragged() {
    const ImVec2 delta = ImGui::GetIO().MouseDelta;
    return ImGui::IsItemActive() && (delta.x != 0.0f || delta.y != 0.0f);
}

// Dragging across the view is a rotation by 180 degrees.
std::function<Orbit(const Orbit&)> dragged_orbit(const PictureCanvas& canvas) {
    const ImVec2 delta = ImGui::GetIO().MouseDelta;
    const double degrees = 180.0 / std::max(std::min(canvas.size.x, canvas.size.y), 1.0f);
    const double right = delta.x * degrees;
    const double up = -delta.y * degrees;
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left))
        return [right, up](const Orbit& orbit) { return with_object_turned(orbit, right, up); };
    return [right, up](const Orbit& orbit) { return with_camera_moved(orbit, right, up); };
}

void rotate_orbit(const PictureCanvas& canvas, CanvasInput& input) {
    constexpr double factor_per_notch = 0.9;
    const float wheel = ImGui::GetIO().MouseWheel;
    if (wheel != 0.0f && ImGui::GetIO().KeyCtrl) {
        const double factor = std::pow(factor_per_notch, wheel);
        input.orbit = [factor](const Orbit& orbit) { return with_distance_scaled(orbit, factor); };
        input.is_turn_finished = true;
    } else if (is_dragged() && !ImGui::IsMouseDown(ImGuiMouseButton_Middle)) {
        input.orbit = dragged_orbit(canvas);
    }
}

void read_pen(const std::function<std::array<double, 2>(float, float)>& pixel_at,
              const Scene& scene, CanvasInput& input) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (ImGui::IsItemActivated() && ImGui::IsMouseClicked(ImGuiMouseButton_Left))
        input.pen_down = pixel_at(mouse.x, mouse.y);
    else if (ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left))
        for (const gpu::PointerEvent& position : scene.frame.pointer_path)
            input.pen_path.push_back(pixel_at(position.x, position.y));
    if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right))
        input.right_click = pixel_at(mouse.x, mouse.y);
}
}  // namespace

CanvasInput draw_picture_canvas(const PictureCanvas& canvas, const Scene& scene) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high(low.x + canvas.size.x, low.y + canvas.size.y);
    ImGui::InvisibleButton(canvas.id,
                           {std::max(canvas.size.x, 1.0f), std::max(canvas.size.y, 1.0f)},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle |
                               (canvas.has_orbit ? ImGuiButtonFlags_MouseButtonRight : 0));
    if (canvas.image.handle != 0) {
        // The texture covers whole device pixels and has its row 0 at the bottom.
        const ImVec2 end(low.x + static_cast<float>(canvas.image.extent.width) / scene.density,
                         low.y + static_cast<float>(canvas.image.extent.height) / scene.density);
        ImGui::GetWindowDrawList()->AddImage(texture_id(canvas.image.handle), low, end,
                                             {0.0f, 1.0f}, {1.0f, 0.0f});
    }
    CanvasInput input;
    input.is_turn_finished = canvas.has_orbit && ImGui::IsItemDeactivated();
    input.is_pen_up = canvas.has_pen && ImGui::IsItemDeactivated();
    if (canvas.picture.is_empty() || (!ImGui::IsItemHovered() && !ImGui::IsItemActive()))
        return input;
    const Extent room = device_pixels(scene, high.x - low.x, high.y - low.y);
    const PicturePosition position = position_of(canvas.view, canvas.picture, room);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const auto pixel_at = [&](float x, float y) {
        return position.pixel_at((x - low.x) * scene.density, (y - low.y) * scene.density);
    };
    const auto pixel = pixel_at(mouse.x, mouse.y);
    input.hovered = pixel;
    if (canvas.has_orbit)
        rotate_orbit(canvas, input);
    if (canvas.has_pen)
        read_pen(pixel_at, scene, input);
    if (input.orbit)
        return input;
    if (const int notches = turned_notches(); notches != 0)
        input.moved = zoomed(canvas, position, pixel, notches);
    else if (is_dragged() &&
             !((canvas.has_pen || canvas.has_press) && ImGui::IsMouseDown(ImGuiMouseButton_Left)))
        input.moved = panned(canvas, position, scene.density);
    return input;
}
