#include "gpu/error_log.h"
#include "gpu/objects/draw.h"
#include "graph/looks.h"
#include "graph/warm_up/worker_warm_up.h"

namespace {
const std::string shade_text = "uniform float k = 1.0;\nvoid main() { color = vec4(k); }\n";

Look shading_look(std::vector<Pass> passes) {
    return look_of(std::move(passes), {parameter_named("k", {}, Value(1.0), {{0, "k"}})});
}
}  // namespace

TEST_CASE_FIXTURE(Headless, "warm-up does not affect a program in use") {
    const Look look = shading_look({pass("a", shade_text)});
    const Programs first = programs_of(look);
    Executor executor(look, first);
    REQUIRE(executor.resize({4, 4}, {}).has_value());
    executor.set_values({{"k", Value(3.0)}});
    executor.draw(frame(1));
    CHECK(red(executor, 0) == 3.0f);

    const Look edited =
        shading_look({pass("a", shade_text), pass("b", shade_text, {reads("image", "a")})});
    const Programs second = programs_of(edited, &first);
    gpu::ErrorLog errors;
    PassProgress progress;
    WorkerWarmUp::make().value().draw({edited, second, &first, {}, {1280, 720}}, progress);
    CHECK(errors.take().empty());
    executor.draw(frame(2));
    CHECK(red(executor, 0) == 3.0f);
}

TEST_CASE_FIXTURE(Headless, "every kind of pass can be warmed up, and draws the same afterwards") {
    Pass points = pass("points", "void main() { color = vec4(1.0); }\n");
    points.draw = Draw::points;
    points.vertex.file = "test.vert";
    points.vertex.text =
        "#version 410 core\nin vec2 position;\nvoid main() { gl_Position = vec4(position, 0, 1); "
        "}\n";
    points.blend = Blend::add;
    Pass sum = counter();
    sum.repeat = 3;
    const Look look = look_of({points, sum,
                               pass("show",
                                    "uniform sampler2D image;\nvoid main() { "
                                    "color = texture(image, uv); }\n",
                                    {reads("image", "counter")})});
    const Programs programs = programs_of(look);
    gpu::ErrorLog errors;
    PassProgress progress;
    WorkerWarmUp::make().value().draw({look, programs, nullptr, {}, {1024, 720}}, progress);
    CHECK(errors.take().empty());
    Executor executor(look, programs);
    REQUIRE(executor.resize({4, 4}, {}).has_value());
    executor.draw(frame(1));
    CHECK(red(executor, 2) == 3.0f);
    CHECK(red(executor, 0) == 0.0f);  // without a beam there is no light
}

TEST_CASE_FIXTURE(Headless, "a warmed-up program can be deleted while others are in use") {
    const auto helper = gpu::Context::shared_with(**context);
    REQUIRE(helper.has_value());
    const Look kept = shading_look({pass("kept", shade_text)});
    const Look gone = shading_look({pass("gone", "void main() { color = vec4(1.0); }\n")});
    const Look next = shading_look({pass("next", "void main() { color = vec4(2.0); }\n")});
    Executor stays(kept, programs_of(kept));
    REQUIRE(stays.resize({4, 4}, {}).has_value());
    const auto on_helper = [&](const auto& act) {
        gpu::finish();
        (*context)->release();
        (*helper)->make_current();
        act();
        (*helper)->release();
        (*context)->make_current();
    };

    std::optional<WorkerWarmUp> warm_up;
    PassProgress progress;
    std::optional<Programs> programs;
    on_helper([&] {
        warm_up.emplace(WorkerWarmUp::make().value());
        programs = programs_of(gone);
        warm_up->draw({gone, *programs, nullptr, {}, {64, 64}}, progress);
    });
    {
        Executor drawn(gone, *std::exchange(programs, std::nullopt));
        REQUIRE(drawn.resize({4, 4}, {}).has_value());
        drawn.draw(frame(1));
        stays.draw(frame(1));
    }
    const Programs late = programs_of(next);
    on_helper([&] { warm_up->draw({next, late, nullptr, {}, {64, 64}}, progress); });
    gpu::finish();
    stays.draw(frame(2));  // Mesa crashes here unless the helper also draws with its own programs
    stays.draw(frame(3));
    CHECK(red(stays, 0) == 1.0f);
    on_helper([&] { warm_up.reset(); });
}
