#include "ui/picture/cell_texts.h"

#include "base/fitted_number.h"
#include "lab/inspect/waveform.h"
#include "model/look/format.h"
#include "ui/widgets/scoped.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {
constexpr int min_letters = 5;
constexpr int max_letters = 7;
constexpr float cell_margin = 4.0f;

struct CellNumber {
    std::array<double, 4> numbers{};
    int count = 0;
};

CellNumber shown_numbers(const std::array<float, 4>& rgba, int maximum, Channels channels) {
    if (channels == Channels::luminance)
        return {{luminance_of(rgba)}, 1};
    if (channels != Channels::color)
        return {{rgba[static_cast<std::size_t>(channels) - 1]}, 1};
    return {{rgba[0], rgba[1], rgba[2], rgba[3]}, maximum};
}

/// Layout of the numbers in a cell, in window coordinates.
struct CellLayout {
    ImVec2 start;  // of the texture's corner
    ImVec2 cell;
    ImVec2 letter;
    int letters = min_letters;
    int lines = 3;
};

CellLayout layout_of(const TexelValues::Placement& placement, const ImVec2& low,
                     const Scene& scene) {
    const auto coordinate = [&](double pixels) {
        return static_cast<float>(pixels) / scene.density;
    };
    CellLayout layout;
    layout.start = {low.x + coordinate(placement.left), low.y + coordinate(placement.top)};
    layout.cell = {coordinate(placement.texel_width), coordinate(placement.texel_height)};
    layout.letter = {ImGui::CalcTextSize("0").x, ImGui::GetTextLineHeight()};
    layout.letters =
        std::clamp(static_cast<int>((layout.cell.x - 2.0f * cell_margin) / layout.letter.x),
                   min_letters, max_letters);
    layout.lines = std::min(static_cast<int>(layout.cell.y / layout.letter.y),
                            info_of(placement.format).channels);
    return layout;
}

// Centres text in the visible part of the cell, as far as it fits.
float middle_of(float cell_start, float cell_length, float text, float view_start,
                float view_length) {
    const auto between = [&](float position, float start, float length) {
        const float low = start + 0.5f * text;
        return std::clamp(position, low, std::max(low, start + length - 0.5f * text));
    };
    const float middle = between(cell_start + 0.5f * cell_length, view_start, view_length);
    return between(middle, cell_start, cell_length);
}

/// The visible area of the view.
struct CellView {
    ImVec2 low;
    ImVec2 size;
};

// `corner`: the top left corner of the cell.
void draw_cell(const CellNumber& shown, const ImVec2& corner, const CellLayout& layout,
               const CellView& view, ImU32 ink) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    std::vector<std::string> lines;
    std::size_t longest = 0;
    for (int i = 0; i < shown.count; ++i) {
        lines.push_back(fitted_number(shown.numbers[static_cast<std::size_t>(i)], layout.letters));
        longest = std::max(longest, lines.back().size());
    }
    const float width = layout.letter.x * static_cast<float>(longest);
    const float height = layout.letter.y * static_cast<float>(shown.count);
    const float middle = middle_of(corner.x, layout.cell.x, width, view.low.x, view.size.x);
    float top = middle_of(corner.y, layout.cell.y, height, view.low.y, view.size.y) - 0.5f * height;
    for (const std::string& text : lines) {
        const float own = layout.letter.x * static_cast<float>(text.size());
        list.AddText({std::floor(middle - own * 0.5f), std::floor(top)}, ink, text.c_str());
        top += layout.letter.y;
    }
}
}  // namespace

Extent min_cell(const Scene& scene) {
    const ScopedFont font(scene.fonts.numbers);
    const float width = ImGui::CalcTextSize("0").x * min_letters + 2.0f * cell_margin;
    const float height = 3.0f * ImGui::GetTextLineHeight();
    return {static_cast<int>(std::ceil(width * scene.density)),
            static_cast<int>(std::ceil(height * scene.density))};
}

void draw_cell_texts(const TexelValues& cells, const ImVec2& low, const ImVec2& size,
                     const Scene& scene) {
    const TexelValues::Block* block = cells.block();
    if (!block)
        return;
    const ScopedFont font(scene.fonts.numbers);
    const TexelValues::Placement& placement = cells.placement();
    const CellLayout layout = layout_of(placement, low, scene);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(low, {low.x + size.x, low.y + size.y}, true);
    for (std::size_t i = 0; i < block->numbers.size(); ++i) {
        const auto& rgba = block->numbers[i];
        const int column = static_cast<int>(i) % block->count.width;
        const int row = static_cast<int>(i) / block->count.width;
        const ImVec2 corner(
            layout.start.x + layout.cell.x * static_cast<float>(block->left + column),
            layout.start.y + layout.cell.y * static_cast<float>(block->top + row));
        draw_cell(shown_numbers(rgba, layout.lines, placement.options.channels), corner, layout,
                  {low, size}, cells.is_light(i) ? IM_COL32_BLACK : IM_COL32_WHITE);
    }
    list.PopClipRect();
}
