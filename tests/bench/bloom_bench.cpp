// What the bloom of Phosphor costs alone: its pyramid beside a plain blur of 49 taps each way, and
// beside itself at twice the width. An argument is the number of frames in a turn.
#include "bench/article_engine.h"
#include "bench/plain_blur.h"
#include "gpu/readback.h"

namespace {
using bench::Cost;
using bench::Engine;
using bench::Spread;
using bench::spread_of;
using bench::wanted;

constexpr Extent picture_extent{1280, 720};
constexpr int rounds = 15;

/// The passes of the bloom as the settled article has them, without those before and behind.
class Bloom {
public:
    explicit Bloom(const std::string& radius)
        : m_engine("article", {{"bloom_radius", radius}, {"ceiling", "1000"}}, picture_extent),
          m_executor(m_engine.offline.executor().look(), m_engine.offline.executor().programs()) {
        m_executor.set_values(m_engine.offline.document().values());
        const Look& look = m_executor.look();
        std::vector<bool> seen(look.passes.size(), false);
        seen.back() = true;
        expect(m_executor.resize(picture_extent, picture_extent));
        expect(m_executor.set_seen(seen));
        for (const std::string& name : pass_names(look))
            m_passes.push_back(name == "reduced" || name.starts_with("bloom_down") ||
                               name.starts_with("bloom_up") || name == "bloom_y");
        m_frame.number = 1;
        m_frame.time = m_frame.time_delta = 1.0 / 60.0;
        m_frame.is_first = true;
        m_frame.beam = m_point;
        m_executor.draw(m_frame);
    }

    void draw() { m_executor.redraw(m_frame, m_passes); }
    /// Of `reduced` and of the bloom.
    std::pair<Spread, Spread> spreads() const { return {seen("reduced"), seen("bloom_y")}; }
    Picture picture(const char* pass) const {
        return gpu::read_picture(m_executor.target(*find_pass(m_executor.look(), pass)));
    }

private:
    static void expect(const Result<void>& done) {
        if (!done)
            bench::give_up(done.error());
    }
    Spread seen(const char* pass) const { return spread_of(picture(pass), picture_extent); }

    Engine m_engine;
    Executor m_executor;
    Beam m_point{{0.0f, 0.0f, 1000.0f, 0.0f}};  // far above the least of half floats
    std::vector<bool> m_passes;
    Frame m_frame;
};

// The largest rise on the way out from the brightest texel along its row, as a share of it.
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

void print_shape(const char* whose, const Spread& before, const Spread& after, double rise) {
    fmt::print("  {}: energy {:.4f}, sigma {:.2f} px, largest rise {:.2f} % of the peak\n", whose,
               after.energy / before.energy, std::sqrt(after.variance - before.variance),
               100.0 * rise);
}

const char* verdict(const Cost& cost, bool holds) {
    if (!cost.counts())
        return "the machine is too busy";
    return holds ? "holds" : "DOES NOT HOLD";
}

// `sigma` in px of the whole picture; the article's radius of 3 is 9.82 of them.
std::string radius_of(double sigma) {
    return fmt::format("{:.4f}", sigma / (2.0 * std::sqrt(2.6795)));
}

void print_against_taps(int frames) {
    constexpr double most = 1.0 / 6.0;
    constexpr double sigma = 17.0;
    Bloom pyramid(radius_of(sigma));
    // Cut at 24 texels a Gaussian of 8.685 has 8.5, which are 17 px.
    const auto plain = wanted(
        bench::PlainBlur::make({picture_extent.width / 2, picture_extent.height / 2}, 49, 8.685));
    plain.draw();
    fmt::print("pyramid against 49 taps each way:\n");
    const auto [before, after] = pyramid.spreads();
    print_shape("pyramid", before, after, worst_rise(pyramid.picture("bloom_y")));
    print_shape("taps", spread_of(plain.lit(), picture_extent),
                spread_of(plain.blurred(), picture_extent), worst_rise(plain.blurred()));
    const Cost cost = bench::side_by_side(
        rounds, frames, [&] { plain.draw(); }, [&] { pyramid.draw(); });
    fmt::print(
        "  taps {:6.2f} ms, pyramid {:6.2f} ms, pyramid / taps {:.3f} (itself {:.3f}), at most "
        "{:.3f}: {}\n",
        cost.plain_milliseconds, cost.our_milliseconds, cost.ratio, cost.itself, most,
        verdict(cost, cost.ratio <= most));
}

// Each against the same taps, as both have programs of their own.
void print_width_cost(int frames) {
    constexpr double most = 1.05;
    const auto cost_of = [frames](double sigma) {
        Bloom pyramid(radius_of(sigma));
        const auto [before, after] = pyramid.spreads();
        print_shape("pyramid", before, after, worst_rise(pyramid.picture("bloom_y")));
        const auto plain = wanted(
            bench::PlainBlur::make({picture_extent.width / 2, picture_extent.height / 2}, 13, 3.0));
        return bench::side_by_side(
            rounds, frames, [&] { plain.draw(); }, [&] { pyramid.draw(); });
    };
    fmt::print("pyramid at twice the width:\n");
    const Cost narrow = cost_of(15.5);
    const Cost wide = cost_of(31.0);
    const double ratio = wide.ratio / narrow.ratio;
    fmt::print("  {:.3f} of the cost (itself {:.3f}, {:.3f}), at most {:.2f}: {}\n", ratio,
               narrow.itself, wide.itself, most,
               verdict(narrow.counts() ? wide : narrow, ratio <= most));
}
}  // namespace

int main(int count, char** arguments) {
    const int frames = count > 1 ? std::atoi(arguments[1]) : 14;
    print_against_taps(frames);
    print_width_cost(frames);
    return EXIT_SUCCESS;
}
