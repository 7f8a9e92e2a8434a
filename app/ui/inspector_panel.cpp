#include "ui/inspector_panel.h"

#include "ui/actions.h"
#include "ui/icons.h"
#include "ui/inspector_levels.h"
#include "ui/pass_settings.h"
#include "ui/picture_canvas.h"
#include "ui/picture_menus.h"
#include "ui/pins_panel.h"
#include "ui/scoped.h"
#include "ui/slider.h"
#include "ui/theme.h"
#include "ui/widgets.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace {
void arrange(PassView view, Edits& edits) {
    edits.arrange([view = std::move(view)](WindowState& window) { window.inspected = view; });
}

void draw_title(const Pass& pass, const Scene& scene, Edits& edits) {
    const Look& look = scene.lab.renderer()->executor().look();
    const ScopedFont strong(scene.fonts.strong);
    const float width = ImGui::GetContentRegionAvail().x - 3.0f * ImGui::GetFrameHeight() - 8.0f;
    if (begin_combo("##pass", pass.name, width)) {
        const ScopedFont text(scene.fonts.text);
        for (const Pass& other : look.passes)
            if (ImGui::Selectable(other.name.c_str(), other.name == pass.name))
                edits.arrange(
                    [name = other.name](WindowState& window) { window.inspected.pass = name; });
        ImGui::EndCombo();
    }
    const ScopedFont text(scene.fonts.text);
    ImGui::SameLine(0.0f, 4.0f);
    const std::filesystem::path file = pass.fragment.file;
    if (icon_button("##edit", Icon::edit, "Open " + file.filename().string() + " in your editor",
                    theme::dim))
        edits.add([file](Lab& lab) { lab.open_in_editor({file, 1}); });
    edits.mark("edit_pass");
    ImGui::SameLine(0.0f, 2.0f);
    if (icon_button("##save", Icon::save, help_of(ActionId::save_pass), theme::dim))
        run(ActionId::save_pass, scene, edits);
    edits.mark("save_pass");
    ImGui::SameLine(0.0f, 2.0f);
    if (icon_button("##large", scene.window.shows_pass_large ? Icon::close : Icon::large,
                    help_of(ActionId::pass_large), theme::dim))
        run(ActionId::pass_large, scene, edits);
    edits.mark("pass_large");
}

void draw_channels(const Scene& scene, Edits& edits) {
    static constexpr std::array labels{"RGB", "R", "G", "B", "A", "Y"};
    PassView view = scene.window.inspected;
    const int chosen = choice("channels", labels.data(), static_cast<int>(labels.size()),
                              static_cast<int>(view.channels), edits);
    if (chosen == static_cast<int>(view.channels))
        return;
    view.channels = static_cast<Channels>(chosen);
    arrange(view, edits);
}

void draw_exposure(const Scene& scene, Edits& edits) {
    PassView view = scene.window.inspected;
    ImGui::AlignTextToFramePadding();
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetStyle().ItemSpacing.x);
    const float number = ImGui::GetFontSize() * 4.6f;
    const float room = ImGui::GetContentRegionAvail().x - number - 6.0f;
    const SliderFacts facts{.low = -10.0,
                            .high = 10.0,
                            .step = 0.1,
                            .initial = 0.0,
                            .is_changed = view.exposure != 0.0,
                            .unit = "EV",
                            .limit = Limit{-60.0, 60.0}};
    const ScopedFont font(scene.fonts.numbers);
    Turned turned = draw_slider("##exposure", view.exposure, facts, std::max(room, 30.0f));
    tooltip(
        "Exposure of this view, in stops. Double click to type; the pass itself stays as it is.");
    edits.mark("inspector_exposure");
    ImGui::SameLine(0.0f, 4.0f);
    turned |= draw_number("##stops", view.exposure, number, facts.number());
    if (turned.is_changed)
        arrange(view, edits);
}

std::string probe_text(const Scene& scene, const Pass& pass) {
    const auto& probe = scene.window.probe;
    const auto& rgba = scene.views.probed();
    if (!probe || probe->pass != pass.name || !rgba)
        return {};
    std::string text = fmt::format("{}, {} ", probe->x, probe->y);
    for (int i = 0; i < facts_of(pass.format).channels; ++i)
        text += fmt::format(" {:.6g}", static_cast<double>((*rgba)[static_cast<std::size_t>(i)]));
    return text;
}

void draw_facts_line(const Pass& pass, Extent extent, const Scene& scene, Edits& edits) {
    const ScopedFont font(scene.fonts.numbers);
    const double zoom = inspector_view(scene.window).zoom_for(extent, scene.window.views.inspector);
    const std::string probe = probe_text(scene, pass);
    const float width = ImGui::GetContentRegionAvail().x;
    if (!probe.empty()) {
        fitted_text(probe, width, theme::text);
    } else {
        fitted_text(fmt::format("{}  {}  {}", size_text(extent), facts_of(pass.format).name,
                                zoom_text(zoom)),
                    width, theme::dim);
    }
    edits.mark("inspector_value");
}

void draw_view(const Pass& pass, Extent extent, float height, const Scene& scene, Edits& edits) {
    const float width = ImGui::GetContentRegionAvail().x;
    const Extent room = scene.device_pixels(width, height);
    if (room != scene.window.views.inspector)
        edits.arrange([room](WindowState& window) { window.views.inspector = room; });
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + width, low.y + height},
                                              theme::packed(theme::surround));
    const CanvasInput input = draw_picture_canvas({.id = "##inspected",
                                                   .image = scene.views.inspected(),
                                                   .picture = extent,
                                                   .view = inspector_view(scene.window),
                                                   .size = {width, height}},
                                                  scene);
    edits.mark("inspector");
    pin_on_click(scene, edits);
    draw_pin_marks(scene, low, extent, inspector_view(scene.window), room);
    if (input.moved && !scene.window.shows_pass_large)
        edits.arrange([view = *input.moved](WindowState& window) { window.inspected.view = view; });
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0))
        run(ActionId::pass_large, scene, edits);
    if (!input.hovered)
        return;
    const Probe probe{pass.name, static_cast<int>(std::floor((*input.hovered)[0])),
                      static_cast<int>(std::floor((*input.hovered)[1]))};
    edits.arrange([probe](WindowState& window) { window.probe = probe; });
}
}  // namespace

void draw_inspector_panel(const Scene& scene, Edits& edits) {
    if (!scene.lab.renderer() || scene.lab.renderer()->executor().plan().targets.empty())
        return;
    const Executor& executor = scene.lab.renderer()->executor();
    const int index = inspected_pass(executor.look(), scene.window);
    const Pass& pass = executor.look().passes[static_cast<std::size_t>(index)];
    if (pass.name != scene.window.inspected.pass)
        edits.arrange([name = pass.name](WindowState& window) { window.inspected.pass = name; });
    const Extent extent = executor.target(index).extent();

    draw_title(pass, scene, edits);
    draw_channels(scene, edits);
    ImGui::SameLine();
    draw_exposure(scene, edits);
    draw_inspector_levels(scene, edits);
    const float below = pass_settings_height(scene) + ImGui::GetTextLineHeightWithSpacing() +
                        ImGui::GetStyle().ItemSpacing.y * 2.0f;
    const float height = std::max(40.0f, ImGui::GetContentRegionAvail().y - below);
    draw_view(pass, extent, std::floor(height), scene, edits);
    draw_facts_line(pass, extent, scene, edits);
    draw_pass_settings(pass.name, scene, edits);
}
