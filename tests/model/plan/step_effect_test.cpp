#include "model/plan/step_effect.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

namespace {
using Kind = StepEffect::Kind;

constexpr PassChange same{0.0, 0.0, 0.5};
constexpr PassChange other{0.01, 0.2, 0.5};

// beam -> kept (reads itself) -> bloom -> show, which also reads kept.
Look scope_look() {
    Look look;
    const auto add = [&](const char* name, std::initializer_list<const char*> reads) {
        Pass pass;
        pass.name = name;
        for (const char* read : reads)
            pass.inputs.push_back({read, Input::From::pass, read, 0, {}});
        look.passes.push_back(pass);
    };
    add("beam", {});
    add("kept", {"beam", "kept"});
    add("bloom", {"kept"});
    add("show", {"kept", "bloom"});
    return look;
}

Parameter used_by(int pass) {
    Parameter parameter;
    parameter.name = "knob";
    parameter.bindings = {{pass, "knob"}};
    return parameter;
}
}  // namespace

TEST_CASE("a change that reaches the picture is reported in 8-bit levels") {
    const Look look = scope_look();
    const PassChange picture{0.8 / 255.0, 14.0 / 255.0, 0.3};
    const auto effect = effect_of(look, used_by(0), {other, other, other, picture});
    CHECK(effect.kind == Kind::seen);
    CHECK(effect_text(effect, picture) ==
          "changes the picture by up to 14 of 255 levels, 0.8 on average");

    const PassChange little{0.0, 0.4 / 255.0, 0.3};
    const auto faint = effect_of(look, used_by(0), {other, other, other, little});
    CHECK(faint.kind == Kind::faint);
    CHECK(effect_text(faint, little) == "too small to see: at most 0.4 of 255 levels");
}

TEST_CASE("a change that does not reach the picture names the pass where it ends") {
    const Look look = scope_look();
    const auto effect = effect_of(look, used_by(2), {same, same, other, same});
    CHECK(effect.kind == Kind::lost);
    CHECK(effect.last_changed == "bloom");
    CHECK(effect.ends == std::vector<std::string>{"show"});
    CHECK(effect_text(effect, same) == "doesn't change the picture: its effect ends in \"show\"");

    const auto earlier = effect_of(look, used_by(0), {other, other, same, same});
    CHECK(earlier.ends == std::vector<std::string>{"bloom", "show"});
    CHECK(effect_text(earlier, same) ==
          "doesn't change the picture: its effect ends in \"bloom\", \"show\"");

    Look unread = look;
    unread.passes.back().inputs.pop_back();
    const auto dead = effect_of(unread, used_by(1), {same, same, other, same});
    CHECK(dead.ends == std::vector<std::string>{"kept"});  // uses it itself
    CHECK(effect_text(effect_of(unread, used_by(2), {same, same, other, same}), same) ==
          "doesn't change the picture: no pass reads \"bloom\"");
}

TEST_CASE("if no pass changes, the passes that use the parameter are named") {
    const Look look = scope_look();
    const auto effect = effect_of(look, used_by(3), {same, same, same, same});
    CHECK(effect.kind == Kind::none);
    CHECK(effect_text(effect, same) == "has no effect: the output of \"show\" stays the same");
    Parameter unused;
    unused.name = "knob";
    CHECK(effect_text(effect_of(look, unused, {same, same, same, same}), same) ==
          "has no effect: no pass uses it");
}

TEST_CASE("the bar of a pass is its share of change on a logarithmic scale") {
    CHECK(change_share(same) == 0.0);
    CHECK(change_ratio(same) == 0.0);
    CHECK(std::abs(change_share({0.05, 1.0, 0.5}) - 0.1) < 1e-12);
    CHECK(std::abs(change_ratio({0.05, 1.0, 0.5}) - 0.75) < 1e-12);  // of 10^-4 .. 1
    CHECK(std::abs(change_ratio({0.005, 1.0, 0.5}) - 0.5) < 1e-12);
    CHECK(change_ratio({1e-9, 1e-6, 0.5}) == 0.02);  // above 0
    CHECK(change_share({0.3, 1.0, 0.0}) == 1.0);     // the reference is 0
    const double infinite = std::numeric_limits<double>::infinity();
    CHECK(change_share({infinite, infinite, 0.5}) == 1.0);
}
