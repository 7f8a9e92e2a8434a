// What a frame of Phosphor costs beside plain GL programs (bench/plain_article.h): drawn as the
// article says, and the best that is known. Pictures are compared before times are. An argument
// is the number of frames in a turn, a second one a part of the names of what is measured alone.
#include "bench/article_engine.h"
#include "bench/plain_article.h"
#include "model/difference.h"

namespace {
using bench::ArticleSettings;
using bench::Cost;
using bench::Engine;
using bench::PlainArticle;
using bench::Spread;
using bench::spread_of;
using bench::ValueTexts;
using bench::wanted;
using bench::Way;

constexpr Extent picture_extent{1280, 720};
constexpr int rounds = 21;

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
    Engine engine(candidate.preset, candidate.values, picture_extent, {"persistence", pass});
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

void print_bytes(const Candidate& candidate) {
    const Engine engine(candidate.preset, candidate.values, picture_extent);
    const Executor& executor = engine.offline.executor();
    fmt::print("  ours: {:.1f} bytes a pixel, targets of {:.1f} MB\n", executor.bytes_per_pixel(),
               1e-6 * static_cast<double>(memory_of(executor.plan())));
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

}  // namespace

int main(int count, char** arguments) {
    const int frames = count > 1 ? std::atoi(arguments[1]) : 14;
    const ValueTexts halves{{"light_bits", "1"}};
    const ValueTexts literal{{"bloom_kind", "Taps"}, {"light_bits", "1"}};
    const std::vector<Candidate> candidates{
        {"literal", "article", literal, Way::literal, GL_RGBA16F, 1.02},
        {"best, RGBA16F", "article", halves, Way::best_colour, GL_RGBA16F, 1.03},
        {"best, RGBA32F", "article", {}, Way::best_colour, GL_RGBA32F, 1.03},
        {"best, one colour, R32F", "article-mono", {}, Way::best_one_colour, GL_R32F, 1.03},
        {"best, one colour, R16F", "article-mono", halves, Way::best_one_colour, GL_R16F, 1.03},
    };
    const std::string_view only = count > 2 ? arguments[2] : "";
    for (const Candidate& candidate : candidates) {
        if (std::string_view(candidate.name).find(only) == std::string_view::npos)
            continue;
        fmt::print("{} against '{}':\n", candidate.name, candidate.preset);
        print_pictures(candidate);
        print_bloom(candidate, "bloom_y");
        print_bytes(candidate);
        print_cost(candidate, frames);
    }
    if (!only.empty())
        return EXIT_SUCCESS;
    fmt::print("literal, the calls alone:\n");
    print_small_cost(candidates.front(), frames);
    return EXIT_SUCCESS;
}
