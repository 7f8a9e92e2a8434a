// Cost of Phosphor's bloom passes alone: the pyramid compared with a plain blur of 49 taps per
// axis, and with itself at half the width. Its picture of a single point of light is checked first.
#include "bench/article_engine.h"
#include "bench/plain_blur.h"
#include "bench/side_by_side.h"
#include "gpu/objects/readback.h"

#include <fmt/format.h>

#include <cstdlib>

namespace {
using bench::Engine;
using bench::Spread;
using bench::spread_of;
using bench::wanted;

constexpr Extent picture_extent{1280, 720};
constexpr double seconds = 15.0;
const bench::Topic topic{"bloom", "Phosphor's bloom passes at 1280 x 720"};

/// The bloom passes of the specialised article preset, without the passes before and after.
class Bloom {
public:
    explicit Bloom(const std::string& radius)
        : m_engine("article", {{"bloom_radius", radius}, {"ceiling", "1000"}}, picture_extent),
          m_executor(m_engine.offline.executor().look(),
                     m_engine.offline.executor().programs().generic()) {
        m_executor.set_values(m_engine.offline.document().values());
        const Look& look = m_executor.look();
        std::vector<bool> displayed(look.passes.size(), false);
        displayed.back() = true;
        expect(m_executor.resize(picture_extent, picture_extent));
        expect(m_executor.set_displayed(displayed));
        for (const std::string& name : pass_names(look))
            m_passes.push_back(name == "reduced" || name.starts_with("bloom_down") ||
                               name.starts_with("bloom_up") || name == "bloom_y");
        m_frame.number = 1;
        m_frame.time = m_frame.time_delta = 1.0 / 60.0;
        m_frame.is_first = true;
        m_frame.beam = m_point;
        m_executor.draw(m_frame);
    }

    ~Bloom() { m_engine.offline.make_current(); }
    Bloom(const Bloom&) = delete;
    Bloom& operator=(const Bloom&) = delete;

    /// May be called with any current context.
    void draw() {
        m_engine.offline.make_current();
        m_executor.redraw(m_frame, m_passes);
    }
    /// Of `reduced` and of the bloom.
    std::pair<Spread, Spread> spreads() { return {displayed("reduced"), displayed("bloom_y")}; }
    Picture picture(const char* pass) {
        m_engine.offline.make_current();
        return gpu::read_picture(m_executor.target(*find_pass(m_executor.look(), pass)));
    }

private:
    static void expect(const Result<void>& done) {
        if (!done)
            bench::give_up(done.error());
    }
    Spread displayed(const char* pass) { return spread_of(picture(pass), picture_extent); }

    Engine m_engine;
    Executor m_executor;
    Beam m_point{{0.0f, 0.0f, 1000.0f, 0.0f}};  // far above the smallest half float
    std::vector<bool> m_passes;
    Frame m_frame;
};

// The largest increase along the row, from the brightest texel outwards, relative to that texel.
double worst_rise(const Picture& picture) {
    const auto light = [&picture](int x, int y) {
        return static_cast<double>(picture.pixels[picture.index(x, y)]);
    };
    int row = 0;
    int column = 0;
    for (int y = 0; y < picture.extent.height; ++y)
        for (int x = 0; x < picture.extent.width; ++x)
            if (light(x, y) > light(column, row)) {
                column = x;
                row = y;
            }
    double worst = 0.0;
    for (int x = 1; x < picture.extent.width; ++x) {
        const double step = light(x, row) - light(x - 1, row);
        worst = std::max(worst, x <= column ? -step : step);
    }
    return worst / light(column, row);
}

void tell_shape(const std::string& key, const std::string& whose, double wanted_sigma,
                Bloom& bloom) {
    const auto [before, after] = bloom.spreads();
    const double energy = after.energy / before.energy;
    const double variance = after.variance - before.variance;
    bench::tell(topic, {.key = key + "-energy",
                        .what = fmt::format("{}: energy error", whose),
                        .value = 100.0 * std::abs(energy - 1.0),
                        .unit = "%",
                        .bound = bench::at_most(1.0)});
    bench::tell(topic, {.key = key + "-moment",
                        .what = fmt::format("{}: second moment error", whose),
                        .value = 100.0 * std::abs(variance / (wanted_sigma * wanted_sigma) - 1.0),
                        .unit = "%",
                        .bound = bench::at_most(5.0),
                        .detail = fmt::format("sigma {:.2f} px", std::sqrt(variance))});
    bench::tell(topic,
                {.key = key + "-comb",
                 .what = fmt::format("{}: largest rise away from the peak, relative to it", whose),
                 .value = 100.0 * worst_rise(bloom.picture("bloom_y")),
                 .unit = "%",
                 .bound = bench::at_most(2.0)});
}

// `sigma` in px of the full picture; the article's radius of 3 corresponds to 9.82 px.
std::string radius_of(double sigma) {
    return fmt::format("{:.4f}", sigma / (2.0 * std::sqrt(2.6795)));
}

void compare_with_taps() {
    constexpr double sigma = 17.0;
    Bloom pyramid(radius_of(sigma));
    // Cut at 24 texels, a Gaussian of 8.685 has a sigma of 8.5 texels, which is 17 px.
    const auto plain = wanted(
        bench::PlainBlur::make({picture_extent.width / 2, picture_extent.height / 2}, 49, 8.685));
    tell_shape("sigma-17", "pyramid, sigma 17 px", sigma, pyramid);
    bench::tell(topic,
                bench::ratio_figure("against-taps",
                                    "pyramid, sigma 17 px: CPU time relative to 49 taps per axis",
                                    bench::side_by_side_for(
                                        seconds, [&] { plain.draw(); }, [&] { pyramid.draw(); }),
                                    bench::at_most(1.0 / 6.0)));
}

void tell_width_cost() {
    Bloom narrow(radius_of(15.5));
    Bloom wide(radius_of(31.0));
    tell_shape("sigma-15", "pyramid, sigma 15.5 px", 15.5, narrow);
    tell_shape("sigma-31", "pyramid, sigma 31 px", 31.0, wide);
    bench::tell(topic, bench::ratio_figure(
                           "width", "pyramid, sigma 31 px: CPU time relative to sigma 15.5 px",
                           bench::side_by_side_for(
                               seconds, [&] { narrow.draw(); }, [&] { wide.draw(); }),
                           bench::at_most(1.05)));
}
}  // namespace

int main() {
    compare_with_taps();
    tell_width_cost();
    return EXIT_SUCCESS;
}
