#include "ui/status/status_bar.h"

#include "lab/frame/heavy_pass.h"
#include "lab/rendering/display_pace.h"
#include "ui/frame/action.h"
#include "ui/status/export_chip.h"
#include "ui/status/timings_panel.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

namespace {
// What stopped the clock, otherwise the number of problems.
std::string problems_text(const Scene& scene) {
    if (const auto& found = scene.lab.frames.nan_guard().found(); found && scene.lab.renderer)
        return fmt::format("Paused: NaN/Inf in {}",
                           scene.lab.renderer->executor().look().passes[found->pass].name);
    const std::size_t count = scene.lab.messages.problems().size();
    return count == 0   ? "No problems"
           : count == 1 ? "1 problem"
                        : fmt::format("{} problems", count);
}

int drawn_subframes(const Scene& scene) {
    const Transport& transport = scene.lab.player.transport();
    return transport.is_playing() && !transport.past().empty()
               ? transport.past().back().subframe.count
               : 1;
}

std::string pace_text(const Scene& scene) {
    const double pace = scene.pace.frames_per_second();
    if (scene.lab.renderer && scene.lab.renderer->replay().is_running())
        return "Replaying";
    if (!scene.lab.player.transport().is_playing())
        return "Paused";
    if (pace <= 0.0)
        return "Idle";
    const std::string text = fmt::format("{:.{}f} fps", pace, pace < 9.95 ? 1 : 0);
    const int subframes = drawn_subframes(scene);
    return subframes > 1 ? fmt::format("{}, {} sub-frames", text, subframes) : text;
}

// Sub-frames need every refresh of the display.
void draw_drops(const Scene& scene, Edits& edits) {
    const int drops = scene.lab.display.drops();
    if (drops == 0 || drawn_subframes(scene) < 2)
        return;
    ImGui::SameLine();
    const ScopedColor color(ImGuiCol_Text, theme::warning);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(fmt::format("{} dropped", drops).c_str());
    edits.mark("drops");
    tooltip(
        fmt::format("Refreshes of the {:.1f} Hz display without a new picture, in the last second. "
                    "Sub-frames need all of them. Try a smaller render size.",
                    scene.lab.display.refresh_rate()));
}

// How playback is reduced if the machine is too slow; "": it is fast enough.
std::string lag_text(const Player& player) {
    constexpr double hardly_seen = 0.93;
    const double share = player.transport().shown_share();
    if (!player.transport().is_playing() || share > hardly_seen)
        return {};
    return player.devices().plays_in_real_time()
               ? fmt::format("Drawing {:.0f} % of the sound", 100.0 * share)
               : fmt::format("Running at {:.2f}× speed", share);
}

void draw_lag(const Scene& scene, Edits& edits) {
    const std::string text = lag_text(scene.lab.player);
    if (text.empty())
        return;
    ImGui::SameLine();
    const ScopedColor color(ImGuiCol_Text, theme::warning);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text.c_str());
    edits.mark("lag");
    tooltip(
        "This render size is too slow for real time. Try a smaller render size or fewer "
        "points.");
}

// An unrequested suggestion, so it is only a short button.
void draw_half_size_offer(const Scene& scene, Edits& edits) {
    const auto half = scene.lab.size.chosen().halved();
    const Renderer* renderer = scene.lab.renderer;
    const double passes = renderer ? renderer->times().passes().current_total() : 0.0;
    const bool runs =
        scene.lab.player.transport().is_playing() && !scene.lab.frames.has_converged();
    const bool may_be_smaller = half && half->has_shape();
    if (!runs || !may_be_smaller || !scene.pace.is_slow_by_passes(passes))
        return;
    ImGui::SameLine();
    {
        const ScopedColor color(ImGuiCol_Text, theme::accent);
        if (quiet_button("Halve render size"))
            edits.change([half = *half](RenderSize& size, Messages& messages) {
                use_half_size(size, messages, half);
            });
    }
    edits.mark("half_size");
    tooltip(
        "Running below 30 fps for two seconds, limited by the passes. Half the render size is "
        "about four times faster.");
}

/// The cost of a frame. Only the time is highlighted if it is over the budget. Each part keeps its
/// width, so that what follows stays in place.
struct Cost {
    std::string before;
    std::string time;
    std::string after;
};

Cost cost_of(const Scene& scene) {
    const Renderer* renderer = scene.lab.renderer;
    if (!renderer || renderer->executor().plan().targets.empty())
        return {pace_text(scene), {}, {}};
    const double all = renderer->times().passes().current_total();
    const double memory =
        static_cast<double>(memory_of(renderer->executor().plan())) / (1024.0 * 1024.0);
    const int draws = renderer->executor().drawer().draw_calls();
    return {fmt::format("{:<7}  ", pace_text(scene)),
            fmt::format("{:>9}", fmt::format("{:.2f} ms", all)),
            draws == 1 ? fmt::format("   1 draw   {:.1f} MiB", memory)
                       : fmt::format("   {} draws   {:.1f} MiB", draws, memory)};
}

// One button. Over the budget, only the time is red.
void draw_cost(const Scene& scene, Edits& edits) {
    const ScopedFont font(scene.fonts.numbers);
    const Cost cost = cost_of(scene);
    const bool is_over = is_over_budget(scene);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    {
        const ScopedColor color(ImGuiCol_Text, theme::dim);
        const std::string time = is_over ? std::string(cost.time.size(), ' ') : cost.time;
        if (quiet_button(cost.before + time + cost.after + "###timings"))
            run(panel_id::timings, scene, edits);
    }
    tooltip(scene.actions.help(panel_id::timings));
    if (!is_over)
        return;
    const ImVec2 pad = ImGui::GetStyle().FramePadding;
    const ImVec2 at(start.x + pad.x + ImGui::CalcTextSize(cost.before.c_str()).x, start.y + pad.y);
    ImGui::GetWindowDrawList()->AddText(at, theme::packed(theme::problem), cost.time.c_str());
}

// What the look measures, as far as it fits.
void draw_readouts(const Scene& scene) {
    const ScopedFont font(scene.fonts.numbers);
    for (const std::string& text : scene.views.readouts().texts()) {
        const float width = ImGui::CalcTextSize(text.c_str()).x;
        if (ImGui::GetItemRectMax().x + width + 20.0f >
            ImGui::GetWindowPos().x + ImGui::GetWindowWidth())
            return;
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        dim_text(text);
    }
}

std::string pointer_text(const Scene& scene) {
    if (!scene.window.probes.pointer || !scene.views.probed())
        return {};
    const Probe& probe = *scene.window.probes.pointer;
    const auto& rgba = *scene.views.probed();
    return fmt::format("{}  {}, {}   {}  {}  {}  {}", probe.pass, probe.x, probe.y, rgba[0],
                       rgba[1], rgba[2], rgba[3]);  // all stored digits
}
}  // namespace

void draw_status_bar(const Scene& scene, Edits& edits) {
    const ScopedStyle<ImVec2> frame(ImGuiStyleVar_FramePadding,
                                    ImVec2(6.0f * scene.scale, 2.0f * scene.scale));
    const bool has_problems =
        !scene.lab.messages.problems().empty() || scene.lab.frames.nan_guard().found();
    ImGui::SetCursorPos({ImGui::GetStyle().WindowPadding.x - 6.0f * scene.scale,
                         (ImGui::GetWindowHeight() - ImGui::GetFrameHeight()) * 0.5f});
    {
        const ScopedColor color(ImGuiCol_Text, has_problems ? theme::problem : theme::dim);
        if (quiet_button(problems_text(scene) + "###problems"))
            run(panel_id::problems, scene, edits);
        tooltip(scene.actions.help(panel_id::problems));
        edits.mark("status_problems");
    }
    ImGui::SameLine();
    draw_cost(scene, edits);
    draw_export_chip(scene, edits);
    draw_lag(scene, edits);
    draw_drops(scene, edits);
    draw_half_size_offer(scene, edits);
    draw_readouts(scene);
    const std::string pointer = pointer_text(scene);
    if (pointer.empty())
        return;
    const ScopedFont font(scene.fonts.numbers);
    const float width = ImGui::CalcTextSize(pointer.c_str()).x;
    if (ImGui::GetItemRectMax().x + width + 20.0f >
        ImGui::GetWindowPos().x + ImGui::GetWindowWidth())
        return;
    same_line_right(width);
    ImGui::AlignTextToFramePadding();
    dim_text(pointer);
}
