#pragma once

#include "bench/figure.h"
#include "bench/wanted.h"
#include "lab/offline/offline.h"

#include <array>

namespace bench {

using ValueTexts = std::vector<std::pair<std::string, std::string>>;

/// A Phosphor preset as the program draws it, and the article's points for the plain programs.
struct Engine {
    Offline offline;
    Player player;

    Engine(const std::string& preset, const ValueTexts& values, Extent extent,
           const std::vector<std::string>& displayed = {})
        : offline(made(preset, values, extent)) {
        tell_driver(offline.context().info());
        if (auto set = player.set_signal(offline.document().state().signal); !set)
            give_up(set.error());
        if (auto off = offline.set_nan_policy(NanPolicy::off); !off)
            give_up(off.error());
        if (auto specialized = offline.specialize(displayed); !specialized)
            give_up(specialized.error());
    }

    Beam points() { return player.signal().trace(player.advance_fixed(60.0).span); }
    void draw() { offline.advance(); }

private:
    static Offline made(const std::string& preset, const ValueTexts& values, Extent extent) {
        RenderRequest request;
        request.look = "phosphor";
        request.preset = preset;
        request.values = values;
        request.size = extent;
        const Library library(wanted(find_roots(AFTERGLOW_SOURCE_DIR)));
        return wanted(Offline::create(wanted(prepare(request, library)), extent, 60.0));
    }
};

/// Of the red channel, per pixel of the full picture.
struct Spread {
    double energy = 0.0;
    double variance = 0.0;  // px^2, per axis
};

inline Spread spread_of(const Picture& picture, Extent full) {
    const double step = static_cast<double>(full.width) / picture.extent.width;
    double sum = 0.0;
    std::array<double, 4> moments{};
    for (int y = 0; y < picture.extent.height; ++y)
        for (int x = 0; x < picture.extent.width; ++x) {
            const auto light = static_cast<double>(picture.pixels[picture.index(x, y)]);
            sum += light;
            const std::array terms{step * x, step * y, step * step * x * x, step * step * y * y};
            for (std::size_t i = 0; i < terms.size(); ++i)
                moments[i] += light * terms[i];
        }
    const double x = moments[0] / sum;
    const double y = moments[1] / sum;
    return {sum * step * step, 0.5 * ((moments[2] + moments[3]) / sum - x * x - y * y)};
}

}  // namespace bench
