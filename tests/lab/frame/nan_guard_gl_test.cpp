// A non-finite number pauses the clock, in the window.
#include "lab/small_lab.h"

#include <cmath>

namespace {
constexpr const char* calm = R"(#version 410 core
in vec2 uv;
out vec4 color;
void main() { color = vec4(0.5); }
)";
constexpr const char* spark = R"(#version 410 core
uniform float none = 0.0;  // @hidden
uniform int u_frame;
in vec2 uv;
out vec4 color;
void main() {
    bool is_bad = u_frame == 40 && ivec2(gl_FragCoord.xy) == ivec2(3, 4);
    color = vec4(is_bad ? 1.0 / none : 0.0);
}
)";
constexpr const char* sum_of_sparks = R"(#version 410 core
uniform sampler2D previous;
uniform sampler2D fresh;
in vec2 uv;
out vec4 color;
void main() { color = texture(previous, uv) + texture(fresh, uv); }
)";

constexpr const char* wrong_at_40 = R"(#version 410 core
uniform sampler2D previous;
uniform float step_size = 1.0;  // @range 0 4
uniform float none = 0.0;  // @hidden
uniform float danger = 1.0;  // @range 0 1
uniform int u_frame;
in vec2 uv;
out vec4 color;
void main() {
    bool is_bad = u_frame == 40 && danger > 0.5 && ivec2(gl_FragCoord.xy) == ivec2(3, 4);
    color = is_bad ? vec4(none / none) : texture(previous, uv) + step_size;
}
)";

/// A lab with a look that counts frames and writes NaN to one texel in frame 40.
struct DetectingHeadless : SmallLab {
    DetectingHeadless() {
        write_by_rename("sum.frag", wrong_at_40);
        REQUIRE(update_until([&] { return find_parameter(document().look(), "none"); }));
        lab().frames().restart();
    }
    void wait_for_non_finite() {
        REQUIRE(update_until([&] { return lab().frames().nan_guard().found().has_value(); }));
        REQUIRE(update_until([&] { return !lab().renderer()->replay().is_running(); }));
    }
    float sum(int frames_ago_row) {
        return gpu::read_pixel(lab().renderer()->executor().target(0), 3, frames_ago_row)[0];
    }
};
}  // namespace

TEST_CASE("the first non-finite number pauses the clock at its frame with a valid history") {
    DetectingHeadless lab;
    lab.wait_for_non_finite();
    CHECK(*lab.lab().frames().nan_guard().found() == NonFinitePixel{0, 3, 3, 40});
    CHECK_FALSE(lab.player().transport().is_playing());
    CHECK(lab.player().transport().frame_number() == 40);
    CHECK(std::isnan(lab.sum(3)));
    CHECK(lab.sum(5) == 20.0f);  // settle_frames of history
}

TEST_CASE("clamping continues with 0 instead of NaN") {
    DetectingHeadless lab;
    lab.wait_for_non_finite();
    lab.lab().frames().nan_guard().set_action(NonFiniteAction::clamp);
    CHECK_FALSE(lab.lab().frames().nan_guard().found());
    CHECK(lab.player().transport().is_playing());
    lab.update(3);
    CHECK(lab.frames() == 43.0f);
    CHECK(lab.sum(3) == 3.0f);
    CHECK(lab.sum(5) == 23.0f);
}

TEST_CASE("clearing restarts the history, and ignoring never asks again") {
    DetectingHeadless lab;
    lab.wait_for_non_finite();
    lab.lab().frames().nan_guard().set_action(NonFiniteAction::clear);
    lab.update(2);
    CHECK(lab.sum(3) == 2.0f);
    lab.lab().frames().restart();
    lab.wait_for_non_finite();
    lab.lab().frames().nan_guard().set_action(NonFiniteAction::ignore);
    lab.update(10);
    CHECK_FALSE(lab.lab().frames().nan_guard().found());
    CHECK(std::isnan(lab.sum(3)));
}

TEST_CASE("in unattended mode NaN is clamped and reported once") {
    DetectingHeadless lab;
    lab.lab().frames().nan_guard().set_unattended(true);
    REQUIRE(lab.update_until([&] {
        return lab.lab().messages().notice() && lab.lab().messages().notice()->is_problem;
    }));
    CHECK(lab.lab().messages().notice()->text.find("pass 'sum'") != std::string::npos);
    CHECK(lab.lab().messages().notice()->text.find("pixel (3, 3), frame 40") != std::string::npos);
    CHECK_FALSE(lab.lab().frames().nan_guard().found());
    CHECK(lab.player().transport().is_playing());
    CHECK(std::isfinite(lab.sum(3)));
}

TEST_CASE("a value that fixes the NaN lets time continue with a valid history") {
    DetectingHeadless lab;
    lab.wait_for_non_finite();
    lab.lab().edit([](Document& document) { document.set_value("danger", Value(0.0)); });
    REQUIRE(lab.update_until([&] { return lab.player().transport().is_playing(); }));
    CHECK_FALSE(lab.lab().frames().nan_guard().found());
    lab.update(10);
    CHECK_FALSE(lab.lab().frames().nan_guard().found());
    CHECK(lab.frames() >= 49.0f);
    CHECK(lab.sum(3) == lab.sum(5));
}

TEST_CASE("a value that does not fix the NaN keeps the clock paused") {
    DetectingHeadless lab;
    lab.wait_for_non_finite();
    lab.lab().edit([](Document& document) { document.set_value("danger", Value(0.9)); });
    lab.update(1);
    CHECK_FALSE(lab.lab().frames().nan_guard().found());
    lab.wait_for_non_finite();
    CHECK(*lab.lab().frames().nan_guard().found() == NonFinitePixel{0, 3, 3, 40});
    CHECK_FALSE(lab.player().transport().is_playing());
}

TEST_CASE("an edit that fixes the NaN lets time continue") {
    DetectingHeadless lab;
    lab.wait_for_non_finite();
    lab.write_by_rename("sum.frag", small_look::sum);
    REQUIRE(lab.update_until([&] { return lab.player().transport().is_playing(); }));
    lab.update(10);
    CHECK_FALSE(lab.lab().frames().nan_guard().found());
    CHECK(std::isfinite(lab.sum(3)));
}

TEST_CASE("the pass that wrote it first is reported, even if another one was checked first") {
    SmallLab lab;
    lab.write("calm.frag", calm);
    lab.write("spark.frag", spark);
    lab.write_by_rename("sum.frag", sum_of_sparks);
    lab.write_by_rename("look.json", R"({
  "format": "afterglow-look", "version": 1, "name": "Small", "driven_by": "nothing", "settle_frames": 4,
  "passes": [
    { "name": "calm", "fragment": "calm.frag", "format": "rgba8" },
    { "name": "spark", "fragment": "spark.frag", "format": "rgba16f" },
    { "name": "sum", "fragment": "sum.frag", "format": "rgba32f", "inputs": { "previous": "sum@1", "fresh": "spark" } }
  ]
})");
    REQUIRE(lab.update_until([&] { return lab.document().look().passes.size() == 3; }));
    lab.lab().frames().restart();
    REQUIRE(lab.update_until([&] { return lab.lab().frames().nan_guard().found().has_value(); }));
    CHECK(lab.lab().frames().nan_guard().found()->frame == 40);
    REQUIRE(lab.update_until([&] { return !lab.lab().renderer()->replay().is_running(); }));
    lab.update(1);
    CHECK(*lab.lab().frames().nan_guard().found() == NonFinitePixel{1, 3, 3, 40});
}

TEST_CASE("formats that cannot store NaN are not checked") {
    SmallLab lab(replaced(replaced(small_look::manifest, "rgba32f", "rgba8"), "rgba32f", "rgba8"));
    lab.update(3);
    CHECK_FALSE(lab.lab().frames().nan_guard().is_waiting());
}
