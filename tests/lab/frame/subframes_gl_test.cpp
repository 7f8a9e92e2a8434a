// Sub-frames and HDR in the window: what the user allows and the display can show.
#include "lab/lab_parts.h"
#include "lab/small_lab.h"
#include "lab/views/flicker.h"
#include "lab/window/window_state.h"

#include <array>
#include <string>
#include <utility>

namespace {
const std::string four = replaced(small_look::manifest, "\"settle_frames\": 20,",
                                  "\"settle_frames\": 20, \"subframes\": 4,");
constexpr const char* telling = R"(#version 410 core
uniform int u_subframe;
uniform int u_subframes;
uniform float u_peak;
uniform sampler2D image;
in vec2 uv;
out vec4 color;
void main() { color = vec4(u_subframe, u_subframes, u_peak, 3.5) + 0.0 * texture(image, uv); }
)";

struct FlickeringLab : SmallLab {
    FlickeringLab() : SmallLab(four) {
        write_by_rename("show.frag", telling);
        REQUIRE(update_until([&] { return pixel()[3] == 3.5f; }));
    }
    std::array<float, 4> pixel() {
        return gpu::read_pixel(lab().renderer()->executor().target(1), 3, 3);
    }
    /// A display that has refreshed for two seconds.
    void refresh(double rate) {
        for (int i = 0; i < static_cast<int>(2.0 * rate); ++i)
            lab().work().display.add(1.0 / rate, rate, true);
    }
    void answer(std::size_t button) {
        REQUIRE(lab().messages().notice());
        const Edit command = lab().messages().notice()->buttons[button].commands.front();
        command(mutable_parts(lab(), &window));
        lab().messages().dismiss();
    }
    WindowState window;
};
}  // namespace

TEST_CASE("the window asks before the display flickers, once") {
    FlickeringLab small;
    small.lab().messages().dismiss();
    small.refresh(60.0);
    follow_flicker(small.lab().work(), small.window.flashes);
    CHECK_FALSE(small.lab().messages().notice());  // a slow display shows the steady picture
    small.refresh(240.0);
    follow_flicker(small.lab().work(), small.window.flashes);
    REQUIRE(small.lab().messages().notice());
    CHECK(small.lab().messages().notice()->text.find("photosensitive epilepsy") !=
          std::string::npos);
    CHECK_FALSE(small.lab().work().draws_subframes);
    small.answer(1);
    CHECK(small.window.flashes.flicker == Flicker::refused);
    follow_flicker(small.lab().work(), small.window.flashes);
    CHECK_FALSE(small.lab().messages().notice());
    CHECK_FALSE(small.lab().work().draws_subframes);
    small.window.flashes.flicker = Flicker::allowed;
    follow_flicker(small.lab().work(), small.window.flashes);
    CHECK(small.lab().work().draws_subframes);
    small.window.flashes.limit.is_on = true;  // the flash limiter wins
    follow_flicker(small.lab().work(), small.window.flashes);
    CHECK_FALSE(small.lab().work().draws_subframes);
}

TEST_CASE("the window draws as many sub-frames as the display can show, and none while paused") {
    FlickeringLab small;
    CHECK(small.pixel()[1] == 1.0f);
    small.lab().work().draws_subframes = true;
    for (const auto& [rate, count] : {std::pair{120.0, 2.0f}, {240.0, 4.0f}, {360.0, 4.0f}}) {
        small.refresh(rate);
        small.update(4);  // the source frame that has begun ends first
        CHECK(small.pixel()[1] == count);
        const float first = small.pixel()[0];
        small.update(1);
        CHECK(small.pixel()[0] ==
              static_cast<float>((static_cast<int>(first) + 1) % static_cast<int>(count)));
    }
    small.player().pause();
    small.update(2);
    CHECK(small.pixel()[1] == 1.0f);
    CHECK(small.pixel()[0] == 0.0f);
}

TEST_CASE("an HDR preview tells the look the peak, and keeps light above white") {
    FlickeringLab small;
    CHECK(small.pixel()[2] == 1.0f);
    small.lab().work().hdr = HdrLight{200.0, 1000.0};
    small.update(2);
    CHECK(small.pixel()[2] == 5.0f);
    small.lab().work().hdr = HdrLight{100.0, 1000.0};
    small.player().pause();
    CHECK(small.update_until([&] { return small.pixel()[2] == 10.0f; }));
    small.lab().work().hdr.reset();
    CHECK(small.update_until([&] { return small.pixel()[2] == 1.0f; }));
}

TEST_CASE("an HDR preview stores floats instead of 8 bits") {
    SmallLab small(replaced(small_look::manifest, "\"show.frag\", \"format\": \"rgba32f\"",
                            "\"show.frag\", \"format\": \"rgba8\""));
    const auto format = [&] { return small.lab().renderer()->executor().target(1).format(); };
    CHECK(format() == Format::rgba8);
    small.lab().work().hdr = HdrLight{};
    small.update(2);
    CHECK(format() == Format::rgba16f);
    small.lab().work().hdr.reset();
    small.update(2);
    CHECK(format() == Format::rgba8);
}
