// The window reports the displayed passes. Other passes may be drawn into a shared target.
#include "lab/small_lab.h"
#include "lab/views/displayed_passes.h"
#include "lab/window/window_state.h"

namespace {
const char* const glowing = R"({
  "format": "afterglow-look", "version": 1, "name": "Small", "driven_by": "nothing", "settle_frames": 20,
  "passes": [
    { "name": "light", "fragment": "light.frag", "format": "rgba32f", "blend": "add", "onto": { "pass": "glow", "where": "1" } },
    { "name": "glow", "fragment": "glow.frag", "format": "rgba32f", "inputs": { "now": "light", "before": "glow@1" } },
    { "name": "show", "fragment": "show.frag", "format": "rgba32f", "inputs": { "image": "glow" } }
  ]
})";

/// Its glow increases by 1 per frame.
class GlowingLab : public SmallLab {
public:
    GlowingLab() {
        write("light.frag", replaced(small_look::sum, "texture(previous, uv)", "vec4(0.0)"));
        write("glow.frag",
              "#version 410 core\nuniform sampler2D now;\nuniform sampler2D before;\n"
              "uniform bool u_drawn_onto;\nin vec2 uv;\nout vec4 color;\n"
              "void main() {\n    color = texture(before, uv);\n"
              "    if (!u_drawn_onto)\n        color += texture(now, uv);\n}\n");
        write_by_rename("look.json", glowing);
        REQUIRE(update_until([&] { return document().look().passes.size() == 3; }));
        draw_frames(2);
        m_before = at(2) - frames();
    }

    /// Draws `count` frames to their end, however slow the machine is.
    void draw_frames(int count) {
        const auto is_drawn = [&] { return !lab().renderer()->has_unfinished_frame(); };
        for (int i = 0; i < count; ++i) {
            update(1);
            REQUIRE((is_drawn() || update_until(is_drawn)));
        }
    }
    void display(PassSelection passes) {
        lab().frames().set_displayed(std::move(passes));
        draw_frames(1);
    }
    float at(int pass) { return gpu::read_pixel(executor().target(pass), 3, 3)[0]; }
    const Executor& executor() { return lab().renderer()->executor(); }
    bool is_shared() { return executor().plan().targets[0].onto.has_value(); }
    /// Whether the light of all frames is present.
    bool has_all_light() { return at(2) == frames() + m_before && at(1) == at(2); }

private:
    float m_before = 0.0f;
};

const PassSelection picture_alone{.are_all = false};
}  // namespace

TEST_CASE("displaying and hiding passes neither loses nor doubles light") {
    GlowingLab small;
    CHECK(small.has_all_light());
    for (int n = 0; n < 6; ++n) {
        CAPTURE(n);
        small.display(n % 2 == 0 ? picture_alone : PassSelection());
        CHECK(small.is_shared() == (n % 2 == 0));
        CHECK(small.has_all_light());
        CHECK(small.at(0) == 1.0f);
        small.draw_frames(n);
        CHECK(small.has_all_light());
    }
    small.display({.are_all = false, .names = {"light"}});
    CHECK_FALSE(small.is_shared());
}

TEST_CASE("a static picture draws its passes as soon as they are displayed") {
    GlowingLab small;
    small.display(picture_alone);
    small.lab().player().pause();
    REQUIRE(small.update_until([&] { return !small.lab().is_moving(); }));
    const float frames = small.frames();
    CHECK(small.is_shared());
    for (const bool is_seen : {true, false, true}) {
        small.display(is_seen ? PassSelection() : picture_alone);
        CHECK(small.lab().renderer()->has_whole_picture());
        CHECK_FALSE(small.lab().is_moving());
        CHECK(small.has_all_light());
        CHECK(small.at(0) == 1.0f);
    }
    CHECK(small.frames() == frames);
}

TEST_CASE("specialised programs follow changes of shared targets") {
    GlowingLab small;
    REQUIRE(small.update_until([&] { return small.executor().programs().is_specialized(); }));
    small.display(picture_alone);
    CHECK_FALSE(small.executor().programs().is_specialized());
    CHECK(small.has_all_light());
    REQUIRE(small.update_until([&] { return small.executor().programs().is_specialized(); }));
    CHECK(small.is_shared());
    CHECK(small.has_all_light());
    small.lab().frames().passes().toggle(PassSwitch::freeze, "light");
    small.draw_frames(2);
    CHECK_FALSE(small.is_shared());
    CHECK(small.has_all_light());
    small.lab().frames().passes().toggle(PassSwitch::freeze, "light");
    small.draw_frames(2);
    CHECK(small.has_all_light());
    small.lab().frames().set_displayed({});
    small.draw_frames(3);
    CHECK(small.has_all_light());
}

TEST_CASE("the picture, inspected and probed passes are displayed, but not the strip's") {
    GlowingLab small;
    const Look& look = small.document().look();
    const auto seen = [&](const WindowState& window) {
        return displayed_passes(small.lab(), window).of(look);
    };
    const std::vector<bool> last{false, false, true};
    WindowState window;
    window.layout.panels.show(panel_id::strip);
    window.layout.panels.show(panel_id::inspector);
    CHECK(seen(window) == last);
    window.views.inspected.pass = "light";
    CHECK(seen(window) == std::vector<bool>{true, false, true});
    window.views.inspected.other = TextureChoice{Input::From::pass, "glow", 1};
    CHECK(seen(window) == std::vector<bool>{true, true, true});
    window.layout.panels.hide(panel_id::inspector);
    CHECK(seen(window) == last);
    window.views.shows_pass_large = true;
    CHECK(seen(window) == std::vector<bool>{true, true, true});
    window.views.shows_pass_large = false;
    window.layout.panels.show(panel_id::inspector);
    window.layout.is_picture_only = true;
    CHECK(seen(window) == last);
    window.probes.pointer = Probe{.pass = "glow"};
    CHECK(seen(window) == std::vector<bool>{false, true, true});
    window.probes.pointer.reset();
    small.lab().frames().passes().toggle(PassSwitch::solo, "light");
    CHECK(seen(window) == std::vector<bool>{true, false, true});
}
