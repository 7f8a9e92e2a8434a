#include "lab/offline/sweep.h"

#include <doctest/doctest.h>

#include <cmath>

namespace {
Parameter named(const std::string& name, const std::string& label, Scalar scalar) {
    Parameter parameter;
    parameter.name = name;
    parameter.label = label;
    parameter.type.scalar = scalar;
    return parameter;
}

Look look_to_vary() {
    Parameter decay = named("decay", "Decay", Scalar::floating);
    decay.unit = "per frame";
    decay.limit = Limit{0.0, 1.0};
    Parameter exposure = named("exposure", "Exposure", Scalar::floating);
    exposure.scale = Scale::logarithmic;
    Parameter map = named("tone_map", "Tone map", Scalar::integer);
    map.control = Control::list;
    map.items = {{0.0, "Clamp"}, {2.0, "ACES"}};
    Parameter color = named("color", "Colour", Scalar::floating);
    color.type.rows = 3;
    Look look;
    look.id = "test";
    look.parameters = {decay, exposure, named("taps", "Taps", Scalar::integer), map, color};
    return look;
}

std::vector<double> numbers_of(std::string_view text) {
    const Look look = look_to_vary();
    const auto axis = parse_sweep_axis(text, look);
    REQUIRE(axis.has_value());
    std::vector<double> numbers;
    for (const SweepAxis::Stop& stop : axis->stops)
        numbers.push_back(stop.value.number());
    return numbers;
}

std::string sweep_refusal(std::string_view text) {
    const Look look = look_to_vary();
    const auto axis = parse_sweep_axis(text, look);
    REQUIRE_FALSE(axis.has_value());
    return axis.error().front().message;
}
}  // namespace

TEST_CASE("a range is divided evenly along the slider") {
    CHECK(numbers_of("decay=0:1:5") == std::vector<double>{0.0, 0.25, 0.5, 0.75, 1.0});
    CHECK(numbers_of("decay=1:0:3") == std::vector<double>{1.0, 0.5, 0.0});
    const auto ratios = numbers_of("exposure=0.5:8:5");  // each is twice the previous one
    REQUIRE(ratios.size() == 5);
    for (std::size_t i = 0; i < 5; ++i)
        CHECK(std::abs(ratios[i] - 0.5 * std::pow(2.0, static_cast<double>(i))) < 1e-12);
    // Equal ratios are impossible from 0.
    CHECK(numbers_of("exposure=0:8:3") == std::vector<double>{0.0, 4.0, 8.0});
    CHECK(numbers_of("taps=1:3:5") == std::vector<double>{1.0, 2.0, 3.0});
}

TEST_CASE("a list is used as given, with items by name") {
    CHECK(numbers_of("decay=0.5, 0.25") == std::vector<double>{0.5, 0.25});
    CHECK(numbers_of("tone_map=ACES,Clamp") == std::vector<double>{2.0, 0.0});
}

TEST_CASE("an invalid sweep is refused with a clear message") {
    CHECK(sweep_refusal("decay") == "expected name=low:high:count or name=a,b,c, got 'decay'");
    CHECK(sweep_refusal("dekay=0:1:2") ==
          "'test' has no parameter 'dekay' (did you mean 'decay'?)");
    CHECK(sweep_refusal("decay=0:1") ==
          "expected name=low:high:count with a count from 2 to 100, got 'decay=0:1'");
    CHECK(sweep_refusal("decay=0:1:101") ==
          "expected name=low:high:count with a count from 2 to 100, got 'decay=0:1:101'");
    CHECK(sweep_refusal("decay=0:2:3").find("'decay' must be between 0 and 1") == 0);
    CHECK(sweep_refusal("color=0:1:3") == "'color' is not a single number and can't be swept");
    CHECK(sweep_refusal("tone_map=Clamp,Acid").find("'tone_map' must be one of") == 0);
}

TEST_CASE("every combination appears once, and the first parameter varies fastest") {
    const Look look = look_to_vary();
    const auto across = parse_sweep_axis("tone_map=Clamp,ACES", look);
    const auto down = parse_sweep_axis("decay=0:1:3", look);
    REQUIRE((across && down));
    const auto cells = sweep_cells({*across, *down});
    REQUIRE(cells.size() == 6);
    CHECK(cells[0].caption == "Tone map: Clamp, Decay 0 per frame");
    CHECK(cells[1].caption == "Tone map: ACES, Decay 0 per frame");
    CHECK(cells[5].caption == "Tone map: ACES, Decay 1 per frame");
    REQUIRE(cells[3].values.size() == 2);
    CHECK(cells[3].values[0].first == "tone_map");
    CHECK(cells[3].values[0].second.number() == 2.0);
    CHECK(cells[3].values[1].second.number() == 0.5);
}
