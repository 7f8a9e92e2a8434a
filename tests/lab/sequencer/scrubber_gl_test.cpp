#include "lab/sequencer/scrubber.h"
#include "lab/small_lab.h"

namespace {
/// A small look whose first pass keeps a part of the previous frame and adds a term of the time.
std::unique_ptr<SmallLab> afterglow_lab() {
    auto small = std::make_unique<SmallLab>();
    small->write("sum.frag", R"(#version 410 core
uniform sampler2D previous;
uniform float u_time;
uniform float step_size = 1.0;  // @range 0 4
in vec2 uv;
out vec4 color;
void main() {
    color = texture(previous, uv) * 0.993 + step_size * fract(u_time * vec4(7.3, 1.7, 3.1, 0.9) + uv.x);
}
)");
    small->lab().looks().open("small");
    REQUIRE(small->update_until([&] {
        return small->lab().renderer()->executor().look().passes[0].name == "sum" &&
               !small->lab().loader().is_loading() && small->frames() > 3.0f;
    }));
    small->player().pause();
    small->lab().frames().restart();
    REQUIRE(small->update_until([&] { return small->frames() == 1.0f; }));
    return small;
}

void step_frames(SmallLab& small, int count) {
    for (int i = 0; i < count; ++i) {
        const float before = small.frames();
        small.player().step();
        REQUIRE(small.update_until([&] { return small.frames() == before + 1.0f; }));
    }
}

void step_back(SmallLab& small) {
    small.lab().sequencer().scrubber().step_back();
    REQUIRE(small.update_until([&] {
        return small.lab().work().redraw.is_empty() &&
               !small.lab().renderer()->replay().is_running();
    }));
}

// The history pass and the picture, bit by bit.
std::vector<float> state_of(SmallLab& small) {
    std::vector<float> numbers;
    for (const int pass : {0, 1})
        for (const int x : {0, 3, 7}) {
            const auto pixel =
                gpu::read_pixel(small.lab().renderer()->executor().target(pass), x, 5);
            numbers.insert(numbers.end(), pixel.begin(), pixel.end());
        }
    return numbers;
}
}  // namespace

TEST_CASE("a step back restores the state of a forward run bit by bit") {
    const auto small = afterglow_lab();
    std::vector<std::vector<float>> states{state_of(*small)};
    for (int i = 0; i < 79; ++i) {  // four times the frames after which the look has settled
        step_frames(*small, 1);
        states.push_back(state_of(*small));
    }
    CHECK(states[78] != states[79]);
    for (const std::size_t frame : {78, 77, 76}) {
        step_back(*small);
        CHECK(small->frames() == static_cast<float>(frame + 1));
        CHECK(state_of(*small) == states[frame]);
    }
    step_frames(*small, 3);
    CHECK(state_of(*small) == states[79]);
}

TEST_CASE("before the first frame there is none") {
    const auto small = afterglow_lab();
    step_back(*small);
    CHECK(small->frames() == 1.0f);
    CHECK(small->lab().messages().notice()->text ==
          "This is the first frame since the restart or the last scrub.");
}

TEST_CASE("a cancelled step back shows the latest frames") {
    const auto small = afterglow_lab();
    step_frames(*small, 60);
    small->lab().sequencer().scrubber().step_back();
    small->lab().frames().cancel_replay();
    REQUIRE(small->update_until([&] {
        return small->lab().work().redraw.is_empty() &&
               !small->lab().renderer()->replay().is_running();
    }));
    CHECK(small->frames() == 60.0f);
}

TEST_CASE("a scrub draws a paused picture at its time, with the frames before it") {
    const auto small = afterglow_lab();
    small->lab().sequencer().scrubber().scrub(2.0);
    REQUIRE(small->update_until([&] {
        return !small->lab().sequencer().is_busy() && small->lab().work().redraw.is_empty() &&
               !small->lab().renderer()->replay().is_running();
    }));
    CHECK(small->player().transport().time() == doctest::Approx(2.0));
    CHECK(small->player().transport().past().size() == 20);  // settle_frames
    const auto scrubbed = state_of(*small);
    small->lab().sequencer().scrubber().scrub(3.0);
    small->lab().sequencer().scrubber().scrub(2.0);
    REQUIRE(small->update_until([&] { return !small->lab().sequencer().is_busy(); }));
    REQUIRE(small->update_until([&] {
        return small->lab().work().redraw.is_empty() &&
               !small->lab().renderer()->replay().is_running();
    }));
    CHECK(state_of(*small) == scrubbed);
}
