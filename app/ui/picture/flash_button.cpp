#include "ui/picture/flash_button.h"

#include "ui/widgets/scoped.h"
#include "ui/widgets/slider.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

namespace {
constexpr const char* popup = "flashes";

std::string label_of(const Scene& scene) {
    const Flashes flashes = scene.views.main().flashes();
    const int maximum = flashes.maximum();
    const bool is_limited = scene.window.flashes.limit.is_on;
    if (maximum == 1)
        return is_limited ? "1 flash/s · limited" : "1 flash/s";
    return is_limited ? fmt::format("{} flashes/s · limited", maximum)
                      : fmt::format("{} flashes/s", maximum);
}

// A fixed width, so that neighbouring items do not move.
std::string widest_label(const Scene& scene) {
    return scene.window.flashes.limit.is_on ? "00 flashes/s · limited" : "00 flashes/s";
}

theme::Color color_of(const Flashes& flashes) {
    if (flashes.is_beyond_limit())
        return theme::problem;
    return flashes == Flashes{} ? theme::dim : theme::label;
}

void draw_counts(const Scene& scene) {
    const Flashes flashes = scene.views.main().flashes();
    ImGui::TextUnformatted(
        fmt::format("Flashes in the last second: {} general, {} red", flashes.general, flashes.red)
            .c_str());
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 26.0f);
    wrapped_dim_text(
        "WCAG 2.3.1 allows three of each per second. A flash counts where it covers more than a "
        "quarter of a 10-degree field. Here that field is a third of the picture's width and "
        "height, as if the picture filled the screen.");
    ImGui::PopTextWrapPos();
}

void draw_clamp(const Scene& scene, Edits& edits) {
    FlashLimit clamp = scene.window.flashes.limit;
    bool is_changed = ImGui::Checkbox("Flash limiter", &clamp.is_on);
    edits.mark("comfort");
    tooltip(
        "Limits how fast large areas of the picture change brightness on screen. Presets, saved "
        "pictures and renders aren't affected.");
    if (clamp.is_on) {
        const SliderInfo info{.low = FlashLimit::lowest,
                              .high = FlashLimit::highest,
                              .initial = FlashLimit::default_maximum,
                              .unit = "of full brightness per second",
                              .limit = Limit{FlashLimit::lowest, FlashLimit::highest}};
        is_changed |=
            draw_slider("##comfort", clamp.max_per_second, info, ImGui::GetFontSize() * 10.0f)
                .is_changed;
        edits.mark("comfort_rate");
        ImGui::SameLine();
        ImGui::TextUnformatted(
            fmt::format("{:.2f} of full brightness per second", clamp.max_per_second).c_str());
    }
    if (is_changed)
        edits.arrange([clamp](WindowState& window) { window.flashes.limit = clamp; });
}
}  // namespace

float flash_button_width(const Scene& scene) {
    if (!scene.window.flashes.shows_meter)
        return 0.0f;
    return ImGui::CalcTextSize(widest_label(scene).c_str()).x +
           2.0f * ImGui::GetStyle().FramePadding.x;
}

void draw_flash_button(const Scene& scene, Edits& edits) {
    if (!scene.window.flashes.shows_meter)
        return;
    {
        const ScopedColor color(ImGuiCol_Text, color_of(scene.views.main().flashes()));
        if (quiet_button(label_of(scene) + "###flashes"))
            ImGui::OpenPopup(popup);
        edits.mark("flashes");
    }
    tooltip("Flashes in the last second (WCAG 2.3.1). Click for the limits and the flash limiter.");
    if (ImGui::BeginPopup(popup)) {
        draw_counts(scene);
        ImGui::Separator();
        draw_clamp(scene, edits);
        ImGui::EndPopup();
    }
}
