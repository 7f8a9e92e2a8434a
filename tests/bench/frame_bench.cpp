// What a frame of Phosphor costs beside plain GL programs (bench/plain_article.h): drawn as the
// article says, and the best that is known. Pictures are compared before times are. An argument
// is the number of frames in a turn.
#include "bench/plain_article.h"
#include "bench/side_by_side.h"
#include "lab/offline.h"
#include "model/difference.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>

namespace {
using bench::ArticleSettings;
using bench::Cost;
using bench::PlainArticle;
using bench::Way;

constexpr Extent picture_extent{1280, 720};
constexpr int rounds = 21;

using ValueTexts = std::vector<std::pair<std::string, std::string>>;

[[noreturn]] void give_up(const Diagnostics& problems) {
    fmt::print(stderr, "{}", to_string(problems));
    std::exit(EXIT_FAILURE);
}

template <class T>
T wanted(Result<T> result) {
    if (!result)
        give_up(result.error());
    return std::move(*result);
}

/// A preset of Phosphor as the program draws it, and the article's points for the plain programs.
struct Engine {
    Offline offline;
    Player player;

    Engine(const std::string& preset, const ValueTexts& values, Extent extent)
        : offline(made(preset, values, extent)) {
        if (auto set = player.set_signal(offline.document().state().signal); !set)
            give_up(set.error());
        if (auto off = offline.set_guard(Executor::Guard::off); !off)
            give_up(off.error());
        if (auto settled = offline.settle({"persistence", "bloom_y"}); !settled)
            give_up(settled.error());
    }

    Beam points() { return player.trace(player.advance_fixed(60.0).span); }
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

/// Of red, per pixel of the full picture.
struct Spread {
    double energy = 0.0;
    double variance = 0.0;  // px^2, of one axis
};

Spread spread_of(const Picture& picture, Extent full) {
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

struct Candidate {
    const char* name;
    const char* preset;
    ValueTexts values;
    Way way;
    GLenum format;
    double bound;  // of ours to plain
};

void print_pictures(const Candidate& candidate) {
    constexpr int frames = 16;
    ValueTexts values = candidate.values;
    values.emplace_back("bloom_intensity", "0");
    Engine engine(candidate.preset, values, picture_extent);
    auto literal = wanted(PlainArticle::make({Way::literal, picture_extent, GL_RGBA16F, 0.0}));
    auto plain = wanted(PlainArticle::make({candidate.way, picture_extent, candidate.format, 0.0}));
    for (int i = 0; i < frames; ++i) {
        const Beam points = engine.points();
        literal.draw(points);
        plain.draw(points);
        engine.draw();
    }
    const auto decibels = [&](const Picture& picture) {
        return wanted(difference_between(literal.picture(), picture, 0.0)).psnr_db;
    };
    fmt::print(
        "  without bloom, against the article drawn literally: plain {:.1f} dB, ours {:.1f} dB\n",
        decibels(plain.picture()), decibels(engine.offline.picture()));
}

// Of one point in one frame: what the bloom makes of it.
void print_bloom(const Candidate& candidate, const char* pass) {
    Beam point{{0.0f, 0.0f, 1.0f, 0.0f}};
    Engine engine(candidate.preset, candidate.values, picture_extent);
    engine.offline.drive_by([&](const PlayedFrame&) -> Beam { return point; });
    engine.draw();
    const Look& look = engine.offline.executor().look();
    const auto seen = [&](const char* name) {
        return spread_of(engine.offline.picture(*find_pass(look, name)), picture_extent);
    };
    auto literal = wanted(PlainArticle::make({Way::literal, picture_extent}));
    literal.draw(point);
    auto plain = wanted(PlainArticle::make({candidate.way, picture_extent, candidate.format}));
    plain.draw(point);
    const auto print = [&](const char* whose, const Spread& before, const Spread& after) {
        fmt::print("  bloom of a point, {}: energy {:.4f} of it, sigma {:.2f} px\n", whose,
                   after.energy / before.energy, std::sqrt(after.variance - before.variance));
    };
    const Spread lit = spread_of(literal.phosphor(), picture_extent);
    print("literal", lit, spread_of(literal.bloom(), picture_extent));
    print("plain", spread_of(plain.phosphor(), picture_extent),
          spread_of(plain.bloom(), picture_extent));
    print("ours", seen("persistence"), seen(pass));
}

Cost cost_of(const Candidate& candidate, Extent extent, int frames) {
    Engine engine(candidate.preset, candidate.values, extent);
    auto plain = wanted(PlainArticle::make({candidate.way, extent, candidate.format}));
    return bench::side_by_side(
        rounds, frames, [&] { plain.draw(engine.points()); }, [&] { engine.draw(); });
}

const char* verdict(const Cost& cost, bool holds) {
    if (!cost.counts())
        return "the machine is too busy";
    return holds ? "holds" : "DOES NOT HOLD";
}

void print_cost(const Candidate& candidate, int frames) {
    const Cost cost = cost_of(candidate, picture_extent, frames);
    fmt::print(
        "  plain {:6.2f} ms, ours {:6.2f} ms, ours / plain {:.3f} (itself {:.3f}), at most "
        "{:.2f}: {}\n",
        cost.plain_milliseconds, cost.our_milliseconds, cost.ratio, cost.itself, candidate.bound,
        verdict(cost, cost.ratio <= candidate.bound));
    std::fflush(stdout);
}

// Where hardly a pixel is drawn the calls are what is left.
void print_small_cost(const Candidate& candidate, int frames) {
    constexpr double most_more = 1.5;  // ms
    const Cost cost = cost_of(candidate, {64, 64}, 10 * frames);
    const double more = cost.our_milliseconds - cost.plain_milliseconds;
    fmt::print(
        "  at 64 x 64: plain {:.3f} ms, ours {:.3f} ms, {:.3f} ms more (itself {:.3f}), at "
        "most {}: {}\n",
        cost.plain_milliseconds, cost.our_milliseconds, more, cost.itself, most_more,
        verdict(cost, more <= most_more));
    std::fflush(stdout);
}

// Twice as wide is to cost the same: each against the same plain frame.
void print_width_cost(int frames) {
    constexpr double most = 1.05;
    const auto cost = [&](const char* radius) {
        return cost_of({"",
                        "article",
                        {{"bloom_kind", "Pyramid"}, {"bloom_radius", radius}},
                        Way::literal,
                        GL_RGBA16F,
                        0.0},
                       picture_extent, frames);
    };
    const Cost narrow = cost("3");
    const Cost wide = cost("6");
    const double ratio = wide.ratio / narrow.ratio;
    fmt::print(
        "a pyramid of sigma 19.7 px against one of 9.8 px, whole frames: {:.3f}, at most "
        "{:.2f}: {}\n",
        ratio, most,
        narrow.counts() && wide.counts() ? (ratio <= most ? "holds" : "DOES NOT HOLD")
                                         : "the machine is too busy");
}
}  // namespace

int main(int count, char** arguments) {
    const int frames = count > 1 ? std::atoi(arguments[1]) : 14;
    const ValueTexts pyramid{{"bloom_kind", "Pyramid"}};
    const std::vector<Candidate> candidates{
        {"literal", "article", {}, Way::literal, GL_RGBA16F, 1.02},
        {"best, RGBA16F", "article", pyramid, Way::best_colour, GL_RGBA16F, 1.03},
        {"best, RGBA32F", "article", pyramid, Way::best_colour, GL_RGBA32F, 1.03},
        {"best, one colour, R32F", "article-mono", {}, Way::best_one_colour, GL_R32F, 1.03},
    };
    for (const Candidate& candidate : candidates) {
        fmt::print("{} against '{}':\n", candidate.name, candidate.preset);
        print_pictures(candidate);
        print_bloom(candidate, "bloom_y");
        print_cost(candidate, frames);
    }
    fmt::print("literal, the calls alone:\n");
    print_small_cost(candidates.front(), frames);
    print_width_cost(frames);
    return EXIT_SUCCESS;
}
