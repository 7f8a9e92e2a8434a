#include "ui/passes/inspector_panel.h"

#include "lab/commands/look_commands.h"
#include "ui/frame/action.h"
#include "ui/passes/inspector_levels.h"
#include "ui/passes/pass_settings.h"
#include "ui/picture/cell_texts.h"
#include "ui/picture/picture_canvas.h"
#include "ui/picture/picture_menus.h"
#include "ui/picture/pins_panel.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/slider.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace {
void arrange(PassView view, Edits& edits) {
    edits.arrange([view = std::move(view)](WindowState& window) { window.views.inspected = view; });
}

// A list entry; a click inspects it.
void draw_choice(const TextureChoice& choice, const std::string& label, bool is_present,
                 Edits& edits) {
    if (ImGui::Selectable(label.c_str(), is_present))
        edits.arrange([choice](WindowState& window) { window.views.inspected.inspect(choice); });
    edits.mark("inspect:" + choice.label());
}

// The passes, then the source and the images, each after a separator.
void draw_picture_list(const TextureChoice& current, const Scene& scene, Edits& edits) {
    const ScopedFont text(scene.fonts.text);
    Input::From kind = Input::From::pass;
    for (const TextureChoice& choice : scene.lab.renderer->executor().textures().list()) {
        if (choice.from != kind)
            ImGui::Separator();
        kind = choice.from;
        draw_choice(choice, choice.label(), choice == current, edits);
    }
}

void draw_pictures(const InspectedTexture& inspected, const Scene& scene, float width,
                   Edits& edits) {
    const ScopedFont strong(scene.fonts.strong);
    const TextureChoice current = inspected.choice.current();
    if (begin_combo("##picture", current.label(), width)) {
        draw_picture_list(current, scene, edits);
        ImGui::EndCombo();
    }
    edits.mark("inspector_picture");
}

std::string frame_text(int ago) {
    return ago == 0 ? "This frame" : ago == 1 ? "1 frame ago" : fmt::format("{} frames ago", ago);
}

void draw_frames(const InspectedTexture& inspected, int count, float width, Edits& edits) {
    const int current = inspected.choice.frames_ago;
    ImGui::SameLine(0.0f, 4.0f);
    if (begin_combo("##frame", current == 0 ? "Now" : fmt::format("{} ago", current), width)) {
        for (int ago = 0; ago < count; ++ago) {
            TextureChoice choice = inspected.choice;
            choice.frames_ago = ago;
            draw_choice(choice, frame_text(ago), ago == current, edits);
        }
        ImGui::EndCombo();
    } else {
        tooltip("Frame to show: the current one or an earlier one that passes still read.");
    }
    edits.mark("inspector_frame");
}

void draw_levels(const InspectedTexture& inspected, int count, float width, Edits& edits) {
    const int current = inspected.choice.level;
    ImGui::SameLine(0.0f, 4.0f);
    if (begin_combo("##level", fmt::format("Mip {}", current), width)) {
        for (int level = 0; level < count; ++level) {
            TextureChoice choice = inspected.choice;
            choice.level = level;
            const Extent extent = inspected.extent_of(level);
            draw_choice(choice, fmt::format("Mip {}   {}", level, size_text(extent)),
                        level == current, edits);
        }
        ImGui::EndCombo();
    } else {
        tooltip("Mip level to show.");
    }
    edits.mark("inspector_level");
}

// Choices of picture, frame and mip level. A choice with only one entry is omitted.
void draw_choices(const InspectedTexture& inspected, float width, const Scene& scene,
                  Edits& edits) {
    const int frames = frame_count(scene.lab.renderer->executor(), inspected.choice);
    const int levels = inspected.levels();
    const float narrow = std::round(ImGui::GetFontSize() * 4.6f);
    const auto further = static_cast<float>((frames > 1 ? 1 : 0) + (levels > 1 ? 1 : 0));
    draw_pictures(inspected, scene, width - further * (narrow + 4.0f), edits);
    if (frames > 1)
        draw_frames(inspected, frames, narrow, edits);
    if (levels > 1)
        draw_levels(inspected, levels, narrow, edits);
}

void draw_title(const Pass& pass, const InspectedTexture& inspected, const Scene& scene,
                Edits& edits) {
    const bool has_shader = inspected.choice.from == Input::From::pass;
    const float buttons = (has_shader ? 3.0f : 2.0f) * ImGui::GetFrameHeight() + 8.0f;
    draw_choices(inspected, ImGui::GetContentRegionAvail().x - buttons, scene, edits);
    ImGui::SameLine(0.0f, 4.0f);
    const std::filesystem::path file = pass.fragment.file;
    if (has_shader) {
        if (icon_button("##edit", Icon::edit,
                        fmt::format("Open {} in your editor", file.filename().string()),
                        theme::dim))
            edits.change([file](LookCommands& looks) { looks.open_in_editor({file, 1}); });
        edits.mark("edit_pass");
        ImGui::SameLine(0.0f, 2.0f);
    }
    if (icon_button("##save", Icon::save, scene.actions.help(ActionId::save_pass), theme::dim))
        run(ActionId::save_pass, scene, edits);
    edits.mark("save_pass");
    ImGui::SameLine(0.0f, 2.0f);
    if (icon_button("##large", scene.window.views.shows_pass_large ? Icon::close : Icon::large,
                    scene.actions.help(ActionId::pass_large), theme::dim))
        run(ActionId::pass_large, scene, edits);
    edits.mark("pass_large");
}

void draw_channels(const Scene& scene, Edits& edits) {
    static constexpr std::array labels{"RGB", "R", "G", "B", "A", "Y"};
    PassView view = scene.window.views.inspected;
    const int chosen = choice("channels", labels.data(), static_cast<int>(labels.size()),
                              static_cast<int>(view.channels), edits);
    if (chosen == static_cast<int>(view.channels))
        return;
    view.channels = static_cast<Channels>(chosen);
    arrange(view, edits);
}

void draw_exposure(const Scene& scene, Edits& edits) {
    PassView view = scene.window.views.inspected;
    ImGui::AlignTextToFramePadding();
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetStyle().ItemSpacing.x);
    const float number = ImGui::GetFontSize() * 4.6f;
    const float room = ImGui::GetContentRegionAvail().x - number - 6.0f;
    const SliderInfo info{.low = -10.0,
                          .high = 10.0,
                          .step = 0.1,
                          .initial = 0.0,
                          .is_changed = view.exposure != 0.0,
                          .unit = "EV",
                          .limit = Limit{-60.0, 60.0}};
    const ScopedFont font(scene.fonts.numbers);
    ValueEdit edited = draw_slider("##exposure", view.exposure, info, std::max(room, 30.0f));
    tooltip(
        "Exposure of this view in stops. The pass itself doesn't change. Double-click to type a "
        "value.");
    edits.mark("inspector_exposure");
    ImGui::SameLine(0.0f, 4.0f);
    edited |= draw_number("##stops", view.exposure, number, number_info(info));
    if (edited.is_changed)
        arrange(view, edits);
}

std::string probe_text(const Scene& scene, const InspectedTexture& inspected) {
    const auto& probe = scene.window.probes.pointer;
    const auto& rgba = scene.views.probed();
    if (!probe || probe->pass != inspected.choice.label() || !rgba)
        return {};
    std::string text = fmt::format("{}, {} ", probe->x, probe->y);
    for (int i = 0; i < info_of(inspected.texture->format()).channels; ++i)
        text += fmt::format(" {:.6g}", static_cast<double>((*rgba)[static_cast<std::size_t>(i)]));
    return text;
}

void draw_info_line(const InspectedTexture& inspected, const Scene& scene, Edits& edits) {
    const Extent extent = inspected.extent();
    const ScopedFont font(scene.fonts.numbers);
    const double zoom =
        inspector_view(scene.window.views).zoom_for(extent, scene.window.views.sizes.inspector);
    const std::string probe = probe_text(scene, inspected);
    const float width = ImGui::GetContentRegionAvail().x;
    if (!probe.empty()) {
        fitted_text(probe, width, theme::text);
    } else {
        fitted_text(fmt::format("{}  {}  {}", size_text(extent),
                                info_of(inspected.texture->format()).name, zoom_text(zoom)),
                    width, theme::dim);
    }
    edits.mark("inspector_value");
}

void draw_view(const InspectedTexture& inspected, float height, const Scene& scene, Edits& edits) {
    const Extent extent = inspected.extent();
    const float width = ImGui::GetContentRegionAvail().x;
    const Extent room = device_pixels(scene, width, height);
    if (room != scene.window.views.sizes.inspector)
        edits.arrange([room](WindowState& window) { window.views.sizes.inspector = room; });
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + width, low.y + height},
                                              theme::packed(theme::surround));
    const CanvasInput input = draw_picture_canvas({.id = "##inspected",
                                                   .image = scene.views.inspector().image(),
                                                   .picture = extent,
                                                   .view = inspector_view(scene.window.views),
                                                   .size = {width, height}},
                                                  scene);
    edits.mark("inspector");
    draw_cell_texts(scene.views.texels().inspected(), low, {width, height}, scene);
    pin_on_click(scene, edits);
    draw_pin_marks(scene, low, extent, inspector_view(scene.window.views), room);
    if (input.moved && !scene.window.views.shows_pass_large)
        edits.arrange(
            [view = *input.moved](WindowState& window) { window.views.inspected.view = view; });
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0))
        run(ActionId::pass_large, scene, edits);
    if (!input.hovered)
        return;
    const Probe probe{.pass = inspected.choice.label(),
                      .x = static_cast<int>(std::floor((*input.hovered)[0])),
                      .y = static_cast<int>(std::floor((*input.hovered)[1])),
                      .extent = extent};
    edits.arrange([probe](WindowState& window) { window.probes.pointer = probe; });
}
}  // namespace

void draw_inspector_panel(const Scene& scene, Edits& edits) {
    if (!scene.lab.renderer || scene.lab.renderer->executor().plan().targets.empty())
        return;
    const Executor& executor = scene.lab.renderer->executor();
    const int index = inspected_pass(executor.look(), scene.window.views.inspected);
    const Pass& pass = executor.look().passes[static_cast<std::size_t>(index)];
    if (pass.name != scene.window.views.inspected.pass)
        edits.arrange(
            [name = pass.name](WindowState& window) { window.views.inspected.pass = name; });
    PassView view = scene.window.views.inspected;
    view.pass = pass.name;
    const auto inspected = inspected_texture(executor, view);
    if (!inspected)
        return;
    draw_title(pass, *inspected, scene, edits);
    draw_channels(scene, edits);
    ImGui::SameLine();
    draw_exposure(scene, edits);
    draw_inspector_levels(scene, edits);
    const bool is_of_pass = inspected->choice.from == Input::From::pass;
    const float below = (is_of_pass ? pass_settings_height(scene) : 0.0f) +
                        ImGui::GetTextLineHeightWithSpacing() +
                        ImGui::GetStyle().ItemSpacing.y * 2.0f;
    const float height = std::max(40.0f, ImGui::GetContentRegionAvail().y - below);
    draw_view(*inspected, std::floor(height), scene, edits);
    draw_info_line(*inspected, scene, edits);
    if (is_of_pass)
        draw_pass_settings(pass.name, scene, edits);
}
