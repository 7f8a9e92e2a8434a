#include "ui/playback/transport_bar.h"

#include "lab/document/automation.h"
#include "ui/frame/action.h"
#include "ui/picture/flash_button.h"
#include "ui/picture/hdr_button.h"
#include "ui/picture/picture_menus.h"
#include "ui/picture/slot_buttons.h"
#include "ui/playback/sound_controls.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/slider.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <cmath>

namespace {
void draw_buttons(const Scene& scene, Edits& edits) {
    const bool is_playing = scene.lab.player.transport().is_playing();
    if (icon_button("##restart", Icon::restart, scene.actions.help(ActionId::restart)))
        run(ActionId::restart, scene, edits);
    edits.mark("restart");
    ImGui::SameLine(0.0f, 0.0f);
    if (icon_button("##step_back", Icon::step_back, scene.actions.help(ActionId::step_back)))
        run(ActionId::step_back, scene, edits);
    edits.mark("step_back");
    ImGui::SameLine(0.0f, 0.0f);
    if (icon_button("##play", is_playing ? Icon::pause : Icon::play,
                    scene.actions.help(ActionId::play_pause)))
        run(ActionId::play_pause, scene, edits);
    edits.mark("play");
    ImGui::SameLine(0.0f, 0.0f);
    if (icon_button("##step", Icon::step, scene.actions.help(ActionId::step)))
        run(ActionId::step, scene, edits);
    edits.mark("step");
}

void draw_speed(const Scene& scene, Edits& edits) {
    double speed = scene.lab.player.transport().speed();
    const SliderInfo info{.low = 0.01,
                          .high = 4.0,
                          .scale = Scale::logarithmic,
                          .initial = 1.0,
                          .is_changed = speed != 1.0,
                          .unit = "×",
                          .limit = Limit{0.01, 4.0}};
    ValueEdit edited = draw_slider("##speed", speed, info, ImGui::GetFontSize() * 5.0f);
    edits.mark("speed");
    tooltip("Playback speed (0.01–4×)");
    ImGui::SameLine(0.0f, 2.0f);
    {
        const ScopedFont font(scene.fonts.numbers);
        edited |=
            draw_number("##speed_number", speed, ImGui::GetFontSize() * 4.2f, number_info(info));
        edits.mark("number:speed");
    }
    if (info.is_changed) {
        ImGui::SameLine(0.0f, 0.0f);
        if (icon_button("##speed_reset", Icon::reset, "Reset to 1×", theme::dim)) {
            speed = 1.0;
            edited.is_changed = true;
        }
    }
    if (edited.is_changed)
        edits.change([speed](Player& player) { player.set_speed(speed); });
}

std::string samples_text(const Samples& samples) {
    const int enough = samples.enough.value_or(0);
    if (enough > 0 && samples.held < enough)
        return fmt::format("{}/{} samples", samples.held, enough);
    const bool is_one = samples.held == 1;
    if (enough > 0)
        return is_one ? "1 sample, done" : fmt::format("{} samples, done", samples.held);
    return is_one ? "1 sample" : fmt::format("{} samples", samples.held);
}

std::string points_text(std::size_t count) {
    return count == 1 ? "1 point" : fmt::format("{} points", count);
}

// In a narrow pane, the last facts are omitted.
void draw_info(const Scene& scene, float room) {
    const ScopedFont font(scene.fonts.numbers);
    const Transport& transport = scene.lab.player.transport();
    const Renderer* renderer = scene.lab.renderer;
    std::vector<std::string> info{clock_text(transport.time())};
    if (scene.lab.automation.recorder().is_running())
        info.emplace_back("recording automation");
    if (renderer && renderer->replay().is_running())
        info.push_back(
            fmt::format("replay {}/{}", renderer->replay().done(), renderer->replay().total()));
    else
        info.push_back(fmt::format("frame {}", transport.frame_number()));
    if (renderer && scene.lab.document && scene.lab.document->look().driven_by == Driver::signal)
        info.push_back(points_text(renderer->times().point_count()));
    if (const auto samples = scene.lab.frames.samples())
        info.push_back(samples_text(*samples));
    const float gap = ImGui::GetFontSize();
    for (std::size_t i = 0; i < info.size(); ++i) {
        const float width = ImGui::CalcTextSize(info[i].c_str()).x;
        if ((room -= width + gap) < 0.0f)
            return;
        ImGui::SameLine(0.0f, gap);
        ImGui::AlignTextToFramePadding();
        const ScopedColor color(ImGuiCol_Text, i == 0 ? theme::text : theme::dim);
        ImGui::TextUnformatted(info[i].c_str());
    }
}
}  // namespace

void draw_transport_bar(const Scene& scene, Edits& edits) {
    ImGui::SetCursorPosY((ImGui::GetWindowHeight() - ImGui::GetFrameHeight()) * 0.5f);
    draw_buttons(scene, edits);
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const auto end_of_last = [] { return ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x; };
    const float right = ImGui::GetWindowContentRegionMax().x;
    float menus = picture_menus_width(scene) + slot_buttons_width() + gap;
    float flashes = flash_button_width(scene);
    if (end_of_last() + 2.0f * gap + flashes + menus > right)
        flashes = 0.0f;  // a narrow pane
    if (flashes > 0.0f)
        menus += flashes + gap;
    float hdr = hdr_button_width(scene);
    if (end_of_last() + 2.0f * gap + hdr + menus > right)
        hdr = 0.0f;
    if (hdr > 0.0f)
        menus += hdr + gap;
    const float speed = ImGui::GetFontSize() * 11.0f;
    if (end_of_last() + speed + menus < right) {
        ImGui::SameLine(0.0f, ImGui::GetStyle().ItemSpacing.x * 2.0f);
        draw_speed(scene, edits);
    }
    const float end = end_of_last();
    draw_info(scene, right - menus - end - ImGui::GetFontSize());
    same_line_right(menus);
    if (hdr > 0.0f) {
        const float cursor = ImGui::GetCursorPosX();
        draw_hdr_button(scene, edits);
        ImGui::SameLine(cursor + hdr + gap);
    }
    if (flashes > 0.0f) {
        const float cursor = ImGui::GetCursorPosX();
        draw_flash_button(scene, edits);
        ImGui::SameLine(cursor + flashes + gap);
    }
    draw_slot_buttons(scene, edits);
    ImGui::SameLine();
    draw_picture_menus(scene, edits);
}
