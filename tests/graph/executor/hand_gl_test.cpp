#include "graph/looks.h"

namespace {
Pass told(const std::string& body, BuiltIn kind) {
    Pass made = pass("told", "uniform vec4 said;\nvoid main() { color = " + body + "; }\n");
    made.built_ins = {{"said", kind}};
    return made;
}
}  // namespace

TEST_CASE_FIXTURE(Headless, "a pass reads the position of the mouse press") {
    Executor executor = executor_of(look_of({told("said", BuiltIn::press)}));
    Frame now = frame(1);
    now.press = {{7, 9}, {3, 4}, true, false};
    executor.draw(now);
    CHECK(pixel(executor, 0) == Rgba{7, 9, 3, -4});
}

TEST_CASE_FIXTURE(Headless, "the keyboard texture has three rows of keys: down, pressed, toggled") {
    Pass reader = pass("reader",
                       "uniform sampler2D keys;\nvoid main() { color = vec4("
                       "texelFetch(keys, ivec2(65, 0), 0).r, texelFetch(keys, ivec2(65, 1), 0).r, "
                       "texelFetch(keys, ivec2(65, 2), 0).r, textureSize(keys, 0).x); }\n",
                       {{"keys", Input::From::keyboard, "keyboard", 0, {Filter::nearest}}});
    Executor executor = executor_of(look_of({reader}));
    executor.draw(frame(1));
    CHECK(pixel(executor, 0) == Rgba{0, 0, 0, 256});
    Frame now = frame(2);
    now.keys.down.set(65);
    now.keys.toggled.set(65);
    executor.draw(now);
    CHECK(pixel(executor, 0) == Rgba{1, 0, 1, 256});
}

TEST_CASE_FIXTURE(Headless, "start time and frame rate refer to the start of the frame") {
    Pass clock = pass(
        "clock", "uniform float start, rate;\nvoid main() { color = vec4(start, rate, 0, 1); }\n");
    clock.built_ins = {{"start", BuiltIn::time_before}, {"rate", BuiltIn::frame_rate}};
    Executor executor = executor_of(look_of({clock}));
    executor.draw(frame(1));
    CHECK(pixel(executor, 0)[0] == 0.0f);
    CHECK(pixel(executor, 0)[1] == doctest::Approx(60.0));
    executor.draw(frame(31));
    CHECK(pixel(executor, 0)[0] == doctest::Approx(0.5));
}
