#include "lab/inspect/flash_limiter.h"

#include <algorithm>

namespace {
Light times(Light light, double factor) {
    for (float& number : light)
        number *= static_cast<float>(factor);
    return light;
}
}  // namespace

Result<FlashLimiter> FlashLimiter::make() {
    Views views;
    for (std::optional<View>& view : views) {
        auto cells = LightCells::make();
        if (!cells)
            return fail(cells.error());
        auto limiter = CellRateLimiter::make();
        if (!limiter)
            return fail(limiter.error());
        view.emplace(View{std::move(*cells), std::move(*limiter)});
    }
    return FlashLimiter(std::move(views));
}

void FlashLimiter::note_moving(const FlashLimit& clamp, double seconds) {
    const Light rates = clamp.rates();
    m_transition_end =
        clamp.is_on ? seconds + 1.0 / static_cast<double>(std::ranges::min(rates)) : 0.0;
}

const gpu::Texture& FlashLimiter::shown(std::size_t index, const gpu::Texture& picture,
                                        const FlashLimit& clamp, double seconds) {
    View& view = *m_views[index];
    if (!clamp.is_on || !view.cells.draw(picture, Encoding::display)) {
        view.latest.reset();
        return picture;
    }
    if (!view.latest)
        view.limiter.start_again();
    constexpr double longest = 0.1;  // s; changes over longer gaps are not flashes
    const double passed = std::min(seconds - view.latest.value_or(seconds), longest);
    view.latest = seconds;
    const gpu::Texture* limited = view.limiter.limit({.picture = picture,
                                                      .encoding = Encoding::display,
                                                      .cells = view.cells.canvas().texture(),
                                                      .maximum = times(clamp.rates(), passed)});
    return limited ? *limited : picture;
}
