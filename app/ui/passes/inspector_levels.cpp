#include "ui/passes/inspector_levels.h"

#include "ui/frame/action.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/slider.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

namespace {
// The three colours add up to a grey.
constexpr theme::Color red{0.50f, 0.12f, 0.12f, 1.0f};
constexpr theme::Color green{0.10f, 0.40f, 0.10f, 1.0f};
constexpr theme::Color blue{0.10f, 0.18f, 0.48f, 1.0f};
constexpr theme::Color grey{0.55f, 0.55f, 0.55f, 1.0f};

float strip_height() {
    return std::round(ImGui::GetFontSize() * 3.2f);
}

void set_levels(const Levels& levels, Edits& edits) {
    edits.arrange([levels](WindowState& window) { window.views.inspected.levels = levels; });
}

// The sum of the colours of several channels, as in the waveform.
theme::Color sum_of(const std::vector<std::size_t>& channels, std::size_t count) {
    static constexpr std::array colors{red, green, blue};
    if (count == 1)
        return grey;
    theme::Color sum{0.0f, 0.0f, 0.0f, 1.0f};
    for (const std::size_t channel : channels) {
        sum.red += colors[channel].red;
        sum.green += colors[channel].green;
        sum.blue += colors[channel].blue;
    }
    return sum;
}

// Heights are logarithmic, so that a single texel in a dark picture is visible.
void draw_bars(const Histogram& histogram, const ImVec2& low, const ImVec2& high) {
    const double maximum = std::log1p(static_cast<double>(histogram.highest()));
    if (maximum <= 0.0 || histogram.bins.empty())
        return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::size_t count = histogram.bins.size();
    const std::size_t places = histogram.bins.front().size();
    const float width = (high.x - low.x) / static_cast<float>(places);
    std::vector<std::size_t> channels;
    for (std::size_t i = 0; i < places; ++i) {
        channels.resize(count);
        std::iota(channels.begin(), channels.end(), std::size_t{0});
        std::ranges::sort(channels, std::greater(),
                          [&](std::size_t channel) { return histogram.bins[channel][i]; });
        const float left = low.x + width * static_cast<float>(i);
        float bottom = high.y;
        // From the bottom: the part below the lowest bar has the colour of all channels.
        for (; !channels.empty(); channels.pop_back()) {
            const double share =
                std::log1p(static_cast<double>(histogram.bins[channels.back()][i])) / maximum;
            const float top = high.y - (high.y - low.y) * static_cast<float>(share);
            if (top < bottom)
                list.AddRectFilled({left, top}, {left + width, bottom},
                                   theme::packed(sum_of(channels, count)));
            bottom = std::min(bottom, top);
        }
    }
}

void draw_ramp(const ImVec2& low, const ImVec2& high) {
    constexpr int steps = 48;
    const float width = (high.x - low.x) / steps;
    for (int i = 0; i < steps; ++i) {
        const auto rgb = false_color((i + 0.5) / steps);
        const ImVec4 color(static_cast<float>(rgb[0]), static_cast<float>(rgb[1]),
                           static_cast<float>(rgb[2]), 1.0f);
        const float left = low.x + width * static_cast<float>(i);
        ImGui::GetWindowDrawList()->AddRectFilled({left, low.y}, {left + width, high.y},
                                                  theme::packed(color));
    }
}

// Markers for values below or above the range.
void draw_ends(const Histogram& histogram, const ImVec2& low, const ImVec2& high, float width) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (histogram.below > 0)
        list.AddRectFilled(low, {low.x + width, high.y}, IM_COL32(0, 130, 130, 255));
    if (histogram.above > 0)
        list.AddRectFilled({high.x - width, low.y}, high, IM_COL32(230, 184, 0, 255));
}

// Drawn over the bars, because NaN and infinity are rare but important.
void draw_flaws(const Statistics& all, const ImVec2& at) {
    std::string text;
    if (all.not_a_number > 0)
        text += fmt::format("NaN {}  ", all.not_a_number);
    if (all.infinite > 0)
        text += fmt::format("Inf {}  ", all.infinite);
    if (text.empty())
        return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, theme::packed(theme::surround));
    list.AddText(at, theme::packed(theme::problem), text.c_str());
}

void draw_text(const Statistics& all, const ImVec2& at, const Scene& scene) {
    const ScopedFont font(scene.fonts.numbers);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImVec2 position = at;
    const auto word = [&](const std::string& text, const theme::Color& color) {
        list.AddText(position, theme::packed(color), text.c_str());
        position.x += ImGui::CalcTextSize(text.c_str()).x;
    };
    const auto number = [&](const char* label, double value) {
        word(label, theme::dim);
        word(short_number(value), theme::text);
    };
    if (all.finite > 0) {
        number("min ", all.minimum);
        number("  max ", all.maximum);
        number("  mean ", all.mean);
    }
    draw_flaws(all, {at.x, at.y + ImGui::GetTextLineHeight()});
}

std::string share_text(std::uint32_t part, std::uint32_t whole) {
    return short_number(std::round(1000.0 * part / std::max(whole, 1u)) / 10.0) + " %";
}

std::string help_text(const Histogram& histogram) {
    std::string text =
        "Histogram from black to white, with logarithmic heights. Min, max, mean, NaN and Inf "
        "cover every texel. Drag the left half to set black, the right half to set white. "
        "Double-click to fit both.";
    if (histogram.finite > 0)
        text += fmt::format("\nBelow black: {}. Above white: {}.",
                            share_text(histogram.below, histogram.finite),
                            share_text(histogram.above, histogram.finite));
    return text;
}

// Dragging moves the nearer end; the other end stays.
void drag(const ImVec2& low, const ImVec2& high, const Scene& scene, Edits& edits) {
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemHovered())
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0))
        return run(ActionId::fit_levels, scene, edits);
    if (!ImGui::IsItemActive() || io.MouseDelta.x == 0.0f)
        return;
    const Levels& levels = scene.window.views.inspected.levels;
    // A drag over half the strip halves or doubles the range, independent of the number of steps.
    const double part = io.MouseDelta.x / (high.x - low.x);
    const double range = levels.white - levels.black;
    if (io.MouseClickedPos[0].x < (low.x + high.x) * 0.5f)
        set_levels({levels.white - range * std::exp2(-2.0 * part), levels.white}, edits);
    else
        set_levels({levels.black, levels.black + range * std::exp2(2.0 * part)}, edits);
}

void draw_strip(const Scene& scene, Edits& edits) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::InvisibleButton("##histogram", {width, strip_height()});
    const ImVec2 high = ImGui::GetItemRectMax();
    const Histogram histogram = scene.views.inspector().histogram();
    drag(low, high, scene, edits);
    tooltip(help_text(histogram));
    edits.mark("histogram");
    ImGui::GetWindowDrawList()->AddRectFilled(low, high, theme::packed(theme::surround));
    const float legend = scene.window.views.inspected.is_false_color ? 4.0f * scene.scale : 0.0f;
    draw_bars(histogram, {low.x, low.y + ImGui::GetFontSize() * 1.1f}, {high.x, high.y - legend});
    if (legend > 0.0f)
        draw_ramp({low.x, high.y - legend}, high);
    draw_ends(histogram, low, {high.x, high.y - legend}, 2.0f * scene.scale);
    if (const auto& all = scene.views.inspector().statistics())
        draw_text(*all, {low.x + 5.0f * scene.scale, low.y + 2.0f * scene.scale}, scene);
}

// The value of one end. Click to type it.
void draw_end(const char* name, double value, const Scene& scene, Edits& edits, float width) {
    const bool is_black = std::string_view(name) == "black";
    const ScopedFont font(scene.fonts.numbers);
    const NumberInfo info{value != (is_black ? 0.0 : 1.0), {}, Limit{-1e9, 1e9}, false};
    const std::string id = std::string("##") + name;
    if (draw_number(id.c_str(), value, width, info).is_changed) {
        const Levels& levels = scene.window.views.inspected.levels;
        set_levels(is_black ? with_black(levels, value) : with_white(levels, value), edits);
    }
    tooltip(is_black ? "Stored value shown as black. Click to type it."
                     : "Stored value shown as white. Click to type it.");
    edits.mark(std::string("level:") + name);
}

float end_width(double value, const Scene& scene) {
    const ScopedFont font(scene.fonts.numbers);
    return std::max(ImGui::GetFontSize() * 3.0f,
                    ImGui::CalcTextSize(short_number(value).c_str()).x + 8.0f);
}

struct Switch {
    ActionId action;
    Icon icon;
    const char* name;
    bool is_on;
};

void draw_switches(const Scene& scene, Edits& edits) {
    const PassView& view = scene.window.views.inspected;
    const std::array switches{
        Switch{ActionId::fit_levels, Icon::fit, "fit_levels", false},
        Switch{ActionId::reset_levels, Icon::reset, "reset_levels", view.has_levels()},
        Switch{ActionId::mark_flaws, Icon::flaws, "mark_flaws", view.marks_flaws},
        Switch{ActionId::mark_clipping, Icon::clipping, "mark_clipping", view.marks_clipping},
        Switch{ActionId::false_color, Icon::colors, "false_color", view.is_false_color}};
    for (std::size_t i = 0; i < switches.size(); ++i) {
        const Switch& one = switches[i];
        const ScopedId id(one.name);
        if (i > 0)
            ImGui::SameLine(0.0f, (i == 2 ? 10.0f : 2.0f) * scene.scale);
        if (icon_button("##switch", one.icon, scene.actions.help(one.action),
                        one.is_on ? theme::accent : theme::dim))
            run(one.action, scene, edits);
        edits.mark(one.name);
    }
}
}  // namespace

void draw_inspector_levels(const Scene& scene, Edits& edits) {
    draw_strip(scene, edits);
    const Levels& levels = scene.window.views.inspected.levels;
    const float side = ImGui::GetFrameHeight();
    const float room = ImGui::GetContentRegionAvail().x;
    const float left = ImGui::GetCursorPosX();
    draw_end("black", levels.black, scene, edits, end_width(levels.black, scene));
    const float switches = 5.0f * side + 16.0f * scene.scale;
    ImGui::SameLine(left + (room - switches) * 0.5f);
    draw_switches(scene, edits);
    const float width = end_width(levels.white, scene);
    ImGui::SameLine(left + room - width);
    draw_end("white", levels.white, scene, edits, width);
}
