#include "ui/picture/hdr_button.h"

#include "lab/window/window_state.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/slider.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
constexpr const char* hdr_popup = "hdr";

std::string label_of(double peak) {
    return fmt::format("HDR {:.0f} nits", peak);
}

bool draw_light(const char* label, const char* id, const std::array<double, 2>& range,
                double initial, double& nits, Edits& edits) {
    const SliderInfo info{.low = range[0],
                          .high = range[1],
                          .scale = Scale::logarithmic,
                          .initial = initial,
                          .unit = "nits",
                          .limit = Limit{range[0], range[1]}};
    const bool is_changed =
        draw_slider(fmt::format("##{}", id).c_str(), nits, info, ImGui::GetFontSize() * 10.0f)
            .is_changed;
    edits.mark(id);
    ImGui::SameLine();
    ImGui::TextUnformatted(fmt::format("{}: {:.0f} nits", label, nits).c_str());
    return is_changed;
}

void draw_settings(const Scene& scene, Edits& edits) {
    HdrPreview hdr = scene.window.hdr;
    const HdrLight usual;
    bool is_changed = draw_light("Paper white", "hdr_paper_white", hdr_paper_whites,
                                 usual.paper_white, hdr.light.paper_white, edits);
    is_changed |= draw_light("Peak", "hdr_peak", hdr_peaks, usual.peak, hdr.light.peak, edits);
    dim_text("Tone-mapped for this display. Export the video with HDR to keep the light.");
    if (!is_changed)
        return;
    hdr.light.peak = std::max(hdr.light.peak, hdr.light.paper_white);
    edits.arrange([hdr](WindowState& window) { window.hdr = hdr; });
}
}  // namespace

float hdr_button_width(const Scene& scene) {
    if (!scene.window.hdr.is_on)
        return 0.0f;
    return ImGui::CalcTextSize(label_of(hdr_peaks[1]).c_str()).x +
           2.0f * ImGui::GetStyle().FramePadding.x;
}

void draw_hdr_button(const Scene& scene, Edits& edits) {
    if (!scene.window.hdr.is_on)
        return;
    {
        const ScopedColor color(ImGuiCol_Text, theme::accent);
        if (quiet_button(label_of(scene.window.hdr.light.peak) + "###hdr"))
            ImGui::OpenPopup(hdr_popup);
        edits.mark("hdr");
    }
    tooltip("HDR preview, tone-mapped for this display. Click for paper white and peak.");
    if (!ImGui::BeginPopup(hdr_popup))
        return;
    draw_settings(scene, edits);
    ImGui::EndPopup();
}
