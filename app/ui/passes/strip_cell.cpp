#include "ui/passes/strip_cell.h"

#include "lab/frame/heavy_pass.h"
#include "ui/passes/pass_edit_items.h"
#include "ui/passes/strip_text.h"
#include "ui/picture/pass_switch_items.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace {
void draw_image(const ViewImage& image, const Rect& rect, float density, float part,
                bool is_faint) {
    const float width = static_cast<float>(image.extent.width) / density;
    const float height = static_cast<float>(image.extent.height) / density;
    const float visible_width = std::min(width, rect.width);
    const float left = width > 0.0f ? part * (1.0f - visible_width / width) : 0.0f;
    const float right = width > 0.0f ? left + visible_width / width : 1.0f;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 start(rect.left + std::floor((rect.width - visible_width) * 0.5f),
                       rect.top + std::floor((rect.height - height) * 0.5f));
    list.AddRectFilled({rect.left, rect.top}, {rect.right(), rect.bottom()},
                       theme::packed(theme::surround));
    if (image.handle != 0)
        list.AddImage(texture_id(image.handle), start, {start.x + visible_width, start.y + height},
                      {left, 1.0f}, {right, 0.0f},
                      is_faint ? IM_COL32(255, 255, 255, 96) : IM_COL32_WHITE);
}

// Covers the 16 stops below the ceiling: filled up to the mean, with a line at the peak. It is not
// drawn for lower peaks, such as below the ceiling of 32-bit floats.
void draw_meter(const TargetLevel& gain, const ImVec2& low, const ImVec2& high) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto at = [&](double number) {
        return low.x + (high.x - low.x) * static_cast<float>(meter_ratio(number, gain.ceiling));
    };
    list.AddRectFilled(low, high, theme::packed(theme::field));
    list.AddRectFilled(low, {at(gain.mean), high.y}, theme::packed(theme::filled));
    const theme::Color color = strip_text::is_clipped(gain) ? theme::warning : theme::label;
    const float peak = std::clamp(at(gain.peak), low.x + 2.0f, high.x);
    if (gain.peak > 0.0)
        list.AddRectFilled({peak - 2.0f, low.y}, {peak, high.y}, theme::packed(color));
}

// Logarithmic, from 0.01 %.
void draw_change(const PassChange& change, const ImVec2& low, const ImVec2& high) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float width = (high.x - low.x) * static_cast<float>(change_ratio(change));
    list.AddRectFilled(low, high, theme::packed(theme::field));
    list.AddRectFilled(low, {low.x + width, high.y}, theme::packed(theme::accent));
}

std::string cell_help(const StripPass& pass) {
    const double mebibytes = static_cast<double>(memory_of(pass.target)) / (1024.0 * 1024.0);
    std::vector<std::string> lines{
        pass.pass.name, fmt::format("{}, {:.1f} MiB", strip_text::info(pass.target), mebibytes)};
    const std::string time = strip_text::time(pass.milliseconds);
    if (pass.milliseconds > heavy_pass_milliseconds)
        lines.push_back(fmt::format("{}, slows down the window", time));
    else if (!time.empty())
        lines.push_back(time);
    if (pass.gain)
        lines.push_back(strip_text::gain_help(*pass.gain));
    if (!pass.state.empty())
        lines.push_back(pass.state);
    lines.emplace_back(
        "Double-click to view large. Right-click to bypass, solo, freeze, move or remove.");
    return fmt::format("{}", fmt::join(lines, "\n"));
}

// The clickable area over the height of the strip. Returns whether it is hovered.
bool draw_button(const StripPass& pass, const ImVec2& size, const Scene& scene, Edits& edits) {
    if (ImGui::InvisibleButton("##pass", size))
        edits.arrange([name = pass.pass.name](WindowState& window) {
            window.views.inspected.inspect(name);
            window.layout.panels.show(panel_id::inspector);
        });
    edits.mark("pass:" + pass.pass.name);
    const bool is_hovered = ImGui::IsItemHovered();
    if (is_hovered && ImGui::IsMouseDoubleClicked(0))
        edits.arrange([](WindowState& window) { window.views.shows_pass_large = true; });
    if (ImGui::BeginPopupContextItem("##switches")) {
        draw_pass_switches(pass.pass.name, scene, edits);
        ImGui::Separator();
        draw_pass_edits(pass.pass.name, scene, edits);
        ImGui::EndPopup();
    } else {
        tooltip(cell_help(pass));
    }
    return is_hovered;
}
}  // namespace

void draw_strip_cell(const StripPass& pass, const Scene& scene, const Rect& rect, float text_height,
                     float part, Edits& edits) {
    const ScopedId id(static_cast<int>(pass.index));
    const bool is_hovered =
        draw_button(pass, {rect.width, rect.height + text_height}, scene, edits);
    draw_image(scene.views.strip().thumbnail(pass.index), rect, scene.density, part,
               pass.state.ends_with("not drawn") || scene.views.strip().is_stale(pass.index));
    const ImVec2 low(rect.left, rect.top);
    const ImVec2 high(rect.right(), rect.bottom());
    if (!pass.change && pass.gain && headroom_stops(*pass.gain).value_or(0.0) <= meter_stops)
        draw_meter(*pass.gain, {low.x, high.y - 4.0f * scene.scale}, high);
    if (pass.is_chosen || is_hovered)
        ImGui::GetWindowDrawList()->AddRect(
            low, high, theme::packed(pass.is_chosen ? theme::accent : theme::faint));
    if (pass.change)
        draw_change(*pass.change, {low.x, high.y - 6.0f * scene.scale}, high);
}
