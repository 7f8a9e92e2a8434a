#include "gpu/error_log.h"
#include "graph/looks.h"
#include "graph/targets/image_texture.h"
#include "graph/warm_up/first_draws.h"
#include "graph/warm_up/worker_warm_up.h"

namespace {
Look three_passes() {
    return look_of({counter(), pass("b", "void main() { color = vec4(2.0); }\n"),
                    pass("c", "void main() { color = vec4(3.0); }\n")});
}
}  // namespace

TEST_CASE_FIXTURE(
    Headless,
    "each new program is drawn with once, under its pass's name, and known ones are skipped") {
    const Look look = three_passes();
    const Programs programs = programs_of(look);
    Programs known;
    known.passes = {programs.passes[1]};
    const auto idle = idle_program();
    REQUIRE(idle.has_value());
    FirstDraws draws({look, programs, &known, {}, {1280, 720}}, *idle);
    CHECK(draws.total() == 2);
    CHECK(draws.next_pass() == "counter");
    draws.draw_next();
    CHECK(draws.done() == 1);
    CHECK(draws.next_pass() == "c");
    draws.draw_next();
    CHECK(draws.is_done());
    CHECK(FirstDraws({look, programs, &programs, {}, {1280, 720}}, *idle).is_done());
}

TEST_CASE_FIXTURE(Headless, "an executor used for first draws continues as before a first frame") {
    const Look look = three_passes();
    const Programs programs = programs_of(look);
    FirstDraws draws({.look = look,
                      .programs = programs,
                      .images = {},
                      .viewport = {8, 8},
                      .size = FirstDrawsInput::Size::own},
                     {});
    PassProgress progress;
    draws.draw_all(progress);
    const std::unique_ptr<Executor> executor = draws.take_executor();
    REQUIRE(executor != nullptr);
    CHECK(executor->plan().targets[0].extent == Extent{8, 8});
    Frame frame;
    frame.number = 1;
    executor->draw(frame);
    CHECK(red(*executor, 0) == 1.0f);  // the counter starts with its first frame
}

TEST_CASE_FIXTURE(Headless, "cancelled first draws stop, and report their progress") {
    const Look look = three_passes();
    const Programs programs = programs_of(look);
    int begun = 0;
    PassProgress* shared = nullptr;
    PassProgress progress([&](const PassProgress::State& state) {
        ++begun;
        if (state.pass == "b")
            shared->cancel();
    });
    shared = &progress;
    WorkerWarmUp::make().value().draw({look, programs, nullptr, {}, {64, 64}}, progress);
    CHECK(begun == 2);
    CHECK(progress.state().done == 1);
    CHECK(progress.state().total == 3);
}

TEST_CASE_FIXTURE(Headless, "linking reports progress per pass, and can be cancelled") {
    const Look look = three_passes();
    PassProgress progress;
    REQUIRE(build_programs(look, nullptr, nullptr, &progress).has_value());
    CHECK(progress.state().step == PassProgress::Step::linking);
    CHECK(progress.state().total == 3);
    CHECK(progress.state().done == 2);
    progress.cancel();
    const auto none = build_programs(look, nullptr, nullptr, &progress);
    REQUIRE_FALSE(none.has_value());
    CHECK(to_string(none.error().front()) == "look.json: error: opening was cancelled");
}

TEST_CASE_FIXTURE(Headless, "an image texture made in advance is the same as one that is set") {
    Look look = look_of({pass("show",
                              "uniform sampler2D paper;\n"
                              "void main() { color = texture(paper, uv); }\n",
                              {{"paper", Input::From::image, "paper", 0, {}}})});
    look.images.push_back({"paper", "paper.png", {}, true});
    const Picture picture{{1, 2}, 1, Encoding::linear, {0.25f, 0.75f}};
    Executor executor(look, programs_of(look));
    REQUIRE(executor.resize({1, 2}, {}).has_value());
    const auto texture = image_texture(look, "paper", picture);
    REQUIRE(texture.has_value());
    executor.set_image("paper", *texture);
    executor.draw(frame(1));
    CHECK(gpu::read_pixel(executor.target(0), 0, 0)[0] == 0.25f);  // the top row
    CHECK(gpu::read_pixel(executor.target(0), 0, 1)[0] == 0.75f);
    CHECK_FALSE(image_texture(look, "paper", {}).has_value());
}
