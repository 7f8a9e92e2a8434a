#include "graph/looks.h"

TEST_CASE_FIXTURE(
    Headless, "bytes per pixel count the writes of drawn passes and the reads of their programs") {
    const std::string reading =
        "uniform sampler2D a;\nuniform sampler2D b;\nvoid main() { color = texture(a, uv)";
    Look look =
        look_of({pass("first", "void main() { color = vec4(1.0); }\n"),
                 pass("unread", "void main() { color = vec4(1.0); }\n"),
                 pass("last", reading + "; }\n", {reads("a", "first"), reads("b", "unread")})});
    look.passes[0].format = Format::rgba16f;
    look.passes[0].size.fill({Side::By::viewport, 0.5, {}});
    Executor executor = executor_of(look, {8, 8});
    CHECK(bytes_per_pixel(executor) == 2 * 8.0 / 4 + 16 + 16);
    CHECK(read_dependencies_of(executor, {false, false, true}) ==
          std::vector<bool>{true, false, true});
    CHECK(read_dependencies_of(executor, {false, true, false}) ==
          std::vector<bool>{false, true, false});
    REQUIRE(executor.set_runs({PassRun::drawn, PassRun::left_out, PassRun::drawn}).has_value());
    CHECK(bytes_per_pixel(executor) == 2 * 8.0 / 4 + 16);
    executor.draw(frame(1));
    CHECK(executor.drawer().draw_calls() == 2);
}
