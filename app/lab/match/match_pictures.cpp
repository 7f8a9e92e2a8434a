#include "lab/match/match_pictures.h"

#include <algorithm>
#include <cmath>

namespace {
// Without the margins that tiles leave.
Picture cropped(const Picture& picture) {
    constexpr int margin = SampleLayout::margin;
    Picture inner{{picture.extent.width - 2 * margin, picture.extent.height - 2 * margin},
                  picture.channels,
                  picture.encoding,
                  {}};
    for (int y = 0; y < inner.extent.height; ++y) {
        const auto row =
            picture.pixels.begin() + static_cast<std::ptrdiff_t>(picture.index(margin, y + margin));
        inner.pixels.insert(inner.pixels.end(), row,
                            row + std::ptrdiff_t{inner.channels} * inner.extent.width);
    }
    return inner;
}

// From the values of samples, see SampleValues.
Picture display_picture(const Picture& picture) {
    Picture values = cropped(picture);
    values.encoding = Encoding::display;
    for (std::size_t i = 0; i + 2 < values.pixels.size(); i += 3) {
        const float luma = values.pixels[i];
        const float blue = luma + 1.772F * values.pixels[i + 1];
        const float red = luma + 1.402F * values.pixels[i + 2];
        const float green = (luma - 0.299F * red - 0.114F * blue) / 0.587F;
        for (const auto& [channel, square] : {std::pair{0, red}, {1, green}, {2, blue}})
            values.pixels[i + static_cast<std::size_t>(channel)] =
                std::sqrt(std::clamp(square, 0.0F, 1.0F));
    }
    return values;
}
}  // namespace

Result<MatchPictures> match_pictures(PhotoFit& fit, const MatchState& state) {
    auto seen = fit.seen_picture(state);
    if (!seen)
        return fail(seen.error());
    return MatchPictures{display_picture(fit.photographed_picture(state.camera)),
                         display_picture(*seen)};
}
