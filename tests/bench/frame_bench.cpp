// Cost of a Phosphor frame compared with plain GL programs (bench/plain_article.h): literally as in
// the article, and as optimised as we know how. Pictures are compared before times. An argument
// restricts the run to candidates whose key contains it.
#include "bench/article_engine.h"
#include "bench/plain_article.h"
#include "bench/side_by_side.h"
#include "model/picture/difference.h"

#include <fmt/format.h>

#include <cstdlib>

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
const bench::Topic topic{"frame", "Phosphor's frame compared with plain GL, the article's figure"};

struct Candidate {
    std::string key;
    std::string name;
    std::string preset;
    ValueTexts values;
    Way way;
    GLenum format;
    double maximum;  // limit of ours relative to plain
    double minimum;  // dB
};

// Without bloom, because the kinds of bloom differ.
void tell_pictures(const Candidate& candidate) {
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
        constexpr double same = 200.0;  // stands for infinity
        return std::min(wanted(difference_between(literal.picture(), picture, 0.0)).psnr_db, same);
    };
    bench::tell(topic, {.key = candidate.key + "-picture",
                        .what = fmt::format("{}: PSNR without bloom, against literal plain GL",
                                            candidate.name),
                        .value = decibels(engine.offline.picture()),
                        .unit = "dB",
                        .bound = bench::at_least(candidate.minimum),
                        .detail = fmt::format("plain GL {:.1f} dB", decibels(plain.picture()))});
}

// The bloom of one point in one frame, compared with the literal program.
void tell_bloom(const Candidate& candidate, const char* pass) {
    Beam point{{0.0f, 0.0f, 1.0f, 0.0f}};
    Engine engine(candidate.preset, candidate.values, picture_extent, {"persistence", pass});
    engine.offline.override_beam([&](const PlayedFrame&) -> Beam { return point; });
    engine.draw();
    const Look& look = engine.offline.executor().look();
    const auto seen = [&](const char* name) {
        return spread_of(engine.offline.picture(*find_pass(look, name)), picture_extent);
    };
    auto literal = wanted(PlainArticle::make({Way::literal, picture_extent}));
    literal.draw(point);
    const auto bloomed = [](const Spread& before, const Spread& after) {
        return Spread{after.energy / before.energy, after.variance - before.variance};
    };
    const Spread should = bloomed(spread_of(literal.phosphor(), picture_extent),
                                  spread_of(literal.bloom(), picture_extent));
    const Spread ours = bloomed(seen("persistence"), seen(pass));
    bench::tell(topic, {.key = candidate.key + "-energy",
                        .what = fmt::format("{}: bloom energy error against literal plain GL",
                                            candidate.name),
                        .value = 100.0 * std::abs(ours.energy / should.energy - 1.0),
                        .unit = "%",
                        .bound = bench::at_most(1.0)});
    bench::tell(topic,
                {.key = candidate.key + "-moment",
                 .what = fmt::format("{}: bloom second moment error against literal plain GL",
                                     candidate.name),
                 .value = 100.0 * std::abs(ours.variance / should.variance - 1.0),
                 .unit = "%",
                 .bound = bench::at_most(5.0),
                 .detail = fmt::format("sigma {:.2f} px", std::sqrt(ours.variance))});
}

Cost cost_of(const Candidate& candidate, Extent extent) {
    constexpr double seconds = 2.5;
    Engine engine(candidate.preset, candidate.values, extent);
    auto plain = wanted(PlainArticle::make({candidate.way, extent, candidate.format}));
    return bench::side_by_side_for(
        seconds, [&] { plain.draw(engine.points()); }, [&] { engine.draw(); });
}

std::vector<Cost> costs_of_openings(const Candidate& candidate) {
    constexpr int openings = 5;
    std::vector<Cost> costs;
    for (int i = 0; i < openings; ++i)
        costs.push_back(cost_of(candidate, picture_extent));
    return costs;
}

void compare(const Candidate& candidate) {
    tell_pictures(candidate);
    tell_bloom(candidate, "bloom_y");
    bench::tell(topic,
                bench::ratio_figure(
                    candidate.key, fmt::format("{}: CPU time relative to plain GL", candidate.name),
                    costs_of_openings(candidate), bench::at_most(candidate.maximum)));
}

// With very few pixels, only the cost of the calls remains.
void tell_small_cost(const Candidate& candidate) {
    bench::tell(topic, bench::more_figure(
                           candidate.key + "-calls",
                           fmt::format("{}, 64 x 64: CPU time minus plain GL", candidate.name),
                           cost_of(candidate, {64, 64}), bench::at_most(1.5)));
}
}  // namespace

int main(int count, char** arguments) {
    const ValueTexts halves{{"light_bits", "1"}};
    const ValueTexts taps{{"bloom_kind", "Taps"}, {"light_bits", "1"}};
    const std::vector<Candidate> candidates{
        {"literal", "literal", "article", taps, Way::literal, GL_RGBA16F, 1.02, 50.0},
        {"colour-16", "optimised RGBA16F", "article", halves, Way::best_colour, GL_RGBA16F, 1.03,
         50.0},
        {"colour-32", "optimised RGBA32F", "article", {}, Way::best_colour, GL_RGBA32F, 1.03, 50.0},
        {"mono-32",
         "optimised monochrome R32F",
         "article-mono",
         {},
         Way::best_one_colour,
         GL_R32F,
         1.03,
         45.0},
        {"mono-16", "optimised monochrome R16F", "article-mono", halves, Way::best_one_colour,
         GL_R16F, 1.03, 45.0},
    };
    const std::string only = count > 1 ? arguments[1] : "";
    for (const Candidate& candidate : candidates)
        if (candidate.key.find(only) != std::string::npos)
            compare(candidate);
    if (candidates.front().key.find(only) != std::string::npos)
        tell_small_cost(candidates.front());
    return EXIT_SUCCESS;
}
