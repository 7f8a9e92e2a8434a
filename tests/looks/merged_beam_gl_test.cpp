// A beam with merged samples, compared with the same samples drawn separately.
#include "gpu/headless.h"
#include "gpu/objects/readback.h"
#include "lab/offline/offline.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

namespace {
constexpr Extent extent{320, 180};

Beam closed_figure(int count) {
    Beam beam;
    for (int k = 1; k <= count; ++k) {
        const double share = static_cast<double>(k) / count;
        const double turn = 2.0 * std::numbers::pi * share;
        beam.push_back({static_cast<float>(0.84 * std::sin(5.0 * turn + 0.5)),
                        static_cast<float>(0.84 * std::sin(4.0 * turn)),
                        static_cast<float>(4096.0 / count),
                        static_cast<float>((1.0 - share) / 60.0)});
    }
    return beam;
}

// The beam pass of a look, with `spot` instead of the look's own.
Picture beam_of(const char* name, const char* pass, const Beam& beam, const Values& values,
                const std::array<std::string, 2>& spot) {
    const std::filesystem::path shaders = std::filesystem::path(AFTERGLOW_SOURCE_DIR) / "shaders";
    LoadedLook loaded = load_look(shaders / name, shaders / "include");
    REQUIRE(loaded.look.has_value());
    const auto index = static_cast<std::size_t>(*find_pass(*loaded.look, pass));
    REQUIRE_FALSE(loaded.look->passes[index].spot[0].empty());
    if (!spot[0].empty())
        loaded.look->passes[index].spot = spot;
    auto programs = build_programs(*loaded.look);
    REQUIRE(programs.has_value());
    Executor executor(std::move(*loaded.look), std::move(*programs));
    executor.set_values(values);
    REQUIRE(executor.resize(extent, extent).has_value());
    Frame frame;
    frame.number = 1;
    frame.time = frame.time_delta = 1.0 / 60.0;
    frame.is_first = true;
    frame.beam = beam;
    executor.draw(frame);
    return gpu::read_picture(executor.target(static_cast<int>(index)));
}

// The difference in one channel, relative to the RMS of the second picture.
double apart(const Picture& merged, const Picture& each, std::size_t channel) {
    double difference = 0.0;
    double all = 0.0;
    for (std::size_t i = channel; i < each.pixels.size(); i += 4) {
        const auto wanted = static_cast<double>(each.pixels[i]);
        difference += std::pow(static_cast<double>(merged.pixels[i]) - wanted, 2);
        all += wanted * wanted;
    }
    return std::sqrt(difference / all);
}
}  // namespace

TEST_CASE_FIXTURE(Headless,
                  "vector beam: merged samples give the same light, at any size and fit") {
    const Beam beam = closed_figure(16384);
    for (const double fit : {0.0, 1.0})
        for (const double size : {0.9, 3.0}) {
            CAPTURE(fit);
            CAPTURE(size);
            const Values values{{"spot_sigma", Value(2.8)},  // 1 px
                                {"spot_growth", Value(0.0)},
                                {"decay_time", Value(4.0)},  // ms
                                {"fit", Value(fit)},
                                {"screen_size", Value(size)}};
            const Picture merged = beam_of("vector-beam", "beam", beam, values, {});
            const Picture each = beam_of("vector-beam", "beam", beam, values, {"0", "0"});
            CHECK(apart(merged, each, 0) < 0.01);
            CHECK(apart(merged, each, 1) < 0.01);
            CHECK(apart(merged, each, 1) > 1e-6);  // the segments differ
            // Spots six times the actual size: excessive merging is detectable.
            const Picture rough = beam_of("vector-beam", "beam", beam, values, {"0.2", "0.2"});
            CHECK(apart(rough, each, 1) > 0.02);
        }
}

TEST_CASE_FIXTURE(Headless, "phosphor: merged samples give the same light") {
    const Beam beam = closed_figure(16384);
    for (const double fit : {0.0, 1.0}) {
        CAPTURE(fit);
        const Values values{
            {"beam_kind", Value(1.0)}, {"beam_width", Value(12.0)}, {"fit", Value(fit)}};
        const Picture merged = beam_of("phosphor", "segments", beam, values, {});
        const Picture each = beam_of("phosphor", "segments", beam, values, {"0", "0"});
        for (const std::size_t channel : {0U, 1U, 2U})
            CHECK(apart(merged, each, channel) < 0.01);
        CHECK(apart(merged, each, 1) > 1e-6);
    }
}

TEST_CASE_FIXTURE(Headless, "vector beam: the article's formula gets every sample") {
    const Beam beam = closed_figure(4096);
    const Values values{{"as_written", Value(1.0)}, {"spot_sigma", Value(6.0)}};
    const Picture drawn = beam_of("vector-beam", "beam", beam, values, {});
    const Picture each = beam_of("vector-beam", "beam", beam, values, {"0", "0"});
    CHECK(drawn.pixels == each.pixels);
}
