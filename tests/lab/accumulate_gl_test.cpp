// Accumulating looks in the window.
#include "lab/document/parameter_edits.h"
#include "lab/small_lab.h"

namespace {
constexpr const char* accumulating_manifest = R"({
  "format": "afterglow-look", "version": 1, "name": "Small", "driven_by": "nothing", "settle_frames": 20, "orbit": true,
  "passes": [
    { "name": "sum", "fragment": "sum.frag", "format": "rgba32f", "blend": "add", "accumulate": true, "converge": 6 },
    { "name": "show", "fragment": "show.frag", "format": "rgba32f", "inputs": { "image": "sum" } }
  ]
})";
constexpr const char* sum = R"(#version 410 core
uniform float step_size = 1.0;  // @range 0 4
uniform mat4 u_camera;
out vec4 color;
void main() { color = vec4(step_size * u_camera[0].x); }
)";

class Accumulating : public SmallLab {
public:
    Accumulating() : SmallLab(replaced(accumulating_manifest, R"(, "orbit": true)", "").c_str()) {
        write("sum.frag", sum);
        write("look.json", accumulating_manifest);
        REQUIRE(update_until([&] { return lab().document()->look().has_orbit && held() >= 1; }));
        REQUIRE(update_until([&] { return lab().frames().has_converged(); }));
    }
    int held() { return lab().frames().samples().value_or(Samples{}).held; }
    void set(const char* name, double value) {
        lab().edit([&](Document& document) { document.set_value(name, Value(value)); });
    }
};
}  // namespace

TEST_CASE("after the last sample nothing is drawn and the frame number stays") {
    Accumulating small;
    CHECK(small.shown() == 6);
    CHECK(small.update_until([&] { return !small.lab().is_moving(); }));
    const float frames = small.frames();
    small.update(5);
    CHECK(small.frames() == frames);
    CHECK(small.held() == 6);
}

TEST_CASE("a parameter of a later pass is drawn at once and keeps the samples") {
    Accumulating small;
    small.set("gain", 2.0);
    small.update(1);
    CHECK(small.shown() == 12);
    CHECK(small.held() == 6);
}

TEST_CASE("changes to the accumulated picture restart the samples") {
    Accumulating small;
    float shown = 6;
    SUBCASE("a parameter") {
        small.set("step_size", 2.0);
        shown = 12;
    }
    SUBCASE("the camera") {
        small.lab().edit([](Document& document) {
            set_orbit(document, [](const Orbit& orbit) { return with_distance_scaled(orbit, 2); });
        });
        shown = 12;
    }
    SUBCASE("a size") {
        small.lab().work().size.choose({false, {10, 8}, 1.0});
    }
    SUBCASE("restart") {
        small.lab().frames().restart();
    }
    SUBCASE("undo") {
        small.set("step_size", 2.0);
        small.update(20);
        small.lab().edit([](Document& document) { document.undo(); });
    }
    small.update(1);
    CHECK(small.held() == 1);
    CHECK(small.lab().is_moving());
    REQUIRE(small.update_until([&] { return small.lab().frames().has_converged(); }));
    CHECK(small.shown() == shown);
}

TEST_CASE("an edited shader restarts the samples") {
    Accumulating small;
    small.write_by_rename("sum.frag", replaced(sum, "vec4(step_size", "vec4(3.0 * step_size"));
    CHECK(small.update_until(
        [&] { return small.lab().frames().has_converged() && small.shown() == 18; }));
}

TEST_CASE("a change while paused draws the same number of samples again") {
    Accumulating small;
    small.lab().player().pause();
    small.set("step_size", 2.0);
    REQUIRE(small.update_until([&] { return !small.lab().is_moving(); }));
    CHECK(small.shown() == 12);
}
