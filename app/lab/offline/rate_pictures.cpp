#include "lab/offline/rate_pictures.h"

#include "gpu/objects/texels.h"

Result<void> RatePictures::show(const RateComparison& comparison, std::size_t pair) {
    const RatePair& chosen = comparison.pairs.at(pair);
    const Picture& first = comparison.picture(chosen.first);
    const Picture& second = comparison.picture(chosen.second);
    const double gain = gain_to_see(chosen.difference.largest);
    const auto texture = [](const Picture& picture) {
        return gpu::texture_of(picture, Format::rgba8, Encoding::display);
    };
    auto first_seen = texture(first);
    auto second_seen = texture(second);
    auto apart = texture(difference_picture(first, second, gain));
    for (const auto* made : {&first_seen, &second_seen, &apart})
        if (!*made)
            return fail(made->error());
    m_shown.emplace(
        Shown{pair, std::move(*first_seen), std::move(*second_seen), std::move(*apart), gain});
    return {};
}
