#include "model/picture/reduced_picture.h"

#include <algorithm>
#include <cmath>

namespace {
// The first source pixel of a reduced one.
int source_start(int index, int from, int to) {
    return static_cast<int>(static_cast<long long>(index) * from / to);
}
}  // namespace

Picture reduced_picture(const Picture& picture, int side) {
    const int longest = std::max(picture.extent.width, picture.extent.height);
    if (longest <= side)
        return picture;
    const auto reduced = [&](int size) {
        const double exact = static_cast<double>(size) * side / longest;
        return std::max(1, static_cast<int>(std::lround(exact)));
    };
    Picture small{.extent = {reduced(picture.extent.width), reduced(picture.extent.height)},
                  .channels = picture.channels,
                  .encoding = picture.encoding,
                  .pixels = {}};
    const auto channels = static_cast<std::size_t>(picture.channels);
    for (int y = 0; y < small.extent.height; ++y)
        for (int x = 0; x < small.extent.width; ++x)
            for (std::size_t channel = 0; channel < channels; ++channel) {
                const int left = source_start(x, picture.extent.width, small.extent.width);
                const int right = source_start(x + 1, picture.extent.width, small.extent.width);
                const int top = source_start(y, picture.extent.height, small.extent.height);
                const int bottom = source_start(y + 1, picture.extent.height, small.extent.height);
                double sum = 0.0;
                for (int row = top; row < bottom; ++row)
                    for (int column = left; column < right; ++column)
                        sum += static_cast<double>(
                            picture.pixels[picture.index(column, row) + channel]);
                small.pixels.push_back(static_cast<float>(sum / ((bottom - top) * (right - left))));
            }
    return small;
}
