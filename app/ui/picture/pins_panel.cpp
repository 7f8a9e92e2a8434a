#include "ui/picture/pins_panel.h"

#include "ui/frame/action.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/slider.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

namespace {
// In columns, so that values of passes are easy to compare.
std::string value_text(const std::array<float, 4>& rgba, Format format) {
    std::string text;
    for (int i = 0; i < info_of(format).channels; ++i)
        text += fmt::format("{:>9}", short_number(rgba[static_cast<std::size_t>(i)]));
    return text;
}

void remove(std::size_t pin, Edits& edits) {
    edits.arrange([pin](WindowState& window) {
        if (pin < window.probes.pins.size())
            window.probes.pins.erase(window.probes.pins.begin() + static_cast<std::ptrdiff_t>(pin));
    });
}

// The pixel of the picture at each pin. The tooltip of a value has the pixel of its pass.
void draw_heads(const Scene& scene, Edits& edits) {
    const Extent picture = scene.lab.size.extent();
    ImGui::TableNextRow();
    for (std::size_t i = 0; i < scene.window.probes.pins.size(); ++i) {
        ImGui::TableSetColumnIndex(static_cast<int>(i) + 1);
        const auto [x, y] = scene.window.probes.pins[i].texel(picture);
        const ScopedId id(static_cast<int>(i));
        ImGui::AlignTextToFramePadding();
        dim_text(fmt::format("{:>9}   {}, {}", i + 1, x, y));
        ImGui::SameLine();
        if (icon_button("##remove", Icon::close, "Remove pin", theme::dim))
            remove(i, edits);
        edits.mark(fmt::format("unpin:{}", i + 1));
    }
}

void draw_pin_row(std::size_t index, const Scene& scene) {
    const Executor& executor = scene.lab.renderer->executor();
    const Pass& pass = executor.look().passes[index];
    const Extent extent = executor.target(static_cast<int>(index)).extent();
    ImGui::TableNextRow();
    ImGui::TableSetColumnIndex(0);
    dim_text(pass.name);
    for (std::size_t i = 0; i < scene.window.probes.pins.size(); ++i) {
        ImGui::TableSetColumnIndex(static_cast<int>(i) + 1);
        const std::array<float, 4>* value = scene.views.pins().value(i, index);
        if (!value)
            continue;
        ImGui::TextUnformatted(value_text(*value, pass.format).c_str());
        const auto [x, y] = scene.window.probes.pins[i].texel(extent);
        tooltip(fmt::format("{}: pixel ({}, {}) of {}", pass.name, x, y, size_text(extent)));
    }
}
}  // namespace

void draw_pins_panel(const Scene& scene, Edits& edits) {
    if (!scene.lab.renderer || scene.lab.renderer->executor().plan().targets.empty())
        return;
    if (scene.window.probes.pins.empty()) {
        dim_text(fmt::format(
            "Press {} over the picture to pin a pixel. Its value in every pass is listed here.",
            scene.actions.key(ActionId::pin)));
        return;
    }
    const ScopedFont font(scene.fonts.numbers);
    const ScopedStyle<ImVec2> padding(ImGuiStyleVar_CellPadding, ImVec2(4.0f * scene.scale, 1.0f));
    const int columns = static_cast<int>(scene.window.probes.pins.size()) + 1;
    if (!ImGui::BeginTable("##pins", columns, ImGuiTableFlags_SizingFixedFit))
        return;
    draw_heads(scene, edits);
    for (std::size_t i = 0; i < scene.lab.renderer->executor().look().passes.size(); ++i)
        draw_pin_row(i, scene);
    ImGui::EndTable();
}

void pin_on_click(const Scene& scene, Edits& edits) {
    if (ImGui::IsItemHovered() && ImGui::GetIO().KeyCtrl && ImGui::IsMouseClicked(0))
        run(ActionId::pin, scene, edits);
}

void draw_pin_marks(const Scene& scene, const ImVec2& low, Extent picture, const PictureView& view,
                    Extent room) {
    const bool is_shown = scene.window.layout.panels.shows(panel_id::pins);
    if (!is_shown || picture.is_empty())
        return;
    const PicturePosition position = position_of(view, picture, room);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float radius = 4.0f * scene.scale;
    for (std::size_t i = 0; i < scene.window.probes.pins.size(); ++i) {
        const Pin& pin = scene.window.probes.pins[i];
        const ImVec2 at(
            low.x + static_cast<float>(position.left + pin.x * picture.width * position.zoom) /
                        scene.density,
            low.y + static_cast<float>(position.top + pin.y * picture.height * position.zoom) /
                        scene.density);
        const std::string number = std::to_string(i + 1);
        for (const auto& [color, shift] :
             {std::pair{theme::surround, 1.0f}, std::pair{theme::accent, 0.0f}}) {
            list.AddCircle({at.x + shift, at.y + shift}, radius, theme::packed(color), 16, 1.5f);
            list.AddText({at.x + radius + 2.0f + shift, at.y - ImGui::GetFontSize() + shift},
                         theme::packed(color), number.c_str());
        }
    }
}
