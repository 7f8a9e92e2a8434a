#include "model/plan/pass_switches.h"

#include <doctest/doctest.h>

namespace {
Pass switched_pass(const std::string& name, std::vector<Input> inputs = {}) {
    Pass pass;
    pass.name = name;
    pass.inputs = std::move(inputs);
    return pass;
}

Input from(Input::From kind, const std::string& name = {}, int frames_ago = 0) {
    return {"in_" + name, kind, name, frames_ago, {}};
}

using From = Input::From;

// beam draws; light adds it to its previous frame; glow blurs light; screen shows both.
Look four_passes() {
    Look look;
    look.passes = {switched_pass("beam"),
                   switched_pass("light", {from(From::pass, "light", 1), from(From::pass, "beam")}),
                   switched_pass("glow", {from(From::pass, "light")}),
                   switched_pass("screen", {from(From::pass, "light"), from(From::pass, "glow")})};
    return look;
}

std::string reason(const Result<PassSwitches>& result) {
    return result ? std::string() : result.error().front().message;
}
using Runs = std::vector<PassRun>;
}  // namespace

TEST_CASE("a pass switch toggles on and off") {
    const Look look = four_passes();
    for (const PassSwitch which :
         {PassSwitch::bypass, PassSwitch::freeze, PassSwitch::solo, PassSwitch::stop}) {
        const auto on = switched(look, {}, which, "glow");
        REQUIRE(on.has_value());
        CHECK(on->has(which, "glow"));
        CHECK_FALSE(on->has(which, "light"));
        CHECK(switched(look, *on, which, "glow") == PassSwitches{});
    }
    CHECK(reason(switched(look, {}, PassSwitch::freeze, "lost")) == "there is no pass 'lost'");
}

TEST_CASE("a bypassed pass passes on its first input that is not its own output") {
    const Look look = four_passes();
    REQUIRE(passed_input(look.passes[1]));
    CHECK(passed_input(look.passes[1])->name == "beam");
    CHECK(passed_input(look.passes[3])->name == "light");
    CHECK(passed_input(switched_pass("tinted", {from(From::image, "lut"), from(From::source)}))
              ->from == From::source);
    CHECK(passed_input(switched_pass("shown", {from(From::image, "lut")}))->name == "lut");
}

TEST_CASE("a pass without a usable input cannot be bypassed, and the reason is reported") {
    Look look = four_passes();
    look.passes.push_back(switched_pass("count", {from(From::pass, "count", 1)}));
    CHECK(reason(switched(look, {}, PassSwitch::bypass, "beam")) ==
          "'beam' can't be bypassed: it has no inputs");
    CHECK(reason(switched(look, {}, PassSwitch::bypass, "count")) ==
          "'count' can't be bypassed: it reads only its own output");
}

TEST_CASE("solo and stop select which pass is displayed, and replace each other") {
    const Look look = four_passes();
    CHECK(picture_pass(look, {}) == 3);
    const auto solo = switched(look, {}, PassSwitch::solo, "beam");
    CHECK(picture_pass(look, *solo) == 0);
    CHECK(runs_of(look, *solo).empty());
    const auto stop = switched(look, *solo, PassSwitch::stop, "light");
    CHECK(picture_pass(look, *stop) == 1);
    CHECK(stop->solo.empty());
    CHECK(switched(look, *stop, PassSwitch::solo, "glow")->last.empty());
}

TEST_CASE("freeze takes precedence over the other pass switches") {
    const Look look = four_passes();
    const PassSwitches switches{{"light", "glow"}, {"glow"}, "", "glow"};
    CHECK(runs_of(look, switches) ==
          Runs{PassRun::drawn, PassRun::bypassed, PassRun::frozen, PassRun::left_out});
    CHECK(runs_of(look, {}).empty());
}

TEST_CASE("switches of removed passes and bypasses without an input are dropped") {
    Look look = four_passes();
    const PassSwitches switches{{"light", "glow"}, {"screen", "lost"}, "glow", ""};
    look.passes[2].name = "halo";
    look.passes[1].inputs.clear();
    CHECK(known_switches(look, switches) == PassSwitches{{}, {"screen"}, "", ""});
}
