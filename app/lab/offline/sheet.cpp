#include "lab/offline/sheet.h"

#include "io/pictures/caption.h"
#include "model/look/color.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace {
constexpr int largest_side = 16384;  // px

/// The layout of a sheet, in pixels.
struct Layout {
    Extent cell;
    int columns = 1;
    int rows = 1;
    int letters = 16;  // height of the captions
    int gap = 16;      // between cells and around them
    int foot = 30;     // below a picture, for its caption

    Extent sheet() const {
        return {gap + columns * (cell.width + gap), gap + rows * (cell.height + foot)};
    }
    int left(int index) const { return gap + index % columns * (cell.width + gap); }
    int top(int index) const { return gap + index / columns * (cell.height + foot); }
};

Layout layout_of(Extent picture, int count, int columns) {
    Layout layout{.cell = picture};
    layout.columns = std::min(columns, count);
    layout.rows = (count + layout.columns - 1) / layout.columns;
    layout.letters = std::clamp(layout.cell.height / 15, 11, 28);
    layout.gap = layout.letters;
    layout.foot = layout.letters * 5 / 2;
    return layout;
}

float display_value(const Picture& picture, int x, int y, int channel) {
    const std::size_t at = picture.index(x, y);
    const int there = picture.channels < 3 ? 0 : channel;
    const float value = picture.pixels[at + static_cast<std::size_t>(there)];
    if (!(value > 0.0f))  // also NaN
        return 0.0f;
    const double clamped = std::min(static_cast<double>(value), 1.0);
    return static_cast<float>(picture.encoding == Encoding::linear ? srgb_encode(clamped)
                                                                   : clamped);
}

void copy(const Picture& from, Picture& to, int left, int top) {
    for (int y = 0; y < from.extent.height; ++y)
        for (int x = 0; x < from.extent.width; ++x) {
            const std::size_t at = to.index(left + x, top + y);
            for (int channel = 0; channel < 3; ++channel)
                to.pixels[at + static_cast<std::size_t>(channel)] =
                    display_value(from, x, y, channel);
        }
}
}  // namespace

Result<void> check_sheet(Extent picture, int count, int columns) {
    const Extent extent = layout_of(picture, count, columns).sheet();
    if (extent.width > largest_side || extent.height > largest_side)
        return fail({{},
                     0,
                     fmt::format("the sheet would be {} x {} px; the limit is {} px per side",
                                 extent.width, extent.height, largest_side)});
    return {};
}

Result<Picture> sheet_of(const std::vector<SheetCell>& cells, int columns) {
    assert(!cells.empty() && columns > 0);
    const Extent size = cells.front().picture.extent;
    const int count = static_cast<int>(cells.size());
    if (auto fits = check_sheet(size, count, columns); !fits)
        return fail(fits.error());
    const Layout layout = layout_of(size, count, columns);
    const Extent extent = layout.sheet();
    constexpr float paper = 0.09f;
    Picture sheet{extent, 3, Encoding::display, {}};
    sheet.pixels.assign(
        static_cast<std::size_t>(extent.width) * static_cast<std::size_t>(extent.height) * 3,
        paper);
    for (int i = 0; i < count; ++i) {
        const SheetCell& cell = cells[static_cast<std::size_t>(i)];
        copy(cell.picture, sheet, layout.left(i), layout.top(i));
        const CaptionPosition position{
            .left = layout.left(i),
            .baseline = layout.top(i) + layout.cell.height + layout.letters * 3 / 2,
            .width = layout.cell.width,
            .height = layout.letters};
        if (auto written = draw_caption(sheet, position, cell.caption); !written)
            return fail(written.error());
    }
    return sheet;
}
