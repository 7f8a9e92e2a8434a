#include "ui/passes/waveform_panel.h"

#include "base/fitted_number.h"
#include "ui/picture/picture_menus.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/slider.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace {
using Numbers = std::vector<std::array<float, 4>>;

// Indexed by a bit each for red, green and blue. Overlapping curves show their sum.
constexpr std::array<theme::Color, 8> mixtures{{theme::none,
                                                {0.90f, 0.34f, 0.30f, 1.0f},
                                                {0.38f, 0.80f, 0.38f, 1.0f},
                                                {0.86f, 0.80f, 0.40f, 1.0f},
                                                {0.42f, 0.56f, 0.98f, 1.0f},
                                                {0.84f, 0.46f, 0.86f, 1.0f},
                                                {0.40f, 0.80f, 0.86f, 1.0f},
                                                theme::text}};

struct WavePlot {
    ImVec2 low;  // top left
    ImVec2 size;
    PlotRange range;
    std::size_t count = 0;

    float x(std::size_t index) const {
        return low.x + size.x * (static_cast<float>(index) + 0.5f) / static_cast<float>(count);
    }
    float y(double number) const {
        return low.y + size.y * static_cast<float>(1.0 - range.share(number));
    }
    std::optional<std::size_t> index_at(float pointer) const {
        const float share = (pointer - low.x) / std::max(size.x, 1.0f);
        if (count == 0 || share < 0.0f || share >= 1.0f)
            return std::nullopt;
        return static_cast<std::size_t>(share * static_cast<float>(count));
    }
};

void draw_segment(const WavePlot& plot, std::size_t index, double from, double to,
                  const theme::Color& color) {
    ImGui::GetWindowDrawList()->AddLine(
        {plot.x(index), plot.y(from)}, {plot.x(index + 1), plot.y(to)}, theme::packed(color), 1.3f);
}

// From one texel to the next: coinciding channels are drawn once in their mixed colour.
void draw_step(const WavePlot& plot, std::size_t index, const Numbers& numbers,
               std::size_t channels) {
    const auto& from = numbers[index];
    const auto& to = numbers[index + 1];
    std::array<bool, 3> is_drawn{};
    for (std::size_t i = 0; i < channels; ++i) {
        if (is_drawn[i] || !std::isfinite(from[i]) || !std::isfinite(to[i]))
            continue;
        std::size_t mixture = 0;
        for (std::size_t k = i; k < channels; ++k) {
            constexpr float same = 0.5f;  // in window coordinates
            if (std::abs(plot.y(from[k]) - plot.y(from[i])) > same ||
                std::abs(plot.y(to[k]) - plot.y(to[i])) > same)
                continue;
            is_drawn[k] = true;
            mixture |= std::size_t{1} << k;
        }
        draw_segment(plot, index, from[i], to[i], mixtures[channels == 1 ? 7 : mixture]);
    }
}

void draw_curves(const WavePlot& plot, const Numbers& numbers, const Scene& scene) {
    const Waveform& waveform = scene.views.texels().waveform();
    const auto channels = static_cast<std::size_t>(std::clamp(waveform.channels(), 1, 3));
    for (std::size_t i = 0; i + 1 < numbers.size(); ++i) {
        const double from = luminance_of(numbers[i]);
        const double to = luminance_of(numbers[i + 1]);
        if (!std::isfinite(from) || !std::isfinite(to))
            ImGui::GetWindowDrawList()->AddLine({plot.x(i), plot.low.y},
                                                {plot.x(i), plot.low.y + plot.size.y},
                                                theme::packed(theme::problem));
        else if (scene.window.probes.plots_luminance && channels > 1)
            draw_segment(plot, i, from, to, theme::text);
        else
            draw_step(plot, i, numbers, channels);
    }
}

// Grid lines with numbers on both axes; the horizontal axis starts at 0.
void draw_scales(const WavePlot& plot) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float line = ImGui::GetTextLineHeight();
    const float right = plot.low.x + plot.size.x;
    const float bottom = plot.low.y + plot.size.y;
    const int maximum = std::max(2, static_cast<int>(plot.size.y / (1.5f * line)));
    for (const double number : axis_ticks(plot.range, maximum)) {
        const float y = std::floor(plot.y(number));
        const std::string text = short_number(number);
        list.AddLine({plot.low.x, y}, {right, y}, theme::packed(theme::line));
        list.AddText({plot.low.x - ImGui::CalcTextSize(text.c_str()).x - 6.0f, y - line * 0.5f},
                     theme::packed(theme::dim), text.c_str());
    }
    if (plot.count < 2)
        return;
    const int columns = std::max(2, static_cast<int>(plot.size.x / (6.0f * line)));
    for (const double number : axis_ticks({0.0, static_cast<double>(plot.count - 1)}, columns)) {
        if (number != std::floor(number))
            continue;
        const float x = std::floor(plot.x(static_cast<std::size_t>(number)));
        const std::string text = fmt::format("{:.0f}", number);
        const float width = ImGui::CalcTextSize(text.c_str()).x;
        list.AddLine({x, plot.low.y}, {x, bottom}, theme::packed(theme::line));
        list.AddText({std::min(x - width * 0.5f, right - width), bottom + 2.0f},
                     theme::packed(theme::dim), text.c_str());
    }
}

// The values under the pointer, or instructions for drawing a line.
void draw_readout(const std::optional<std::size_t>& index, const Scene& scene) {
    const Waveform& waveform = scene.views.texels().waveform();
    if (!index || *index >= waveform.numbers().size()) {
        const std::size_t count = waveform.numbers().size();
        dim_text(count == 1 ? fmt::format("1 texel of {}", waveform.name())
                            : fmt::format("{} texels of {}", count, waveform.name()));
        return wrapped_dim_text(
            "Drag the line on the picture, or its ends. Shift-drag to draw a new one.");
    }
    const ScopedFont font(scene.fonts.numbers);
    const auto& rgba = waveform.numbers()[*index];
    const auto [x, y] = waveform.texel(*index);
    dim_text(fmt::format("{}, {}", x, y));
    const std::array<double, 4> numbers{rgba[0], rgba[1], rgba[2], luminance_of(rgba)};
    static constexpr std::array names{"R", "G", "B", "Y"};
    static constexpr std::array colors{mixtures[1], mixtures[2], mixtures[4], mixtures[7]};
    const std::size_t count =
        waveform.channels() < 3 ? static_cast<std::size_t>(waveform.channels()) : numbers.size();
    const float column = ImGui::CalcTextSize("R 0.0000000 ").x;
    for (std::size_t i = 0; i < count; ++i) {
        constexpr int letters = 9;
        if (i % 2 == 1)
            ImGui::SameLine(column);  // of the group
        const ScopedColor ink(ImGuiCol_Text, count == 1 ? mixtures[7] : colors[i]);
        ImGui::TextUnformatted(
            fmt::format("{} {}", names[i], fitted_number(numbers[i], letters)).c_str());
    }
}

void draw_row(const Scene& scene, Edits& edits) {
    const Extent picture = large_extent(scene);
    const int last = std::max(picture.height - 1, 0);
    double row = scene.window.probes.scan_line.row(picture).value_or(
        scene.window.probes.scan_line.start.texel(picture)[1]);
    ImGui::AlignTextToFramePadding();
    dim_text("Row");
    ImGui::SameLine();
    const ScopedFont font(scene.fonts.numbers);
    const NumberInfo info{false, {}, Limit{0.0, static_cast<double>(last)}, true};
    if (draw_number("##row", row, ImGui::CalcTextSize("00000 ").x, info).is_changed)
        edits.arrange([row = static_cast<int>(row), height = picture.height](WindowState& window) {
            window.probes.scan_line = ScanLine::along_row(row, height);
        });
    edits.mark("scan_row");
    tooltip("Click to type a row, counted from the top. The line then spans the whole row.");
}

void draw_controls(const std::optional<std::size_t>& index, const Scene& scene, Edits& edits) {
    static constexpr std::array labels{"RGB", "Y"};
    const int current = scene.window.probes.plots_luminance ? 1 : 0;
    const int chosen =
        choice("waveform", labels.data(), static_cast<int>(labels.size()), current, edits);
    if (chosen != current)
        edits.arrange(
            [chosen](WindowState& window) { window.probes.plots_luminance = chosen == 1; });
    ImGui::SameLine();
    draw_row(scene, edits);
    draw_readout(index, scene);
}
}  // namespace

void draw_waveform_panel(const Scene& scene, Edits& edits) {
    const Waveform& waveform = scene.views.texels().waveform();
    const Numbers& numbers = waveform.numbers();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float letter = ImGui::GetFontSize();
    const float controls = 12.0f * letter;
    const float gutter = 3.4f * letter;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const ImVec2 corner = ImGui::GetCursorPos();
    const WavePlot plot{{start.x + gutter, start.y + 0.6f * letter},
                        {std::max(room.x - gutter - controls - letter, letter),
                         std::max(room.y - 2.0f * letter, letter)},
                        waveform.range(),
                        numbers.size()};
    ImGui::SetCursorScreenPos(plot.low);
    ImGui::InvisibleButton("##plot", plot.size);
    edits.mark("waveform");
    const auto index =
        ImGui::IsItemHovered() ? plot.index_at(ImGui::GetIO().MousePos.x) : std::nullopt;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 high(plot.low.x + plot.size.x, plot.low.y + plot.size.y);
    list.AddRectFilled(plot.low, high, theme::packed(theme::surround));
    {
        const ScopedFont font(scene.fonts.numbers);
        draw_scales(plot);
    }
    list.PushClipRect(plot.low, high, true);
    draw_curves(plot, numbers, scene);
    if (index) {
        list.AddLine({plot.x(*index), plot.low.y}, {plot.x(*index), high.y},
                     theme::packed(theme::faint));
        edits.arrange([position = (static_cast<double>(*index) + 0.5) /
                                  static_cast<double>(plot.count)](WindowState& window) {
            window.probes.scan_position = position;
        });
    }
    list.PopClipRect();
    ImGui::SetCursorPos({corner.x + room.x - controls, corner.y});
    ImGui::BeginGroup();
    draw_controls(index, scene, edits);
    ImGui::EndGroup();
}
