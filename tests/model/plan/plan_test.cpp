#include "model/plan/plan.h"

#include "model/plan/parameter_use.h"

#include <doctest/doctest.h>

namespace {
Pass pass(const char* name, std::vector<Input> inputs = {}) {
    Pass made;
    made.name = name;
    made.inputs = std::move(inputs);
    made.declared = {"look.json", 7};
    return made;
}

Input reads(const char* name, int frames_ago = 0, bool mipmap = false) {
    return {"from_" + std::string(name),
            Input::From::pass,
            name,
            frames_ago,
            {Filter::linear, Wrap::edge, mipmap}};
}

Parameter parameter_named(const char* name, double initial, std::vector<Binding> bindings) {
    Parameter made;
    made.name = name;
    made.initial = initial;
    made.bindings = std::move(bindings);
    return made;
}

// beam -> persistence (reads itself) -> bloom -> composite, as in an oscilloscope look.
Look scope() {
    Look look;
    look.passes = {pass("beam"), pass("persistence", {reads("beam"), reads("persistence", 1)}),
                   pass("bloom", {reads("persistence")}),
                   pass("composite", {reads("persistence"), reads("bloom")})};
    look.parameters = {parameter_named("gain", 1, {{0, "gain"}}),
                       parameter_named("decay", 0.9, {{1, "decay"}}),
                       parameter_named("glow", 1, {{2, "glow"}}),
                       parameter_named("exposure", 1, {{3, "exposure"}})};
    return look;
}

std::string problem(const Look& look, Extent viewport = {100, 50}) {
    const auto plan = plan_targets(look, viewport, {}, {}, {.largest_side = 1000});
    REQUIRE_FALSE(plan.has_value());
    return to_string(plan.error().front());
}
}  // namespace

TEST_CASE("the size of a pass is relative to viewport or source, in pixels, or an expression") {
    Look look;
    look.passes = {pass("a"), pass("b"), pass("c")};
    look.passes[0].size = {Side{Side::By::viewport, 0.5, {}}, Side{Side::By::source, 2.0, {}}};
    look.passes[1].size = {Side{Side::By::pixels, 33, {}}, Side{Side::By::pixels, 1, {}}};
    look.passes[2].size = {Side{Side::By::expression, 1, "$WIDTH / floor($cell)"},
                           Side{Side::By::expression, 1, "max($HEIGHT - 10, 1)"}};
    look.parameters = {parameter_named("cell", 4.5, {})};

    const Plan plan = plan_targets(look, {640, 480}, {320, 200}, {}).value();
    CHECK(plan.targets[0].extent == Extent{320, 400});
    CHECK(plan.targets[1].extent == Extent{33, 1});
    CHECK(plan.targets[2].extent == Extent{160, 470});

    const Plan finer = plan_targets(look, {640, 480}, {320, 200}, {{"cell", 2.0}}).value();
    CHECK(finer.targets[2].extent == Extent{320, 470});
}

TEST_CASE("a share of a small viewport is at least one texel") {
    Look look;
    look.passes = {pass("tiny")};
    look.passes[0].size.fill({Side::By::viewport, 0.001, {}});
    CHECK(plan_targets(look, {64, 64}, {}, {}).value().targets[0].extent == Extent{1, 1});
}

TEST_CASE("an impossible size is an error at the pass's line") {
    Look look;
    look.passes = {pass("big")};
    look.passes[0].size.fill({Side::By::pixels, 1000, {}});
    CHECK(plan_targets(look, {1, 1}, {}, {}, {.largest_side = 1000}).has_value());
    look.passes[0].size[1].factor = 1001;
    CHECK(problem(look) ==
          "look.json:7: error: pass 'big' would be 1000 x 1001 px; each side must be 1 to 1000 px");
    look.passes[0].size[1].factor = 0;
    CHECK(problem(look).find("1000 x 0 px") != std::string::npos);
    look.passes[0].size[1].factor = -1e300;
    CHECK_FALSE(problem(look).empty());
    look.passes[0].size.fill({Side::By::source, 1, {}});  // without a source
    CHECK(problem(look).find("0 x 0 px") != std::string::npos);
}

TEST_CASE("an invalid size expression is an error at the pass's line") {
    Look look;
    look.passes = {pass("odd")};
    look.passes[0].size = {Side{Side::By::pixels, 5000, {}},
                           Side{Side::By::expression, 1, "$HIGHT"}};
    CHECK(problem(look) == "look.json:7: error: size of pass 'odd': unknown name '$HIGHT'");
}

TEST_CASE("a target has slots for the oldest frame that any input reads") {
    Look look = scope();
    look.passes[3].inputs.push_back(reads("beam", 3, true));
    Input source{"s", Input::From::source, "source", 2, {}};
    look.passes[0].inputs.push_back(source);
    const Plan plan = plan_targets(look, {8, 8}, {8, 8}, {}).value();
    CHECK(plan.targets[0].slots == 4);
    CHECK(plan.targets[0].mipmapped);
    CHECK(plan.targets[1].slots == 2);
    CHECK_FALSE(plan.targets[1].mipmapped);
    CHECK(plan.targets[2].slots == 1);
    CHECK(plan.source_slots == 3);
}

TEST_CASE("memory is texels times bytes times slots") {
    const Plan plan{{{{100, 10}, Format::rgba16f, 2, false}, {{8, 8}, Format::r32f, 1, false}}, 1};
    CHECK(memory_of(plan) == 100 * 10 * 8 * 2 + 8 * 8 * 4);
    // Each mipmap level has a quarter of the texels of the previous one: a third more in all.
    CHECK(memory_of({{{{96, 32}, Format::rgba16f, 1, true}}, 1}) == 96 * 32 * 8 * 4 / 3);
}

TEST_CASE("one_channel stores only red, unless an override sets the format") {
    Look look;
    look.passes = {pass("light")};
    look.passes[0].format = Format::rgba32f;
    look.passes[0].one_channel = "$mono * 2";
    look.parameters = {parameter_named("mono", 0.0, {})};
    const auto format = [&look](double mono, const PassOverrides& overrides = {}) {
        const Look drawn = with_overrides(look, overrides);
        return plan_targets(drawn, {8, 8}, {}, {{"mono", mono}}).value().targets[0].format;
    };
    CHECK(format(0.0) == Format::rgba32f);
    CHECK(format(1.0) == Format::r32f);
    CHECK(format(1.0, {{"light", {Format::rgba16f, {}, {}}}}) == Format::rgba16f);
    CHECK(is_used_by(look, 0, look.parameters[0]));
    look.passes[0].one_channel = "$mono +";
    CHECK(problem(look).starts_with("look.json:7: error: 'one_channel' of pass 'light': "));
}

TEST_CASE("the spot is given by the look's expression, and is half a texel without one") {
    Look look;
    look.passes = {pass("beam")};
    look.passes[0].scope = "scope/";
    look.parameters = {parameter_named("scope/width", 3.0, {})};
    const auto spot = [&look](const Values& values = {}) {
        return spot_of(look, look.passes[0], {200, 100}, {50, 25}, values).value();
    };
    CHECK(spot() == BeamSpot{2.0 * 0.5 / 50, 2.0 * 0.5 / 25});
    look.passes[0].spot = {"$width / $WIDTH", "2 * $width / $HEIGHT"};
    CHECK(spot() == BeamSpot{3.0 / 200, 6.0 / 100});
    CHECK(spot({{"scope/width", Value(8.0)}}) == BeamSpot{8.0 / 200, 16.0 / 100});
    CHECK(spot({{"scope/width", Value(-1.0)}}) == BeamSpot{});
    CHECK(is_used_by(look, 0, look.parameters[0]));
    look.passes[0].spot[1] = "$widht";
    CHECK(problem(look) == "look.json:7: error: 'spot' of pass 'beam': unknown name '$widht'");
}

TEST_CASE("a parameter affects its passes and those that read them") {
    const Redraw composite = redraw_after(scope(), {"exposure"});
    CHECK(composite.passes == std::vector<bool>{false, false, false, true});
    CHECK_FALSE(composite.needs_replay);
    const Redraw bloom = redraw_after(scope(), {"glow"});
    CHECK(bloom.passes == std::vector<bool>{false, false, true, true});
    CHECK_FALSE(bloom.needs_replay);
    CHECK(redraw_after(scope(), {"no_such"}).passes ==
          std::vector<bool>{false, false, false, false});
}

TEST_CASE("a parameter of a pass before feedback needs a replay") {
    const Redraw gain = redraw_after(scope(), {"gain"});
    CHECK(gain.passes == std::vector<bool>{true, true, true, true});
    CHECK(gain.needs_replay);
    CHECK(redraw_after(scope(), {"decay"}).needs_replay);
}

TEST_CASE("a parameter that repeats or sizes a pass affects it too") {
    Look look = scope();
    look.passes[2].repeat = "rounds";
    look.passes[3].size[0] = {Side::By::expression, 1, "$WIDTH / $cell"};
    look.parameters.push_back(parameter_named("rounds", 1, {}));
    look.parameters.push_back(parameter_named("cell", 1, {}));
    CHECK(redraw_after(look, {"rounds"}).passes == std::vector<bool>{false, false, true, true});
    CHECK(redraw_after(look, {"cell"}).passes == std::vector<bool>{false, false, false, true});
}

TEST_CASE("a parameter of another look in the stack does not size a pass") {
    Look look = scope();
    look.passes[3].scope = "b/";
    look.passes[3].size[0] = {Side::By::expression, 1, "$WIDTH / $cell"};
    look.parameters.push_back(parameter_named("a/cell", 1, {}));
    look.parameters.push_back(parameter_named("b/cell", 1, {}));
    CHECK(redraw_after(look, {"a/cell"}).passes == std::vector<bool>(4, false));
    CHECK(redraw_after(look, {"b/cell"}).passes == std::vector<bool>{false, false, false, true});
}

TEST_CASE("a parameter does not affect readers of a previous frame, but needs a replay") {
    Look look = scope();
    look.passes[3].inputs = {reads("bloom", 2)};
    const Redraw glow = redraw_after(look, {"glow"});
    CHECK(glow.passes == std::vector<bool>{false, false, true, false});
    CHECK(glow.needs_replay);
}

TEST_CASE("a parameter before an accumulating pass restarts its samples, one after it does not") {
    Look look = scope();
    look.passes[2].accumulate = true;
    CHECK_FALSE(redraw_after(look, {"exposure"}).needs_replay);
    CHECK(redraw_after(look, {"glow"}).needs_replay);
}

TEST_CASE("the number of samples of an accumulating pass does not affect the samples") {
    Look look = scope();
    look.passes[2].accumulate = true;
    look.passes[2].repeat = "rounds";
    look.passes[2].converge = Count("enough");
    look.parameters.push_back(parameter_named("rounds", 1, {{2, "rounds"}}));
    look.parameters.push_back(parameter_named("enough", 1, {{2, "enough"}}));
    CHECK(redraw_after(look, {"rounds", "enough"}).passes == std::vector<bool>(4, false));
    look.passes[2].accumulate = false;
    look.passes[2].converge.reset();
    CHECK(redraw_after(look, {"rounds"}).passes == std::vector<bool>{false, false, true, true});
}

TEST_CASE("dependencies of a pass are found through feedback loops") {
    CHECK(dependencies_of(scope(), 3) == std::vector<bool>{true, true, true, true});
    CHECK(dependencies_of(scope(), 1) == std::vector<bool>{true, true, false, false});
    CHECK(dependencies_of(scope(), 0) == std::vector<bool>{true, false, false, false});
}

TEST_CASE("passes read from past frames are carried over, with their dependencies") {
    CHECK(feedback_passes(scope()) == std::vector<bool>{true, true, false, false});
    Look look = scope();
    look.passes.back().accumulate = true;
    CHECK(feedback_passes(look) == std::vector<bool>{true, true, true, true});
    for (Pass& pass : look.passes) {
        pass.accumulate = false;
        for (Input& input : pass.inputs)
            input.frames_ago = 0;
    }
    CHECK(feedback_passes(look) == std::vector<bool>(4, false));
}

TEST_CASE("an override changes the pass and the inputs that read it") {
    PassOverrides overrides;
    overrides["persistence"] = {Format::r32f, 0.5, Filter::nearest};
    const Look look = with_overrides(scope(), overrides);
    CHECK(look.passes[1].format == Format::r32f);
    CHECK(look.passes[1].size[0].factor == 0.5);
    CHECK(look.passes[2].inputs[0].sampler.filter == Filter::nearest);
    CHECK(look.passes[3].inputs[1].sampler.filter == Filter::linear);
    CHECK(with_overrides(scope(), {}) == scope());
}

namespace {
// The beam may be drawn onto the persistence while the parameter `plain` is above 0.
Look sharing_scope() {
    Look look = scope();
    look.passes[0].onto = Onto{"persistence", "$plain"};
    for (const std::size_t pass : {0U, 1U})
        look.passes[pass].format = Format::rgba16f;
    look.parameters.push_back(parameter_named("plain", 1, {}));
    return look;
}

Plan sharing_plan(const PlanTerms& terms, double plain = 1.0) {
    return plan_targets(sharing_scope(), {100, 10}, {}, {{"plain", plain}}, terms).value();
}
}  // namespace

TEST_CASE("a pass is drawn onto another target if the look allows it and neither is displayed") {
    const PlanTerms last_seen{.seen = {false, false, false, true}};
    const Plan shared = sharing_plan(last_seen);
    CHECK(shared.targets[0] == PlannedTarget{{100, 10}, Format::rgba16f, 1, false, 1});
    CHECK(draw_order(shared) == std::vector<std::size_t>{1, 0, 2, 3});
    CHECK(is_drawn_onto(sharing_scope(), shared, 1));
    CHECK(is_drawn_onto(sharing_scope(), shared, 2));
    CHECK_FALSE(is_drawn_onto(sharing_scope(), shared, 0));
    const Plan apart = sharing_plan({});
    CHECK(apart.targets[0] == PlannedTarget{{100, 10}, Format::rgba16f});
    CHECK(draw_order(apart) == std::vector<std::size_t>{0, 1, 2, 3});
    CHECK_FALSE(is_drawn_onto(sharing_scope(), apart, 1));
    // The beam's 8 bytes per texel are replaced by one texel.
    CHECK(memory_of(apart) - memory_of(shared) == 100 * 10 * 8 - 8);

    CHECK(sharing_plan(last_seen, 0.0) == apart);
    CHECK(sharing_plan({.seen = {true, false, false, true}}) == apart);
    CHECK(sharing_plan({.seen = {false, true, false, true}}) == apart);
    CHECK(sharing_plan({.seen = last_seen.seen, .kept = {true}}) == apart);
    CHECK(sharing_plan({.seen = last_seen.seen, .kept = {false, true, false, false}}) == apart);
}

TEST_CASE("targets are not shared if they differ or the user has overridden either") {
    const PlanTerms last_seen{.seen = {false, false, false, true}};
    const auto shares = [&](const Look& look) {
        const auto plan = plan_targets(look, {100, 10}, {}, {}, last_seen);
        return plan.value().targets[0].onto.has_value();
    };
    CHECK(shares(sharing_scope()));
    Look finer = sharing_scope();
    finer.passes[0].format = Format::rgba32f;
    CHECK_FALSE(shares(finer));
    Look smaller = sharing_scope();
    smaller.passes[0].size.fill({Side::By::viewport, 0.5, {}});
    CHECK_FALSE(shares(smaller));
    PassOverride linear;
    linear.filter = Filter::linear;
    CHECK_FALSE(shares(with_overrides(sharing_scope(), {{"persistence", linear}})));
    CHECK_FALSE(shares(with_overrides(sharing_scope(), {{"beam", linear}})));
}

TEST_CASE("the parameter that decides about target sharing is found") {
    Look look = sharing_scope();
    CHECK(affects_aliasing(look, look.parameters.back()));
    CHECK_FALSE(affects_aliasing(look, look.parameters.front()));
    CHECK(is_used_by(look, 0, look.parameters.back()));
    look.passes[0].onto->where = "$plan";
    CHECK(problem(look) == "look.json:7: error: 'onto' of pass 'beam': unknown name '$plan'");
}

TEST_CASE("half_floats halves the float size, and may depend on one component of a value") {
    Look look;
    look.passes = {pass("light")};
    look.passes[0].format = Format::rgba32f;
    look.passes[0].half_floats = "$speed.y - 2";
    look.parameters = {parameter_named("speed", 0.0, {})};
    const auto format = [&look](double x, double y) {
        return plan_targets(look, {8, 8}, {}, {{"speed", Value({x, y, 0.0})}})
            .value()
            .targets[0]
            .format;
    };
    CHECK(format(5.0, 1.0) == Format::rgba32f);
    CHECK(format(0.0, 3.0) == Format::rgba16f);
    look.passes[0].one_channel = "$speed";
    CHECK(format(1.0, 3.0) == Format::r16f);
    CHECK(is_used_by(look, 0, look.parameters[0]));
    look.passes[0].half_floats = "$speed.w";
    CHECK(problem(look) ==
          "look.json:7: error: 'half_floats' of pass 'light': unknown name '$speed.w'");
}
