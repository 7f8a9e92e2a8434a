#include "ui/timings_panel.h"

#include "ui/scoped.h"
#include "ui/theme.h"
#include "ui/widgets.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace {
void draw_graph(const Pace& pace, float width, float height, float scale) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::Dummy({width, height});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, {low.x + width, low.y + height}, theme::packed(theme::surround),
                       3.0f * scale);
    const auto& times = pace.milliseconds();
    const float most = std::max(34.0f, *std::max_element(times.begin(), times.end()) * 1.1f);
    for (const float mark : {16.67f, 33.33f}) {
        const float y = low.y + height * (1.0f - mark / most);
        list.AddLine({low.x, y}, {low.x + width, y}, theme::packed(theme::line));
    }
    const float bar = width / static_cast<float>(Pace::length);
    for (std::size_t i = 0; i < Pace::length; ++i) {
        const float time = times[(pace.start() + i) % Pace::length];
        const float left = low.x + bar * static_cast<float>(i);
        const float top = low.y + height * (1.0f - time / most);
        const theme::Color color = time > 34.0f ? theme::accent : theme::faint;
        if (time > 0.0f)
            list.AddRectFilled({left, top}, {left + std::max(1.0f, bar - 0.5f), low.y + height},
                               theme::packed(color));
    }
}

void draw_pass_times(const Scene& scene) {
    const Look& look = scene.lab.renderer()->executor().look();
    const std::vector<double>& times = scene.lab.renderer()->latest_pass_milliseconds();
    const double all = std::max(1e-6, std::accumulate(times.begin(), times.end(), 0.0));
    const float width = ImGui::GetContentRegionAvail().x;
    const ScopedFont font(scene.fonts.numbers);
    const float line = ImGui::GetTextLineHeight() * 1.35f;
    for (std::size_t i = 0; i < std::min(times.size(), look.passes.size()); ++i) {
        const ImVec2 low = ImGui::GetCursorScreenPos();
        ImGui::Dummy({width, line - ImGui::GetStyle().ItemSpacing.y});
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddRectFilled(
            {low.x, low.y},
            {low.x + width * static_cast<float>(times[i] / all), low.y + line - 3.0f},
            theme::packed(theme::field));
        list.AddText({low.x + 4.0f, low.y}, theme::packed(theme::label),
                     look.passes[i].name.c_str());
        const std::string time = fmt::format("{:.2f} ms", times[i]);
        list.AddText({low.x + width - ImGui::CalcTextSize(time.c_str()).x - 2.0f, low.y},
                     theme::packed(theme::text), time.c_str());
    }
}
}  // namespace

void draw_timings_panel(const Scene& scene) {
    if (!scene.lab.renderer())
        return;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float gap = ImGui::GetFontSize();
    const float half = std::floor((room.x - gap) * 0.5f);
    ImGui::BeginGroup();
    draw_graph(scene.pace, half, std::max(20.0f, room.y - ImGui::GetTextLineHeightWithSpacing()),
               scene.scale);
    dim_text(
        fmt::format("wall time of a frame; lines at 60 and 30 a second   panels {:.2f} ms of CPU",
                    scene.panel_milliseconds));
    ImGui::EndGroup();
    ImGui::SameLine(0.0f, gap);
    {  // of this part alone: what pops up above it has its own
        const ScopedStyle<ImVec2> padding(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
        ImGui::BeginChild("##passes");
    }
    draw_pass_times(scene);
    ImGui::EndChild();
}
