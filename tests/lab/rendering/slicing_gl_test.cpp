// Frames that are drawn in slices, and their state until they are complete.
#include "graph/looks.h"
#include "lab/rendering/renderer.h"

TEST_CASE("without a slice frames are whole; with one they are sliced until known as light") {
    Slicing slicing;
    CHECK_FALSE(slicing.is_due());
    slicing.set_slice(0.02);
    CHECK(slicing.is_due());
    CHECK_FALSE(slicing.is_heavy());
    slicing.note(0.029);
    CHECK_FALSE(slicing.is_due());
    slicing.forget();
    CHECK(slicing.is_due());
}

TEST_CASE("slicing starts above one and a half slices and ends below one") {
    Slicing slicing;
    slicing.set_slice(0.02);
    for (const auto& [seconds, is_heavy] :
         {std::pair{0.029, false}, {0.031, true}, {0.025, true}, {0.021, true}, {0.019, false}}) {
        slicing.note(seconds);
        CHECK(slicing.is_heavy() == is_heavy);
        CHECK(slicing.is_due() == is_heavy);
    }
}

TEST_CASE_FIXTURE(Headless, "a sliced first frame is not a picture until it is complete") {
    const Look look = look_of({counter()});
    Renderer renderer(Executor(look, programs_of(look)));
    REQUIRE(renderer.executors().picture().resize({8, 8}, {8, 8}).has_value());
    renderer.set_slice(1e-9);
    renderer.draw({1, {0.0, 1.0 / 60.0}}, {});
    CHECK(renderer.has_unfinished_frame());
    int slices = 1;
    while (!renderer.continue_frame()) {
        CHECK_FALSE(renderer.has_whole_picture());
        ++slices;
    }
    CHECK(slices >= 2);
    CHECK(renderer.has_whole_picture());
    CHECK_FALSE(renderer.has_unfinished_frame());
    CHECK(red(renderer.executor(), 0, 7, 7) == 1.0f);
    CHECK(renderer.continue_frame());  // nothing is left to draw
}

TEST_CASE_FIXTURE(Headless,
                  "a variant is drawn in the slices after the picture's, with its own values") {
    Look look = look_of({pass("show", "uniform float k;\nvoid main() { color = vec4(k); }\n")},
                        {parameter_named("k", {}, 1.0, {{0, "k"}})});
    Renderer renderer(Executor(look, programs_of(look)));
    REQUIRE(renderer.executors().picture().resize({8, 8}, {8, 8}).has_value());
    REQUIRE(renderer.executors().start_variant({{"k", 5.0}}).has_value());
    Player player;
    renderer.replay().start_variant(player,
                                    0);  // without a history, so both are drawn from here on
    renderer.set_slice(1e-9);
    renderer.draw({1, {0.0, 1.0 / 60.0}}, {});
    int slices = 1;
    while (!renderer.continue_frame())
        ++slices;
    CHECK(slices >= 4);
    REQUIRE(renderer.executors().variant());
    CHECK(red(renderer.executor(), 0, 7, 7) == 1.0f);
    CHECK(red(*renderer.executors().variant(), 0, 7, 7) == 5.0f);
}
