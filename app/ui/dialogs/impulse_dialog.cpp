#include "ui/dialogs/impulse_dialog.h"

#include "lab/jobs/background_jobs.h"
#include "ui/dialogs/dialog_frame.h"
#include "ui/dialogs/work_dialog.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace {
constexpr std::array<theme::Color, 8> hues{{{0.95f, 0.75f, 0.35f, 1.0f},
                                            {0.45f, 0.80f, 0.95f, 1.0f},
                                            {0.55f, 0.85f, 0.50f, 1.0f},
                                            {0.95f, 0.55f, 0.55f, 1.0f},
                                            {0.75f, 0.65f, 0.95f, 1.0f},
                                            {0.95f, 0.60f, 0.85f, 1.0f},
                                            {0.60f, 0.75f, 0.65f, 1.0f},
                                            {0.60f, 0.60f, 1.00f, 1.0f}}};
constexpr double minimum = 0.001;  // floor of the plot, relative to the peak

const theme::Color& hue_of(std::size_t pass) {
    return hues[pass % hues.size()];
}

Pin flash_pin(const Scene& scene) {
    if (!scene.window.probes.pins.empty())
        return scene.window.probes.pins.front();
    return scene.window.probes.pointer ? pin_at(*scene.window.probes.pointer) : Pin{};
}

// The time until the slowest pass has decayed to the floor, plus a margin.
double shown_seconds(const ImpulseResponse& response) {
    double longest = 0.0;
    for (const PassImpulse& pass : response.passes) {
        if (pass.decay.peak <= 0.0)
            continue;
        if (!pass.decay.to_thousandth)
            return response.seconds.back();
        longest = std::max(longest, pass.decay.peak_seconds + *pass.decay.to_thousandth);
    }
    const double min_seconds = 4.0 / response.request.fps;
    return std::min(std::max(longest * 1.1, min_seconds), response.seconds.back());
}

struct ImpulsePlot {
    ImVec2 low;  // top left
    ImVec2 size;
    double seconds;

    ImVec2 at(double time, double share) const {
        const double down =
            std::clamp(std::log10(std::max(share, minimum)) / std::log10(minimum), 0.0, 1.0);
        return {low.x + size.x * static_cast<float>(time / seconds),
                low.y + size.y * static_cast<float>(down)};
    }
};

void draw_grid(const ImpulsePlot& plot, ImDrawList& list) {
    const ImU32 line = ImGui::GetColorU32(theme::line);
    const ImU32 color = ImGui::GetColorU32(theme::dim);
    for (const auto& [share, label] : {std::pair{1.0, "Peak"}, std::pair{0.1, "10 %"},
                                       std::pair{0.01, "1 %"}, std::pair{0.001, "0.1 %"}}) {
        const ImVec2 left = plot.at(0.0, share);
        list.AddLine(left, {left.x + plot.size.x, left.y}, line);
        const float up = share <= minimum ? ImGui::GetFontSize() : 0.0f;
        const float width = ImGui::CalcTextSize(label).x;
        list.AddText({left.x + plot.size.x - width - 2.0f, left.y - up}, color, label);
    }
    const double step = std::pow(10.0, std::floor(std::log10(plot.seconds)));
    const double every = plot.seconds / step < 2.5 ? step / 2.0 : step;
    for (int i = 1; every * i < plot.seconds; ++i) {
        const ImVec2 top = plot.at(every * i, 1.0);
        list.AddLine(top, {top.x, top.y + plot.size.y}, line);
        const std::string label = fmt::format("{:g} ms", std::round(every * i * 1e4) / 10.0);
        list.AddText({top.x + 2.0f, top.y + plot.size.y + 2.0f}, color, label.c_str());
    }
}

using Curve = std::vector<ImVec2>;

Curve curve_of(const PassImpulse& impulse, const std::vector<double>& seconds,
               const ImpulsePlot& plot) {
    Curve curve;
    for (std::size_t i = 0; i < impulse.light.size() && impulse.decay.peak > 0.0; ++i) {
        if (seconds[i] > plot.seconds)
            break;
        curve.push_back(plot.at(seconds[i], impulse.light[i] / impulse.decay.peak));
        if (impulse.light[i] < minimum * impulse.decay.peak)
            break;
    }
    return curve;
}

bool lies_on(const Curve& one, const Curve& other) {
    constexpr float hardly_seen = 1.5f;
    return !one.empty() && std::ranges::equal(one, other, [](const ImVec2& a, const ImVec2& b) {
        return std::abs(a.y - b.y) < hardly_seen;
    });
}

// All curves near the pointer; curves can overlap.
std::vector<std::size_t> curves_at_pointer(const std::vector<Curve>& curves) {
    constexpr float reach = 6.0f;
    std::vector<std::size_t> found;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (!ImGui::IsItemHovered())
        return found;
    for (std::size_t pass = 0; pass < curves.size(); ++pass)
        for (std::size_t i = 1; i < curves[pass].size(); ++i) {
            const ImVec2 near = ImLineClosestPoint(curves[pass][i - 1], curves[pass][i], mouse);
            if (std::hypot(near.x - mouse.x, near.y - mouse.y) > reach)
                continue;
            found.push_back(pass);
            break;
        }
    return found;
}

// Dashes keep overlapping curves visible.
void draw_fall(const Curve& curve, ImU32 color, float thickness, bool is_dashed, ImDrawList& list) {
    if (!is_dashed) {
        list.AddPolyline(curve.data(), static_cast<int>(curve.size()), color, ImDrawFlags_None,
                         thickness);
        return;
    }
    constexpr float dash = 5.0f;
    float done = 0.0f;
    for (std::size_t i = 1; i < curve.size(); ++i) {
        const ImVec2 step(curve[i].x - curve[i - 1].x, curve[i].y - curve[i - 1].y);
        const auto parts = std::max(1.0f, std::round(std::hypot(step.x, step.y) / dash));
        for (float part = 0.0f; part < parts; part += 1.0f, done += 1.0f)
            if (std::fmod(done, 2.0f) < 1.0f)
                list.AddLine({curve[i - 1].x + step.x * part / parts,
                              curve[i - 1].y + step.y * part / parts},
                             {curve[i - 1].x + step.x * (part + 1.0f) / parts,
                              curve[i - 1].y + step.y * (part + 1.0f) / parts},
                             color, thickness);
    }
}

void draw_plot(const ImpulseResponse& response, Edits& edits) {
    const float height = ImGui::GetFontSize() * 14.0f;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::Dummy({width, height + ImGui::GetFontSize() * 1.4f});
    edits.mark("impulse_plot");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImpulsePlot plot{low, {width, height}, shown_seconds(response)};
    list.AddRectFilled(low, {low.x + width, low.y + height}, ImGui::GetColorU32(theme::field));
    draw_grid(plot, list);
    std::vector<Curve> curves;
    for (const PassImpulse& pass : response.passes)
        curves.push_back(curve_of(pass, response.seconds, plot));
    const std::vector<std::size_t> named = curves_at_pointer(curves);
    for (std::size_t pass = 0; pass < curves.size(); ++pass) {
        const bool is_named = std::ranges::count(named, pass) > 0;
        const auto before = curves.begin() + static_cast<std::ptrdiff_t>(pass);
        const bool is_dashed = std::any_of(curves.begin(), before, [&](const Curve& other) {
            return lies_on(curves[pass], other);
        });
        draw_fall(curves[pass], ImGui::GetColorU32(hue_of(pass)), is_named ? 3.0f : 1.5f, is_dashed,
                  list);
    }
    std::string names;
    for (const std::size_t pass : named)
        names += (names.empty() ? "" : "\n") + response.passes[pass].pass;
    if (!names.empty())
        ImGui::SetTooltip("%s", names.c_str());
}

std::string time_text(const std::optional<double>& seconds) {
    if (!seconds)
        return "–";
    return *seconds < 1.0 ? fmt::format("{:.1f} ms", *seconds * 1000.0)
                          : fmt::format("{:.3f} s", *seconds);
}

void cell(const std::string& text) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(text.c_str());
}

void draw_times(const ImpulseResponse& response, const Scene& scene, Edits& edits) {
    const ScopedColor stripe(ImGuiCol_TableRowBgAlt, theme::field);
    if (!ImGui::BeginTable("##impulse", 6, ImGuiTableFlags_RowBg))
        return;
    for (const char* heading : {"Pass", "Peak", "To 10 %", "To 1 %", "To 0.1 %", "Half-life"})
        ImGui::TableSetupColumn(heading);
    ImGui::TableHeadersRow();
    for (std::size_t i = 0; i < response.passes.size(); ++i) {
        const PassImpulse& pass = response.passes[i];
        ImGui::TableNextColumn();
        {
            const ScopedColor color(ImGuiCol_Text, hue_of(i));
            ImGui::TextUnformatted(pass.pass.c_str());
        }
        edits.mark("impulse:" + pass.pass);
        const ScopedFont font(scene.fonts.numbers);
        cell(pass.decay.peak > 0.0 ? fmt::format("{:.4g}", pass.decay.peak) : "no light");
        cell(time_text(pass.decay.to_tenth));
        cell(time_text(pass.decay.to_hundredth));
        cell(time_text(pass.decay.to_thousandth));
        cell(time_text(pass.decay.half_life));
    }
    ImGui::EndTable();
}

void draw_response(const ImpulseResponse& response, const Scene& scene, Edits& edits) {
    draw_plot(response, edits);
    draw_times(response, scene, edits);
    ImGui::Spacing();
    const Pin& pin = response.request.pin;
    wrapped_dim_text(fmt::format(
        "A one-frame flash in the dark at {:.1f} %, {:.1f} % of the picture, rendered at {} and "
        "{:g} Hz. Values are linear light of the brightest channel, minus the level before the "
        "flash. Times count from the peak. A dash means longer than {:g} s. Half-lives come from "
        "an exponential fitted down to 1 %.",
        pin.x * 100.0, pin.y * 100.0, size_text(response.size), response.request.fps,
        response.request.seconds));
}
}  // namespace

void fire_impulse(const Scene& scene, Edits& edits) {
    edits.change([pin = flash_pin(scene)](BackgroundJobs& jobs) { jobs.fire_impulse(pin); });
    edits.show({.kind = Dialog::Kind::impulse});
}

void draw_impulse_dialog(const Scene& scene, Edits& edits) {
    const DialogFrame frame("Impulse response", 44.0f, scene, edits);
    if (!frame.is_open())
        return;
    const auto draw = [&](const auto& outcome) { draw_response(outcome, scene, edits); };
    draw_work(
        scene.lab.jobs.impulse(), "Measuring the impulse response…", draw,
        [](BackgroundJobs& jobs) { jobs.cancel_impulse(); }, edits);
}
