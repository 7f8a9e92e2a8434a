#include "graph/looks.h"

#include <thread>

TEST_CASE_FIXTURE(Headless, "a driver error is reported in the author's file and line") {
    Look look = look_of({counter(), pass("bad", "void main() { color = vec4(oops); }\n")});
    Stage& bad = look.passes[1].fragment;
    bad.lines = with_line(bad.lines, 3, {"include/light.glsl", 88});
    const auto programs = build_programs(look);
    REQUIRE_FALSE(programs.has_value());
    CHECK(programs.error().front().file == "include/light.glsl");
    CHECK(programs.error().front().line == 88);
}

TEST_CASE_FIXTURE(Headless, "errors of all passes are reported at once") {
    const auto programs = build_programs(look_of({pass("a", "void main() { color = first; }\n"),
                                                  pass("b", "void main() { color = second; }\n")}));
    REQUIRE_FALSE(programs.has_value());
    const std::string all = to_string(programs.error());
    CHECK(all.find("first") != std::string::npos);
    CHECK(all.find("second") != std::string::npos);
}

TEST_CASE_FIXTURE(Headless, "a pass must not read its own target, and a look needs a pass") {
    Look look = look_of({counter()});
    look.passes[0].inputs[0].frames_ago = 0;
    const auto programs = build_programs(look);
    REQUIRE_FALSE(programs.has_value());
    CHECK(to_string(programs.error().front())
              .starts_with("look.json:5: error: pass 'counter' can't read its own output"));
    const auto none = build_programs(look_of({}));
    REQUIRE_FALSE(none.has_value());
    CHECK(to_string(none.error().front()) == "look.json: error: the look has no passes");
}

TEST_CASE_FIXTURE(Headless, "programs are reused by text, each once, for any order and names") {
    const std::string body = "uniform float k;\nvoid main() { color = vec4(k); }\n";
    const Look look = look_of({pass("a", body), pass("b", body), counter()});
    const Programs first = programs_of(look);
    CHECK(first.passes[0].program != first.passes[1].program);

    Look edited = look_of({counter(), pass("c", body), pass("d", body), pass("e", body)});
    Stage& moved = edited.passes[1].fragment;  // an edit above it changes only its lines
    moved.lines = with_line(moved.lines, 3, {"test.frag", 99});
    const Programs second = programs_of(edited, &first);
    CHECK(second.passes[0].program == first.passes[2].program);
    CHECK(second.passes[1].program == first.passes[0].program);
    CHECK(second.passes[2].program == first.passes[1].program);
    CHECK(second.passes[3].program != first.passes[0].program);

    edited.passes[1].set = {{"k", 2.0}};
    CHECK(programs_of(edited, &second).passes[1].program != second.passes[1].program);
}

TEST_CASE_FIXTURE(Headless, "programs built on a worker thread draw in the first context") {
    const Look look = look_of({counter()});
    auto helper = gpu::Context::shared_with(**context);
    REQUIRE(helper.has_value());
    Result<Programs> programs = fail({{}, 0, "not made"});
    std::thread([&] {
        (*helper)->make_current();
        programs = build_programs(look);
        (*helper)->release();
    }).join();
    REQUIRE(programs.has_value());
    Executor executor(look, *programs);
    REQUIRE(executor.resize({2, 2}, {}).has_value());
    executor.draw(frame(1));
    executor.draw(frame(2));
    CHECK(red(executor, 0) == 2.0f);
}

TEST_CASE_FIXTURE(Headless, "an executor draws and is destroyed in the context of its programs") {
    auto look_context = gpu::Context::shared_with(**context);
    REQUIRE(look_context.has_value());
    const Look look = look_of({counter()});
    Programs programs = programs_of(look);
    programs.context = std::move(*look_context);
    // Framebuffer names count from 1 in each context. One of these would be deleted with the
    // executor's in the wrong context.
    std::vector<gpu::Canvas> ours;
    for (int i = 0; i < 4; ++i)
        ours.push_back(gpu::Canvas::make({1, 1}, Format::r32f).value());
    {
        Executor executor(look, programs);
        REQUIRE(executor.resize({4, 4}, {}).has_value());
        executor.draw(frame(1));
        executor.draw(frame(2));
        CHECK(red(executor, 0) == 2.0f);
        CHECK(gpu::Context::current() == context->get());
    }
    for (const gpu::Canvas& canvas : ours) {
        canvas.clear({0.5f});
        CHECK(gpu::read_pixel(canvas.texture(), 0, 0)[0] == 0.5f);
    }
}
