#include "graph/looks.h"

TEST_CASE_FIXTURE(Headless, "a counter holds n after n frames, and restarts when cleared") {
    Executor executor = executor_of(look_of({counter()}));
    for (int n = 1; n <= 5; ++n) {
        executor.draw(frame(n));
        CHECK(red(executor, 0) == static_cast<float>(n));
    }
    executor.clear_history();
    executor.draw(frame(6));
    CHECK(red(executor, 0) == 1.0f);
    executor.draw(frame(1));  // the first frame also clears
    CHECK(red(executor, 0) == 1.0f);
}

TEST_CASE_FIXTURE(Headless, "name@2 is the picture of two frames ago, or transparent black") {
    const Look look =
        look_of({pass("number", "uniform int u_frame;\nvoid main() { color = vec4(u_frame); }\n"),
                 pass("late", "uniform sampler2D old;\nvoid main() { color = texture(old, uv); }\n",
                      {reads("old", "number", 2)})});
    Executor executor = executor_of(look);
    const float expected[] = {0, 0, 1, 2, 3, 4};
    for (int n = 1; n <= 6; ++n) {
        executor.draw(frame(n));
        CHECK(pixel(executor, 1) ==
              Rgba{expected[n - 1], expected[n - 1], expected[n - 1], expected[n - 1]});
    }
}

TEST_CASE_FIXTURE(Headless, "a redraw uses new values without advancing history") {
    Pass show = pass("show",
                     "uniform sampler2D counted; uniform float gain;\n"
                     "void main() { color = texture(counted, uv) * gain; }\n",
                     {reads("counted", "counter")});
    Executor executor =
        executor_of(look_of({counter(), show}, {parameter_named("gain", {}, 1.0, {{1, "gain"}})}));
    for (int n = 1; n <= 3; ++n)
        executor.draw(frame(n));
    executor.set_values({{"gain", 10.0}});
    for (int i = 0; i < 4; ++i)
        executor.redraw(frame(3), {false, true});
    CHECK(red(executor, 1) == 30.0f);
    CHECK(executor.drawer().draw_calls() == 1);
    for (int i = 0; i < 4; ++i)
        executor.redraw(frame(3), {true, true});
    CHECK(red(executor, 0) == 3.0f);
    executor.draw(frame(4));
    CHECK(red(executor, 1) == 40.0f);
}

TEST_CASE_FIXTURE(Headless, "an edited look keeps the history of unchanged passes") {
    const Look before = look_of({counter()});
    Executor executor = executor_of(before);
    for (int n = 1; n <= 3; ++n)
        executor.draw(frame(n));

    Look after = look_of(
        {pass("new", "void main() { color = vec4(7); }\n"), counter(),
         pass("older", "uniform sampler2D old;\nvoid main() { color = texture(old, uv); }\n",
              {reads("old", "counter", 3)})});
    const Programs programs = programs_of(after, &executor.programs().generic());
    CHECK(programs.passes[1].program == executor.programs().generic().passes[0].program);
    REQUIRE(executor.replace(after, programs).has_value());
    executor.draw(frame(4));
    CHECK(red(executor, 0) == 7.0f);
    CHECK(red(executor, 1) == 4.0f);  // more slots, the newest ones kept
    CHECK(red(executor, 2) == 0.0f);  // its first frame was no longer in the two slots
    executor.draw(frame(5));
    CHECK(red(executor, 2) == 2.0f);
    executor.draw(frame(6));
    CHECK(red(executor, 2) == 3.0f);
}

TEST_CASE_FIXTURE(Headless, "a target with another format or size restarts, and others continue") {
    Look look = look_of({counter(), counter()});
    look.passes[1].name = "half";
    look.passes[1].inputs = {reads("previous", "half", 1)};
    Executor executor = executor_of(look);
    executor.draw(frame(1));
    executor.draw(frame(2));
    look.passes[1].format = Format::rgba16f;
    REQUIRE(executor.replace(look, programs_of(look, &executor.programs().generic())).has_value());
    executor.draw(frame(3));
    CHECK(red(executor, 0) == 3.0f);
    CHECK(red(executor, 1) == 1.0f);
    REQUIRE(executor.resize({4, 4}, {}).has_value());
    executor.draw(frame(4));
    CHECK(red(executor, 0) == 4.0f);
    REQUIRE(executor.resize({8, 4}, {}).has_value());
    executor.draw(frame(5));
    CHECK(red(executor, 0) == 1.0f);
}

TEST_CASE_FIXTURE(Headless, "the history of a pass is resampled on resize if the pass keeps it") {
    // The left half of the first picture is 0 and the right one 1; then it is constant.
    Look look = look_of({pass("kept",
                              "uniform sampler2D previous;\nuniform float drawn;\n"
                              "void main() { color = drawn > 0.5 ? vec4(step(0.5, uv.x)) "
                              ": texture(previous, uv); }\n",
                              {reads("previous", "kept", 1)})},
                        {parameter_named("drawn", {}, Value(1.0), {{0, "drawn"}})});
    look.passes[0].keeps_when_resized = true;
    Executor executor = executor_of(look);
    executor.draw(frame(1));
    executor.set_values({{"drawn", Value(0.0)}});
    REQUIRE(executor.resize({8, 2}, {}).has_value());
    executor.draw(frame(2));
    // Centres of eight columns among those of four: linear between the two middle ones.
    const std::vector<float> across{0.0f, 0.0f, 0.0f, 0.25f, 0.75f, 1.0f, 1.0f, 1.0f};
    const Picture wide = gpu::read_picture(executor.target(0));
    REQUIRE(wide.extent == Extent{8, 2});
    for (int x = 0; x < 8; ++x)
        CHECK(wide.pixels[wide.index(x, 1)] ==
              doctest::Approx(across[static_cast<std::size_t>(x)]).epsilon(1e-5));
    look.passes[0].format = Format::rgba16f;
    REQUIRE(executor.replace(look, programs_of(look, &executor.programs().generic())).has_value());
    executor.draw(frame(3));
    CHECK(gpu::read_picture(executor.target(0)).pixels.back() == 0.0f);
}

TEST_CASE_FIXTURE(Headless, "a pass that keeps its program reads the inputs of the edited look") {
    Look look = look_of(
        {pass("one", "void main() { color = vec4(1); }\n"),
         pass("two", "void main() { color = vec4(2); }\n"),
         pass("show", "uniform sampler2D image;\nvoid main() { color = texture(image, uv); }\n",
              {reads("image", "one")})});
    Executor executor = executor_of(look);
    executor.draw(frame(1));
    CHECK(red(executor, 2) == 1.0f);
    look.passes[2].inputs = {reads("image", "two")};
    const Programs programs = programs_of(look, &executor.programs().generic());
    REQUIRE(programs.passes[2].program == executor.programs().generic().passes[2].program);
    REQUIRE(executor.replace(look, programs).has_value());
    executor.draw(frame(2));
    CHECK(red(executor, 2) == 2.0f);
}

TEST_CASE_FIXTURE(Headless, "an undone edit draws with the values changed meanwhile") {
    Look look = look_of({pass("base", "uniform float gain;\nvoid main() { color = vec4(gain); }\n"),
                         pass("show",
                              "uniform float gain;\nuniform sampler2D image;\n"
                              "void main() { color = gain * texture(image, uv); }\n",
                              {reads("image", "base")})},
                        {parameter_named("gain", {}, 1.0, {{0, "gain"}, {1, "gain"}})});
    Executor executor = executor_of(look);
    executor.set_values({{"gain", 3.0}});
    executor.draw(frame(1));
    CHECK(red(executor, 1) == 3.0f * 3.0f);
    const Programs first = executor.programs().generic();
    Look edited = look;
    edited.passes[1].fragment = fragment(
        "uniform float gain;\nuniform sampler2D image;\n"
        "void main() { color = 2.0 * gain * texture(image, uv); }\n");
    REQUIRE(executor.replace(edited, programs_of(edited, &first)).has_value());
    executor.set_values({{"gain", 5.0}});
    executor.draw(frame(2));
    CHECK(red(executor, 1) == 2.0f * 5.0f * 5.0f);
    REQUIRE(executor.replace(look, programs_of(look, &first)).has_value());
    CHECK(executor.programs().generic().passes[1].program == first.passes[1].program);
    executor.draw(frame(3));
    CHECK(red(executor, 1) == 5.0f * 5.0f);
}

TEST_CASE_FIXTURE(Headless, "a look that cannot be loaded leaves the previous one active") {
    Executor executor = executor_of(look_of({counter()}));
    executor.draw(frame(1));
    Look large = look_of({counter()});
    large.passes[0].size.fill({Side::By::pixels, 1e6, {}});
    const auto replaced = executor.replace(large, programs_of(large));
    REQUIRE_FALSE(replaced.has_value());
    CHECK(replaced.error().front().file == "look.json");
    CHECK_FALSE(executor.resize({1000000, 4}, {}).has_value());
    executor.draw(frame(2));
    CHECK(red(executor, 0) == 2.0f);
}

TEST_CASE_FIXTURE(Headless, "a later pass read without @ gives its previous frame") {
    const Look look = look_of(
        {pass("early", "uniform sampler2D later;\nvoid main() { color = texture(later, uv); }\n",
              {reads("later", "number")}),
         pass("number", "uniform int u_frame;\nvoid main() { color = vec4(u_frame); }\n")});
    Executor executor = executor_of(look);
    for (int n = 1; n <= 3; ++n)
        executor.draw(frame(n));
    CHECK(red(executor, 0) == 2.0f);
}

TEST_CASE_FIXTURE(Headless, "a pass with feedback advances once per repetition") {
    Look look = look_of({counter()}, {parameter_named("rounds", {Scalar::integer}, 3.0, {})});
    look.passes[0].repeat = "rounds";
    Executor executor = executor_of(look);
    executor.draw(frame(1));
    CHECK(red(executor, 0) == 3.0f);
    CHECK(executor.drawer().draw_calls() == 3);
    executor.set_values({{"rounds", 10.0}});
    executor.draw(frame(2));
    CHECK(red(executor, 0) == 13.0f);
    executor.redraw(frame(2), {true});
    CHECK(red(executor, 0) == 13.0f);
    executor.set_values({{"rounds", -5.0}});
    executor.draw(frame(3));
    CHECK(red(executor, 0) == 14.0f);
}
