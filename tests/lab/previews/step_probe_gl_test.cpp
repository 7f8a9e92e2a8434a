// The effect of one slider step, computed in the background.
#include "lab/previews/previews.h"
#include "lab/small_lab.h"

#include <cmath>

namespace {
// `sum` accumulates `light` over the frames. `show` adds `level`, and `hidden` only if `opens` is
// on.
constexpr const char* counting_text = R"(#version 410 core
uniform sampler2D previous;
uniform float light = 0.0;   // @range 0 1
uniform float hidden = 0.125;  // @range 0 1
in vec2 uv;
out vec4 color;
void main() { color = texture(previous, uv) * 0.5 + vec4(light, hidden, 0.0, 1.0); }
)";
constexpr const char* adding_text = R"(#version 410 core
uniform sampler2D image;
uniform float level = 0.25;  // @range 0 1
uniform float dead = 0.5;    // @range 0 1
uniform bool opens = false;
in vec2 uv;
out vec4 color;
void main() {
    vec4 texel = texture(image, uv);
    float shown = level + texel.r + (opens ? texel.g : 0.0) + 0.0 * dead;
    color = vec4(vec3(shown), 1.0);
}
)";

class Probing : public SmallLab {
public:
    Probing() {
        write_by_rename("sum.frag", counting_text);
        write_by_rename("show.frag", adding_text);
        REQUIRE(update_until([&] {
            return find_parameter(document().look(), "level") &&
                   find_parameter(document().look(), "light");
        }));
        update(30);
    }
    const StepProbe& ask(const char* parameter, bool is_up = true) {
        lab().frames().previews().probe().ask({parameter, 0, is_up});
        REQUIRE(update_until([&] { return !probe().is_busy(); }));
        return probe();
    }
    const StepProbe& probe() { return lab().frames().previews().probe(); }
    double seen() { return static_cast<double>(gpu::read_pixel(*probe().picture(), 3, 3)[1]); }
};

bool is_near_step(double a, double b, double tolerance = 1e-6) {
    return std::abs(a - b) <= tolerance;
}
}  // namespace

TEST_CASE("a step is shown as its change of the picture and of each pass") {
    Probing small;
    const StepProbe& up = small.ask("level");
    REQUIRE(up.effect().has_value());
    CHECK(up.effect()->kind == StepEffect::Kind::seen);
    REQUIRE(up.changes().size() == 2);
    CHECK_FALSE(up.changes()[0]->has_changed());
    CHECK(is_near_step(up.changes()[1]->mean, 0.01));  // 1/100 of the slider
    CHECK(is_near_step(up.changes()[1]->level, 0.25));
    CHECK(up.gain() == 32.0);  // the largest power of two up to 0.5 / 0.01
    CHECK(is_near_step(small.seen(), 0.5 + 32.0 * 0.01, 1e-5));
    CHECK(up.text() ==
          "Level 0.25 → 0.26: changes the picture by up to 3 of 255 levels, 3 on "
          "average · amplified 32×");

    small.ask("level", false);
    CHECK(is_near_step(small.seen(), 0.5 - 32.0 * 0.01, 1e-5));
    small.lab().frames().previews().probe().stop();
    CHECK_FALSE(small.probe().picture());
    CHECK_FALSE(small.probe().request().has_value());
}

TEST_CASE("a step includes its effect through the history") {
    Probing small;
    const StepProbe& up = small.ask("light");
    REQUIRE(up.effect().has_value());
    // 0.01 per frame, halved each frame: 0.02 in total, all but 2^-20 of it after twenty frames.
    CHECK(is_near_step(up.changes()[1]->mean, 0.02, 1e-4));
    CHECK(is_near_step(up.changes()[0]->mean, 0.02 / 3.0, 1e-4));  // red, one of three channels
}

TEST_CASE("a slider without effect reports the pass in which its effect ends") {
    Probing small;
    const StepProbe& hidden = small.ask("hidden");
    REQUIRE(hidden.effect().has_value());
    CHECK(hidden.effect()->kind == StepEffect::Kind::lost);
    CHECK(hidden.effect()->ends == std::vector<std::string>{"show"});
    CHECK(hidden.changes()[0]->has_changed());
    const StepProbe& dead = small.ask("dead");
    CHECK(dead.effect()->kind == StepEffect::Kind::none);
    CHECK(dead.text().ends_with("has no effect: the output of \"show\" stays the same"));
    CHECK(is_near_step(small.seen(), 0.5, 1e-6));

    small.lab().edit([](Document& document) { document.set_value("opens", Value(1.0)); });
    small.lab().frames().previews().probe().stop();
    CHECK(small.ask("hidden").effect()->kind == StepEffect::Kind::seen);
}

TEST_CASE("probing a step leaves clock, history and values unchanged") {
    Probing small;
    small.lab().edit([](Document& document) { document.set_value("light", Value(0.125)); });
    small.update(60);  // reaches 0.25 + 0.25
    const double time = small.player().transport().time();
    const DocumentState before = small.document().state();
    small.lab().frames().previews().probe().ask({"light", 0, true});
    int updates = 0;
    for (; small.probe().is_busy() && updates < 2000; ++updates)
        small.lab().update(1.0 / 60.0);
    CHECK(is_near_step(small.player().transport().time(), time + updates / 60.0,
                       1e-6));  // time continued
    CHECK(small.document().state() == before);
    CHECK(is_near_step(static_cast<double>(small.shown()), 0.5, 1e-5));
    small.update(1);
    CHECK(is_near_step(static_cast<double>(small.shown()), 0.5, 1e-5));
}

TEST_CASE("the end of a slider is reported, and the probe follows later changes") {
    Probing small;
    small.lab().edit([](Document& document) { document.set_value("level", Value(1.0)); });
    const StepProbe& end = small.ask("level");
    CHECK(end.has_failed());
    CHECK(end.text() == "Level is at its maximum");
    small.lab().edit([](Document& document) { document.set_value("level", Value(0.5)); });
    small.update(1);
    REQUIRE(small.update_until([&] { return !small.probe().is_busy(); }));
    CHECK(small.probe().text().starts_with("Level 0.5 → 0.51"));
}
