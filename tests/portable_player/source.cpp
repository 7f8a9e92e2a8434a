// The source of a look: docs/portable.md, "Source".
#include "portable_player/error.h"
#include "portable_player/pictures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <sstream>

namespace fs = std::filesystem;

namespace {
// Joins the positions along one side at which neighbouring pixels differ.
struct Changes {
    int divisor;  // greatest common divisor of the positions and the length
    int count;
};

template <class Differ>
Changes changes_along(int length, const Differ& differ) {
    Changes changes{length, 0};
    for (int position = 1; position < length && changes.divisor > 1; ++position)
        if (differ(position)) {
            changes.divisor = std::gcd(changes.divisor, position);
            ++changes.count;
        }
    return changes;
}

bool rows_differ(const Picture& picture, int y) {
    const auto length = 4 * static_cast<std::size_t>(picture.width);
    const float* row = picture.pixel(0, y);
    return !std::equal(row, row + length, picture.pixel(0, y - 1));
}

bool columns_differ(const Picture& picture, int x) {
    for (int y = 0; y < picture.height; ++y)
        if (!std::equal(picture.pixel(x, y), picture.pixel(x, y) + 4, picture.pixel(x - 1, y)))
            return true;
    return false;
}

// How many times each original pixel is repeated per side.
int prescale_of(const Picture& picture) {
    constexpr int least_changes = 8;
    const Changes rows =
        changes_along(picture.height, [&](int y) { return rows_differ(picture, y); });
    const Changes columns =
        changes_along(picture.width, [&](int x) { return columns_differ(picture, x); });
    if (rows.count < least_changes || columns.count < least_changes)
        return 1;
    const int common = std::gcd(rows.divisor, columns.divisor);
    int times = 8;
    while (common % times != 0)
        --times;
    return times;
}

Picture without_repetitions(const Picture& picture, int times) {
    Picture original = new_picture(std::max(picture.width / times, 1),
                                   std::max(picture.height / times, 1), picture.is_display);
    for (int y = 0; y < original.height; ++y)
        for (int x = 0; x < original.width; ++x)
            std::copy_n(picture.pixel(std::min(x * times + times / 2, picture.width - 1),
                                      std::min(y * times + times / 2, picture.height - 1)),
                        4, original.pixel(x, y));
    return original;
}

// A picture of this size with the other in its middle, each pixel repeated. It is black elsewhere.
struct Frame {
    int width;
    int height;
    int repeat_x = 1;
    int repeat_y = 1;

    int left(const Picture& picture) const {
        return static_cast<int>(std::floor((width - picture.width * repeat_x) / 2.0));
    }
    int top(const Picture& picture) const {
        return static_cast<int>(std::floor((height - picture.height * repeat_y) / 2.0));
    }
};

Picture framed(const Picture& picture, const Frame& frame) {
    Picture made = new_picture(frame.width, frame.height, picture.is_display);
    for (int y = 0; y < made.height; ++y)
        for (int x = 0; x < made.width; ++x) {
            const int from_x = x - frame.left(picture);
            const int from_y = y - frame.top(picture);
            const bool is_inside = from_x >= 0 && from_x < picture.width * frame.repeat_x &&
                                   from_y >= 0 && from_y < picture.height * frame.repeat_y;
            made.pixel(x, y)[3] = 1.0F;
            if (is_inside)
                std::copy_n(picture.pixel(from_x / frame.repeat_x, from_y / frame.repeat_y), 4,
                            made.pixel(x, y));
        }
    return made;
}

int rounded(double length) {
    return std::max(static_cast<int>(std::lround(length)), 1);
}

Frame frame_of(const std::string& fit, const Picture& picture, double aspect, const Size& size) {
    const double view_width = size[0];
    const double view_height = size[1];
    if (fit == "stretch")
        return {picture.width, picture.height};
    if (fit == "integer") {
        const double times =
            std::min(view_width / (picture.width * aspect), view_height / picture.height);
        const int tall = std::max(1, static_cast<int>(times));
        return {size[0], size[1], rounded(tall * aspect), tall};
    }
    const double shape = view_width / view_height / aspect;
    const bool is_wider = picture.height * shape > picture.width;
    if (is_wider == (fit == "whole"))
        return {rounded(picture.height * shape), picture.height};
    return {picture.width, rounded(picture.width / shape)};
}

Raster raster_of(int count, int shown, int first, int length) {
    return {static_cast<double>(first) / length, static_cast<double>(shown) / count / length,
            static_cast<double>(count)};
}

std::string numbered(const std::string& name, int number) {
    std::array<char, 4096> text{};
    const std::size_t percent = name.find('%', name.rfind('/') + 1);
    const std::size_t end = name.find('d', percent);
    const int digits = end > percent + 1 ? std::stoi(name.substr(percent + 1)) : 1;
    std::snprintf(text.data(), text.size(), "%s%0*d%s", name.substr(0, percent).c_str(), digits,
                  number, name.substr(end + 1).c_str());
    return text.data();
}
}  // namespace

Source::Source(const Description& description, const Size& size) : m_size(size) {
    read_settings(description.source->content);
    if (m_name.starts_with("pattern:"))
        throw Error("has the source '" + m_name + "', which only Afterglow can draw");
    m_name = file_in(description.folder, m_name);
    find_sequence();
    if (m_prescaled == 0)
        m_prescaled = prescale_of(load_picture(file(0)));
}

void Source::read_settings(const std::string& content) {
    std::istringstream pieces(content);
    std::string piece;
    std::getline(pieces, m_name, ',');
    while (std::getline(pieces, piece, ',')) {
        const std::string key = piece.substr(0, piece.find('='));
        const std::string value = piece.substr(std::min(key.size() + 1, piece.size()));
        if (key == "fit")
            m_fit = value;
        else if (key == "aspect")
            m_aspect = std::stod(value);
        else if (key == "shape" && value != "square")
            m_shape = {std::stod(value), std::stod(value.substr(value.find(':') + 1))};
        else if (key == "prescaled")
            m_prescaled = value == "auto" ? 0 : std::stoi(value);
        else if (key == "rate" && std::stod(value) > 0.0)
            m_rate = std::stod(value);
        else if (key == "loop")
            m_loops = value == "on";
    }
}

void Source::find_sequence() {
    constexpr int most_numbers = 100000;
    const bool is_named = m_name.find('%', m_name.rfind('/') + 1) != std::string::npos;
    m_is_sequence = is_named && !fs::exists(m_name);
    while (m_is_sequence && m_first < most_numbers && !fs::exists(file(0)))
        ++m_first;
    while (m_is_sequence && fs::exists(file(m_count)))
        ++m_count;
}

std::string Source::file(int number) const {
    return m_is_sequence ? numbered(m_name, m_first + number) : m_name;
}

int Source::number_at(double seconds) const {
    constexpr double rounding = 1e-6;
    const int number = std::max(static_cast<int>(std::ceil(seconds * m_rate - rounding)) - 1, 0);
    return m_loops ? number % m_count : std::min(number, m_count - 1);
}

PlacedPicture Source::placed(int number) const {
    Picture picture = load_picture(file(number));
    if (m_prescaled > 1)
        picture = without_repetitions(picture, m_prescaled);
    double aspect = m_aspect;
    if (m_shape[1] > 0.0)
        aspect = m_shape[0] / m_shape[1] * picture.height / picture.width;
    const Frame frame = frame_of(m_fit, picture, aspect, m_size);
    return {
        framed(picture, frame),
        raster_of(picture.height, picture.height * frame.repeat_y, frame.top(picture),
                  frame.height),
        raster_of(picture.width, picture.width * frame.repeat_x, frame.left(picture), frame.width),
        m_fit == "integer" ? 1.0 : aspect};
}
