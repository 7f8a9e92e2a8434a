#include "ui/status/timings_panel.h"

#include "ui/widgets/scoped.h"
#include "ui/widgets/slider.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
constexpr double mebibyte = 1024.0 * 1024.0;

struct Plot {
    ImVec2 low;
    ImVec2 size;
    float maximum;  // milliseconds at the top

    float y(double milliseconds) const {
        const auto share = static_cast<float>(milliseconds) / maximum;
        return low.y + size.y * (1.0f - std::clamp(share, 0.0f, 1.0f));
    }
};

Plot begin_plot(float width, float height, float maximum, float scale) {
    const Plot plot{ImGui::GetCursorScreenPos(), {width, height}, maximum};
    ImGui::Dummy({width, height});
    ImGui::GetWindowDrawList()->AddRectFilled(plot.low, {plot.low.x + width, plot.low.y + height},
                                              theme::packed(theme::surround), 3.0f * scale);
    return plot;
}

void draw_line(const Plot& plot, double milliseconds, const theme::Color& color) {
    const float y = plot.y(milliseconds);
    ImGui::GetWindowDrawList()->AddLine({plot.low.x, y}, {plot.low.x + plot.size.x, y},
                                        theme::packed(color));
}

/// A bar for each number, from the oldest at the left to the newest at the right end.
template <class Time, class Color>
void draw_bars(const Plot& plot, std::size_t count, std::size_t room, Time time, Color color) {
    const float bar = plot.size.x / static_cast<float>(room);
    for (std::size_t i = 0; i < count; ++i) {
        const double milliseconds = time(i);
        const float left = plot.low.x + bar * static_cast<float>(room - count + i);
        if (milliseconds > 0.0)
            ImGui::GetWindowDrawList()->AddRectFilled(
                {left, plot.y(milliseconds)},
                {left + std::max(1.0f, bar - 0.5f), plot.low.y + plot.size.y},
                theme::packed(color(milliseconds)));
    }
}

void draw_pace(const Pace& pace, float width, float height, float scale) {
    const auto& times = pace.milliseconds();
    const float maximum = std::max(34.0f, *std::max_element(times.begin(), times.end()) * 1.1f);
    const Plot plot = begin_plot(width, height, maximum, scale);
    for (const double mark : {16.67, 33.33})
        draw_line(plot, mark, theme::line);
    draw_bars(
        plot, Pace::length, Pace::length,
        [&](std::size_t i) {
            return static_cast<double>(times[(pace.start() + i) % Pace::length]);
        },
        [](double time) { return time > 34.0 ? theme::accent : theme::faint; });
}

void draw_budget(const PassTimes& times, double budget, float width, float height, float scale) {
    const double maximum = std::max(budget * 1.5, times.longest_total() * 1.1);
    const Plot plot = begin_plot(width, height, static_cast<float>(maximum), scale);
    draw_bars(
        plot, times.frames(), PassTimes::length, [&](std::size_t i) { return times.total(i); },
        [&](double time) { return time > budget ? theme::problem : theme::faint; });
    draw_line(plot, budget, theme::text);
}

float budget_width(double budget) {
    return ImGui::CalcTextSize((short_number(budget) + " ms").c_str()).x +
           ImGui::GetFontSize() * 0.6f;
}

void draw_budget_text(const Scene& scene, Edits& edits) {
    const double current = scene.lab.renderer->times().passes().current_total();
    double budget = scene.window.frame_rate.budget_milliseconds;
    const ScopedFont font(scene.fonts.numbers);
    ImGui::AlignTextToFramePadding();
    const ScopedColor color(ImGuiCol_Text, is_over_budget(scene) ? theme::problem : theme::dim);
    ImGui::TextUnformatted(fmt::format("GPU {:.2f} of", current).c_str());
    ImGui::SameLine();
    const NumberInfo info{.is_changed = false, .unit = "ms", .limit = Limit{0.1, 1000.0}};
    if (draw_number("##budget", budget, budget_width(budget), info).is_changed)
        edits.arrange(
            [budget](WindowState& window) { window.frame_rate.budget_milliseconds = budget; });
    edits.mark("budget");
    tooltip("GPU time budget for all passes of a frame. Click to type it.");
}

/// One line: the pass name, a plot of its latest frames, its time and its memory.
void draw_pass(std::size_t pass, const Scene& scene, float maximum, float height) {
    const Executor& executor = scene.lab.renderer->executor();
    const PassTimes& times = scene.lab.renderer->times().passes();
    const float width = ImGui::GetContentRegionAvail().x;
    const float memory_width = ImGui::CalcTextSize("0000.0 MiB").x;
    const float time_width = ImGui::CalcTextSize("000.00 ms").x;
    const float gap = ImGui::GetFontSize() * 0.5f;
    const float name_width = std::min(ImGui::GetFontSize() * 9.0f, width * 0.3f);
    const float left = name_width + gap;
    const float room = std::max(width - left - memory_width - time_width - 2.0f * gap, 20.0f);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + left);
    const Plot plot = begin_plot(room, height - 3.0f * scene.scale, maximum, scene.scale);
    draw_bars(
        plot, times.frames(), PassTimes::length,
        [&](std::size_t i) { return times.milliseconds(pass, i); },
        [](double) { return theme::filled; });
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto write = [&](float right, const std::string& text, const theme::Color& color) {
        list.AddText({right - ImGui::CalcTextSize(text.c_str()).x, plot.low.y},
                     theme::packed(color), text.c_str());
    };
    const std::string name = elided_to_width(executor.look().passes[pass].name, name_width);
    list.AddText({start.x, plot.low.y}, theme::packed(theme::label), name.c_str());
    const double latest = scene.lab.renderer->times().pass_milliseconds()[pass];
    write(plot.low.x + room + gap + time_width, fmt::format("{:.2f} ms", latest), theme::text);
    const auto bytes = static_cast<double>(memory_of(executor.plan().targets[pass]));
    write(start.x + width, fmt::format("{:.1f} MiB", bytes / mebibyte), theme::dim);
}

void draw_passes(const Scene& scene) {
    const Renderer& renderer = *scene.lab.renderer;
    const PassTimes& times = renderer.times().passes();
    const std::size_t count = std::min({times.passes(), renderer.executor().plan().targets.size(),
                                        renderer.times().pass_milliseconds().size()});
    double maximum = 0.01;
    for (std::size_t pass = 0; pass < count; ++pass)
        for (std::size_t frame = 0; frame < times.frames(); ++frame)
            maximum = std::max(maximum, times.milliseconds(pass, frame));
    const ScopedFont font(scene.fonts.numbers);
    const ScopedStyle<ImVec2> spacing(ImGuiStyleVar_ItemSpacing, ImVec2(0.0f, 3.0f * scene.scale));
    const float line = ImGui::GetTextLineHeight();  // the sum adds one more
    const float fitting = ImGui::GetContentRegionAvail().y / static_cast<float>(count + 1);
    const float height = std::clamp(fitting - 3.0f * scene.scale, line * 0.9f, line * 1.35f);
    for (std::size_t pass = 0; pass < count; ++pass)
        draw_pass(pass, scene, static_cast<float>(maximum), height);
    const auto bytes = static_cast<double>(memory_of(renderer.executor().plan()));
    const std::string sum = fmt::format("{:.1f} MiB total", bytes / mebibyte);
    ImGui::SetCursorPosX(ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(sum.c_str()).x);
    dim_text(sum);
}
}  // namespace

namespace {
std::string wall_text(const Scene& scene) {
    const double pace = scene.pace.frames_per_second();
    return pace > 0.0 ? fmt::format("{:.1f} ms per frame (lines: 60 and 30 Hz)", 1000.0 / pace)
                      : std::string("Lines: 60 and 30 Hz");
}
}  // namespace

bool is_over_budget(const Scene& scene) {
    const LabParts& lab = scene.lab;
    return lab.renderer && lab.player.transport().is_playing() && !lab.frames.has_converged() &&
           lab.renderer->times().passes().current_total() >
               scene.window.frame_rate.budget_milliseconds;
}

void draw_timings_panel(const Scene& scene, Edits& edits) {
    if (!scene.lab.renderer || scene.lab.renderer->executor().plan().targets.empty())
        return;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float gap = ImGui::GetFontSize();
    const float maximum = ImGui::GetFontSize() * 26.0f;  // each frame is a few pixels wide
    const float width = std::min(std::floor((room.x - 2.0f * gap) * 0.27f), maximum);
    const float height = std::max(20.0f, room.y - ImGui::GetFrameHeightWithSpacing());
    ImGui::BeginGroup();
    draw_pace(scene.pace, width, height, scene.scale);
    ImGui::AlignTextToFramePadding();
    fitted_text(wall_text(scene), width, theme::dim);
    tooltip(fmt::format(
        "Time from frame to frame. The panels took {:.2f} ms of CPU time in the last one.",
        scene.frame.panel_milliseconds));
    ImGui::EndGroup();
    ImGui::SameLine(0.0f, gap);
    ImGui::BeginGroup();
    draw_budget(scene.lab.renderer->times().passes(), scene.window.frame_rate.budget_milliseconds,
                width, height, scene.scale);
    draw_budget_text(scene, edits);
    ImGui::EndGroup();
    ImGui::SameLine(0.0f, gap);
    {  // only for this child: popups above it keep their own padding
        const ScopedStyle<ImVec2> padding(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
        ImGui::BeginChild("##passes", {0.0f, 0.0f}, false, ImGuiWindowFlags_NavFlattened);
    }
    draw_passes(scene);
    ImGui::EndChild();
}
