// When the beam is drawn directly onto the phosphor, and the number of bits of its light.
#include "about.h"
#include "looks/tube.h"
#include "model/picture/difference.h"
#include "problems_of.h"

namespace {
Look phosphor() {
    const std::filesystem::path shaders = std::filesystem::path(AFTERGLOW_SOURCE_DIR) / "shaders";
    LoadedLook loaded = load_look(shaders / "phosphor", shaders / "include");
    REQUIRE_MESSAGE(loaded.look.has_value(), problems_of(loaded.look));
    return *loaded.look;
}

// The plan when only the last pass is displayed.
Plan plan_of(const Look& look, const Values& values, Extent extent = {64, 32}) {
    PlanTerms terms;
    terms.seen.assign(look.passes.size(), false);
    terms.seen.back() = true;
    return plan_targets(look, extent, extent, values, terms).value();
}

PlannedTarget target_of(const char* pass, const Values& values) {
    const Look look = phosphor();
    return plan_of(look, values).targets[static_cast<std::size_t>(*find_pass(look, pass))];
}

bool is_onto(const char* pass, const Values& values) {
    return target_of(pass, values).onto.has_value();
}

Format light(Values values) {
    values["light_bits"] = 1.0;
    return target_of("persistence", values).format;
}
}  // namespace

TEST_CASE("the custom tube's beam needs no target for either beam kind") {
    CHECK(is_onto("beam", {}));
    CHECK_FALSE(is_onto("segments", {}));
    CHECK(is_onto("segments", {{"beam_kind", 1.0}}));
    CHECK_FALSE(is_onto("beam", {{"beam_kind", 1.0}}));
    CHECK(is_onto("beam", {{"beam_kind", 1.0}, {"as_written", 1.0}}));
    CHECK_FALSE(is_onto("beam", {{"tube", 5.0}}));
    CHECK(is_onto("beam", {{"tube", 5.0}, {"as_written", 1.0}}));
    CHECK_FALSE(is_onto("beam", {{"tone_map_every_frame", 1.0}}));
}

// A factor of (63/64)^4 = 0.93896 in 1/60 s loses 1/64 in 1/240 s.
TEST_CASE("light has 16 bits if requested and if all of it decays fast enough") {
    CHECK(target_of("persistence", {{"decay", 0.5}}).format == Format::rgba32f);
    CHECK(light({{"decay", 0.9389}}) == Format::rgba16f);
    CHECK(light({{"decay", 0.9390}}) == Format::rgba32f);
    CHECK(light({{"decay", 0.9389}, {"one_color", 1.0}}) == Format::r16f);
    // The slowest colour decides: 0.777^(1/4) = 0.93887, 0.778^(1/4) = 0.93917.
    const Value blue_is_slow({1.0, 4.0, 0.25});
    CHECK(light({{"decay", 0.777}, {"fade_speed", blue_is_slow}}) == Format::rgba16f);
    CHECK(light({{"decay", 0.778}, {"fade_speed", blue_is_slow}}) == Format::rgba32f);
    // If colours are not used, only Decay counts.
    CHECK(light({{"decay", 0.93}, {"fade_speed", blue_is_slow}, {"one_color", 1.0}}) ==
          Format::r16f);
    CHECK(light({{"decay", 0.98}, {"fade_speed", Value({9.0, 9.0, 9.0})}, {"as_written", 1.0}}) ==
          Format::rgba32f);
    CHECK(light({{"decay", 0.5}, {"tube", 5.0}}) == Format::rgba32f);
}

// The step of half floats is 2^-10 of the next lower power of two. Drivers that round to nearest
// have no bias. Some truncate, and lose half a step per frame. Averaged from one power of two to
// the next, uniformly in the logarithm, that is 2^-11 / (2 ln 2) of the light.
TEST_CASE("16-bit light decays correctly to 1 %, except for truncation by drivers") {
    for (const double fps : {60.0, 240.0}) {
        CAPTURE(fps);
        constexpr double decay = 0.9389;
        Tube tube({{"decay", Value(decay)}, {"light_bits", Value(1.0)}, {"ceiling", Value(1000.0)}},
                  {32, 32});
        tube.draw(tube.flood(), fps);
        const double first = tube.at("persistence", 16, 16);
        const double seconds = std::log(0.01) / (60.0 * std::log(decay));
        const int frames = static_cast<int>(std::lround(seconds * fps));
        tube.rest(frames, fps);
        const double left = first * std::pow(decay, 60 * frames / fps);
        const double cut = std::exp(-frames / (4096.0 * std::log(2.0)));
        CHECK(tube.at("persistence", 16, 16) < 1.01 * left);
        CHECK(tube.at("persistence", 16, 16) > 0.99 * cut * left);
    }
}

// Targets of 1920 x 1080, calculated manually: the light of this frame and the previous one; the
// input of the bloom, its horizontal and its vertical blur at half size; the picture; single texels
// for unused passes.
TEST_CASE("the article's targets have the memory of their texels") {
    const Look look = phosphor();
    constexpr double pixels = 1920.0 * 1080.0;
    const auto megabytes = [&](const Values& values) {
        return 1e-6 * static_cast<double>(memory_of(plan_of(look, values, {1920, 1080})));
    };
    CHECK(megabytes({{"as_written", 1.0}, {"bloom_kind", 0.0}}) ==
          about(1e-6 * pixels * (2 * 16 + 3 * 8 / 4.0 + 4), 1e-4));
    CHECK(megabytes({{"as_written", 1.0}, {"bloom_kind", 0.0}, {"light_bits", 1.0}}) ==
          about(1e-6 * pixels * (2 * 8 + 3 * 8 / 4.0 + 4), 1e-4));
}
