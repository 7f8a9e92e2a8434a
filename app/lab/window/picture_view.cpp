#include "lab/window/picture_view.h"

#include <algorithm>
#include <cmath>

namespace {
constexpr std::array zooms{0.125, 0.25, 0.5,  1.0,  2.0,  3.0,  4.0,  6.0,  8.0,
                           12.0,  16.0, 24.0, 32.0, 48.0, 64.0, 96.0, 128.0};
}  // namespace

double PictureView::zoom_for(Extent picture, Extent view) const {
    if (fit == Fit::free || picture.is_empty() || view.is_empty())
        return zoom;
    const double all = std::min(static_cast<double>(view.width) / picture.width,
                                static_cast<double>(view.height) / picture.height);
    return fit == Fit::whole || all < 1.0 ? all : std::floor(all);
}

void PictureView::zoom_about(double at_x, double at_y, double current, double next) {
    x = std::clamp(at_x + (x - at_x) * current / next, 0.0, 1.0);
    y = std::clamp(at_y + (y - at_y) * current / next, 0.0, 1.0);
    zoom = next;
    fit = Fit::free;
}

double next_zoom(double zoom, bool is_in) {
    constexpr double slack = 1e-6;
    if (is_in) {
        const auto above = std::find_if(zooms.begin(), zooms.end(),
                                        [&](double step) { return step > zoom + slack; });
        return above == zooms.end() ? zooms.back() : *above;
    }
    const auto below = std::find_if(zooms.rbegin(), zooms.rend(),
                                    [&](double step) { return step < zoom - slack; });
    return below == zooms.rend() ? zooms.front() : *below;
}

PicturePosition position_of(const PictureView& view, Extent picture, Extent size) {
    const double zoom = view.zoom_for(picture, size);
    // A picture smaller than the view is centred. Only a cropped picture can be panned.
    const auto start = [zoom](double middle, int pixels, int room) {
        const double shown = pixels * zoom;
        return std::round(shown <= room ? (room - shown) / 2 : room / 2.0 - middle * shown);
    };
    return {start(view.x, picture.width, size.width), start(view.y, picture.height, size.height),
            zoom};
}

namespace {
struct Columns {
    double left;
    double right;
};

Columns seen_columns(const PicturePosition& position, Extent picture, Extent size) {
    return {std::max(position.left, 0.0), std::min(position.left + position.zoom * picture.width,
                                                   static_cast<double>(size.width))};
}
}  // namespace

int wipe_column(const PicturePosition& position, Extent picture, Extent size, double share) {
    const Columns columns = seen_columns(position, picture, size);
    return static_cast<int>(std::lround(columns.left + share * (columns.right - columns.left)));
}

double wipe_share(const PicturePosition& position, Extent picture, Extent size, double column) {
    const Columns columns = seen_columns(position, picture, size);
    return std::clamp((column - columns.left) / std::max(columns.right - columns.left, 1.0), 0.0,
                      1.0);
}
