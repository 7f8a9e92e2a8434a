#include "graph/executor/allocations.h"
#include "graph/looks.h"

TEST_CASE_FIXTURE(Headless, "a frame allocates no memory after the first frames") {
    Pass beam = pass("beam", "");
    beam.draw = Draw::segments;
    beam.blend = Blend::add;
    beam.vertex = {"beam.vert",
                   "#version 410 core\nin vec4 segment;\n"
                   "void main() { gl_Position = vec4(segment.xy, 0, 1); }\n",
                   {}};
    beam.fragment.text = "#version 410 core\nout vec4 color;\nvoid main() { color = vec4(1); }\n";
    Pass show = pass("show",
                     "uniform sampler2D lut; uniform sampler2D past; uniform float u_time;\n"
                     "void main() { color = texture(lut, uv) + texture(past, uv) * u_time; }\n",
                     {{"lut", Input::From::image, "a picture with a rather long name", 0, {}},
                      reads("past", "counter", 1)});
    show.repeat = "a_parameter_with_a_long_name";
    Executor executor = executor_of(look_of(
        {beam, counter(), show}, {parameter_named("a_parameter_with_a_long_name", {}, 2.0, {})}));
    const Beam points(1000, BeamPoint{0.5f, 0.5f, 1.0f, 0.0f});
    for (int n = 1; n <= 20; ++n) {
        Frame now = frame(n);
        now.beam = points;
        count_allocations(n > 10);
        executor.draw(now);
        executor.redraw(now, {});
        count_allocations(false);
    }
    CHECK(allocations() == 0);

    count_allocations(true);
    executor.set_values({});
    const std::vector<double> times = executor.drawer().pass_milliseconds();
    count_allocations(false);
    CHECK(allocations() > 0);  // the counter works
}
