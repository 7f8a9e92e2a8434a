#include "ui/picture/picture_menus.h"

#include "lab/menus/window_menu.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/slider.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace {
std::string size_label(const Scene& scene) {
    return size_text(scene.lab.size.extent());
}

double current_zoom(const Scene& scene) {
    return scene.window.views.large().zoom_for(large_extent(scene), main_pane_size(scene));
}

// Only at integer zooms is every pixel of the picture a block of screen pixels.
std::string zoom_label(const Scene& scene) {
    const double zoom = current_zoom(scene);
    const bool is_whole = zoom >= 1.0 && zoom == std::floor(zoom);
    return is_whole ? zoom_text(zoom) : fmt::format("{} resampled", zoom_text(zoom));
}

float button_width(const std::string& label) {
    return ImGui::CalcTextSize(label.c_str()).x + 2.0f * ImGui::GetStyle().FramePadding.x;
}

void set_size(PictureSize size, Edits& edits) {
    edits.change([size](RenderSize& render_size) { render_size.choose(size); });
}

template <class Items>
void draw_button(const std::string& label, const char* popup, const std::string& help,
                 const Items& items) {
    if (quiet_button(label + "##" + popup))
        ImGui::OpenPopup(popup);
    tooltip(help);
    if (ImGui::BeginPopup(popup)) {
        items();
        ImGui::EndPopup();
    }
}
}  // namespace

Extent large_extent(const Scene& scene) {
    if (scene.window.views.shows_pass_large && scene.lab.renderer) {
        const auto inspected =
            inspected_texture(scene.lab.renderer->executor(), scene.window.views.inspected);
        if (inspected)
            return inspected->extent();
    }
    return scene.lab.size.extent();
}

Extent main_pane_size(const Scene& scene) {
    const bool is_half = scene.views.main().reference().handle != 0;
    return size_of_one(scene.window.views.sizes.picture,
                       is_half ? CompareMode::side_by_side : CompareMode::off);
}

std::string zoom_text(double zoom) {
    if (zoom < 1.0 && 1.0 / zoom == std::floor(1.0 / zoom))
        return "1/" + short_number(1.0 / zoom) + "×";
    return short_number(std::round(zoom * 100.0) / 100.0) + "×";
}

float picture_menus_width(const Scene& scene) {
    const ScopedFont font(scene.fonts.numbers);
    return button_width(size_label(scene)) + button_width(zoom_label(scene));
}

void draw_picture_menus(const Scene& scene, Edits& edits) {
    const std::string size = size_label(scene);
    const std::string zoom = zoom_label(scene);
    const ScopedFont font(scene.fonts.numbers);
    draw_button(size, "size", "Render size in pixels, independent of the window size.", [&] {
        const ScopedFont text(scene.fonts.text);
        draw_size_items(scene, edits);
    });
    edits.mark("picture_size");
    ImGui::SameLine(0.0f, 0.0f);
    const ScopedColor color(ImGuiCol_Text, theme::dim);
    draw_button(zoom, "zoom", "Zoom: screen pixels per pixel of the picture.", [&] {
        const ScopedFont text(scene.fonts.text);
        const ScopedColor normal(ImGuiCol_Text, theme::text);
        draw_zoom_items(scene, edits);
    });
    edits.mark("zoom");
}

void draw_size_items(const Scene& scene, Edits& edits) {
    const PictureSize current = scene.lab.size.chosen();
    for (const auto& [shape, name] : picture_shapes) {
        if (ImGui::MenuItem(name, nullptr, effective_size(scene.lab.size).is_shaped(shape)))
            set_size(with_shape(current, shape), edits);
        edits.mark("shape:" + std::string(shape_name(shape)));
    }
    ImGui::Separator();
    if (ImGui::MenuItem("Match pane once", nullptr, current.fits_shape))
        edits.change([](RenderSize& size) { size.fix_to_view(); });
    tooltip(
        "Sets the render size to the size of the pane, or of the output window's display. It "
        "doesn't change when panes open or close.");
    edits.mark("size:pane_once");
    for (const Extent& extent : picture_sizes) {
        if (ImGui::MenuItem(size_text(extent).c_str(), nullptr, current.is_exactly(extent)))
            set_size({false, extent, current.scale, current.shape}, edits);
        edits.mark("size:" + std::to_string(extent.width) + "x" + std::to_string(extent.height));
    }
    ImGui::Separator();
    for (const double scale : picture_scales) {
        const std::string label = fmt::format("Scale {}", zoom_text(scale));
        if (ImGui::MenuItem(label.c_str(), nullptr, current.scale == scale)) {
            PictureSize size = current;
            size.scale = scale;
            set_size(size, edits);
        }
    }
}

void draw_zoom_items(const Scene& scene, Edits& edits) {
    const PictureView& current = scene.window.views.large();
    const auto fit_item = [&](const char* label, const char* key, PictureView::Fit fit) {
        if (ImGui::MenuItem(label, key, current.fit == fit))
            edits.arrange([fit](WindowState& window) { window.views.large() = {fit}; });
    };
    fit_item("Largest integer zoom", "", PictureView::Fit::integer);
    fit_item("Fit", "F", PictureView::Fit::whole);
    ImGui::Separator();
    for (const double zoom : picture_zooms) {
        const bool is_chosen = current.fit == PictureView::Fit::free && current.zoom == zoom;
        if (ImGui::MenuItem(zoom_text(zoom).c_str(), zoom == 1.0 ? "1" : nullptr, is_chosen))
            edits.arrange([zoom](WindowState& window) {
                window.views.large().fit = PictureView::Fit::free;
                window.views.large().zoom = zoom;
            });
    }
}
