#include "model/plan/lead_in.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

namespace {
Pass pass_of(const std::string& name, const std::string& read, int frames_ago) {
    Pass pass;
    pass.name = name;
    if (!read.empty())
        pass.inputs.push_back({read, Input::From::pass, read, frames_ago, {}});
    return pass;
}

// A phosphor that reads itself; its light fades to 1/e in `decay` seconds.
Look fading_look() {
    Look look;
    look.id = "tube";
    Parameter decay;
    decay.name = "decay";
    decay.initial = Value(0.25);
    look.parameters.push_back(decay);
    look.passes.push_back(pass_of("phosphor", "phosphor", 1));
    look.fading = Fading{"$decay", "2", {"look.json", 7}};
    return look;
}
}  // namespace

TEST_CASE("a look that reads no earlier frames needs no lead-in") {
    Look look;
    look.passes.push_back(pass_of("first", "", 0));
    look.passes.push_back(pass_of("show", "first", 0));
    CHECK(lead_in_of(look, {}, 60.0) == LeadIn{.frames = 0});
}

TEST_CASE("a history that ends is drawn as far back as it reaches") {
    Look look;
    look.passes.push_back(pass_of("first", "", 0));
    look.passes.push_back(pass_of("second", "first", 3));
    look.passes.push_back(pass_of("show", "second", 2));
    CHECK(lead_in_of(look, {}, 60.0) == LeadIn{.frames = 5});
    CHECK(lead_in_of(look, {}, 60.0, 4) == LeadIn{.frames = 20});
}

TEST_CASE("light is drawn until less than half an 8-bit step of its peak remains") {
    const LeadIn lead_in = lead_in_of(fading_look(), {}, 100.0);
    REQUIRE(lead_in.frames.has_value());
    const auto encoded_after = [](double frames) {
        return 255.0 * 12.92 * 2.0 * std::exp(-frames / 100.0 / 0.25);  // dark end of sRGB
    };
    const auto frames = static_cast<double>(*lead_in.frames - 1);  // one more for the pass itself
    CHECK(encoded_after(frames) < 0.5);
    CHECK(encoded_after(frames - 1.0) >= 0.5);
}

TEST_CASE("the lead-in follows the values, and the frame rate in frames") {
    const Look look = fading_look();
    const Values slow{{"decay", Value(0.5)}};
    const auto frames = [&](const Values& values, double fps) {
        return static_cast<double>(lead_in_of(look, values, fps).frames.value() - 1);
    };
    CHECK(std::abs(frames(slow, 60.0) - 2.0 * frames({}, 60.0)) <= 1.0);
    CHECK(std::abs(frames({}, 120.0) - 2.0 * frames({}, 60.0)) <= 1.0);
}

TEST_CASE("without a known fading, all earlier frames are drawn") {
    Look unknown = fading_look();
    unknown.fading = std::nullopt;
    CHECK(lead_in_of(unknown, {}, 60.0).reason ==
          "how the earlier frames of 'tube' fade is not known");

    Look accumulating = fading_look();
    accumulating.passes[0].accumulate = true;
    CHECK(lead_in_of(accumulating, {}, 60.0).reason == "pass 'phosphor' accumulates");

    Look held = fading_look();
    held.fading->time_constant = "-1 / log($decay)";
    CHECK(lead_in_of(held, {}, 60.0).frames.has_value());
    CHECK(lead_in_of(held, {{"decay", Value(1.0)}}, 60.0).reason ==
          "at these values, earlier frames do not fade");

    const LeadIn moving = lead_in_of(fading_look(), {}, 60.0, 1, {"decay"});
    CHECK_FALSE(moving.frames.has_value());
    CHECK(moving.reason.starts_with("'decay' changes over time"));
    CHECK(lead_in_of(fading_look(), {}, 60.0, 1, {"other"}).frames.has_value());
}

TEST_CASE("two passes that read each other have a history without an end") {
    Look look;
    look.id = "pair";
    look.passes.push_back(pass_of("first", "second", 1));
    look.passes.push_back(pass_of("second", "first", 0));
    CHECK_FALSE(lead_in_of(look, {}, 60.0).frames.has_value());
}

TEST_CASE("a wrong expression of 'fading' is an error with its line") {
    Look look = fading_look();
    CHECK(check_fading(look).empty());
    look.fading->time_constant = "1 / ($decay - 0.25)";  // infinite at the default
    CHECK(check_fading(look).empty());
    CHECK(lead_in_of(look, {}, 60.0).reason == "at these values, earlier frames do not fade");
    look.fading->peak = "$decays";
    const Diagnostics problems = check_fading(look);
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].line == 7);
    CHECK(problems[0].message.starts_with("'peak' of 'fading': "));
}
