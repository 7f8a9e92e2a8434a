#include "lab/window/window_state.h"

#include <algorithm>
#include <cmath>

namespace {
constexpr std::array zooms{0.125, 0.25, 0.5,  1.0,  2.0,  3.0,  4.0,  6.0,  8.0,
                           12.0,  16.0, 24.0, 32.0, 48.0, 64.0, 96.0, 128.0};
}  // namespace

double FrameRate::frame_seconds(double display_rate) const {
    return 1.0 / (cap > 0.0 ? cap : std::clamp(display_rate, 24.0, 240.0));
}

std::size_t OutputState::monitor_for(std::size_t count, std::size_t panels) const {
    if (monitor && *monitor < count)
        return *monitor;
    return count > 1 && panels == 0 ? 1 : 0;
}

double PictureView::zoom_for(Extent picture, Extent view) const {
    if (fit == Fit::free || picture.is_empty() || view.is_empty())
        return zoom;
    const double all = std::min(static_cast<double>(view.width) / picture.width,
                                static_cast<double>(view.height) / picture.height);
    return fit == Fit::all || all < 1.0 ? all : std::floor(all);
}

void PictureView::zoom_about(double at_x, double at_y, double present, double next) {
    x = std::clamp(at_x + (x - at_x) * present / next, 0.0, 1.0);
    y = std::clamp(at_y + (y - at_y) * present / next, 0.0, 1.0);
    zoom = next;
    fit = Fit::free;
}

void PassView::look_into(const std::string& name) {
    pass = name;
    other.reset();
}

void PassView::look_into(const TextureChoice& choice) {
    if (choice.from == Input::From::pass)
        pass = choice.name;
    other = choice.is_present_pass() ? std::nullopt : std::optional(choice);
}

void PassView::fit(const Statistics& statistics) {
    levels = fitted_levels(statistics);
    exposure = 0.0;
}

void PassView::reset_levels() {
    levels = {};
    exposure = 0.0;
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

Columns seen_columns(const PicturePosition& place, Extent picture, Extent size) {
    return {std::max(place.left, 0.0),
            std::min(place.left + place.zoom * picture.width, static_cast<double>(size.width))};
}
}  // namespace

int wipe_column(const PicturePosition& place, Extent picture, Extent size, double share) {
    const Columns columns = seen_columns(place, picture, size);
    return static_cast<int>(std::lround(columns.left + share * (columns.right - columns.left)));
}

double wipe_share(const PicturePosition& place, Extent picture, Extent size, double column) {
    const Columns columns = seen_columns(place, picture, size);
    return std::clamp((column - columns.left) / std::max(columns.right - columns.left, 1.0), 0.0,
                      1.0);
}

std::array<int, 2> Pin::texel(Extent extent) const {
    const auto place = [](double share, int length) {
        return std::clamp(static_cast<int>(share * length), 0, std::max(length - 1, 0));
    };
    return {place(x, extent.width), place(y, extent.height)};
}

Pin pin_at(const Probe& probe) {
    return {(probe.x + 0.5) / std::max(probe.extent.width, 1),
            (probe.y + 0.5) / std::max(probe.extent.height, 1)};
}

ScanLine ScanLine::along_row(int row, int height) {
    const double y = (row + 0.5) / std::max(height, 1);
    return {{0.0, y}, {1.0, y}};
}

std::optional<int> ScanLine::row(Extent extent) const {
    const int first = start.texel(extent)[1];
    return first == end.texel(extent)[1] ? std::optional(first) : std::nullopt;
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
