#include "graph/looks.h"

namespace {
const SamplerReport& sampler(const PassReport& report, const std::string& uniform) {
    for (const SamplerReport& found : report.samplers)
        if (found.uniform == uniform)
            return found;
    FAIL("no sampler " << uniform);
    return report.samplers.front();
}

std::vector<double> numbers(const PassReport& report, const std::string& name) {
    for (const BuiltInReport& found : report.built_ins)
        if (found.name == name)
            return found.numbers;
    return {};
}
}  // namespace

TEST_CASE_FIXTURE(Headless, "the report of a pass lists what each sampler reads and how") {
    Pass half = pass("half", "void main() { color = vec4(1.0); }\n");
    half.size[0].factor = half.size[1].factor = 0.5;
    half.format = Format::rgba16f;
    const Sampler repeated{Filter::linear, Wrap::repeat, true};
    const Pass last =
        pass("last",
             "uniform sampler2D a;\nuniform sampler2D b;\nuniform sampler2D c;\n"
             "uniform sampler2D d;\nvoid main() { color = texture(a, uv) + texture(b, uv) "
             "+ texture(c, uv) + texture(d, uv); }\n",
             {reads("a", "half", 0, repeated),
              reads("b", "last", 1),
              {"c", Input::From::source, "", 0, {Filter::nearest, Wrap::edge, false}}});
    Executor executor = executor_of(look_of({half, last}), {8, 4}, {2, 2});
    executor.draw(frame(1));

    const PassReport report = executor.drawer().report(1);
    CHECK(report.samplers.size() == 4);
    const SamplerReport& a = sampler(report, "a");
    CHECK(a.reads.value().label() == "half");
    CHECK(a.extent == Extent{4, 2});
    CHECK(a.format == Format::rgba16f);
    CHECK(a.sampler == repeated);
    CHECK(sampler(report, "b").reads.value().label() == "last@1");
    CHECK(sampler(report, "b").extent == Extent{8, 4});
    CHECK(sampler(report, "c").reads.value().label() == "source");
    CHECK(sampler(report, "c").extent.is_empty());  // no source is set
    CHECK_FALSE(sampler(report, "d").reads);        // without an input
}

TEST_CASE_FIXTURE(Headless, "the report of a pass lists its built-in uniforms with their values") {
    Pass shown = pass("shown",
                      "uniform float u_time;\nuniform int u_frame;\nuniform vec2 u_resolution;\n"
                      "uniform vec2 u_mouse;\nuniform vec2 u_output_resolution;\n"
                      "void main() { color = vec4(u_time, float(u_frame), u_resolution.x + "
                      "u_output_resolution.y, u_mouse.y); }\n");
    shown.size[0].factor = shown.size[1].factor = 0.5;
    shown.frame_modulo = 4;
    Executor executor = executor_of(look_of({shown}), {16, 8});
    Frame now = frame(6);
    now.mouse = {3.0, 5.0};
    executor.draw(now);

    const PassReport report = executor.drawer().report(0);
    CHECK(report.built_ins.size() == 5);
    CHECK(numbers(report, "u_time") == std::vector{now.time});
    CHECK(numbers(report, "u_frame") == std::vector{2.0});  // 6 modulo 4
    CHECK(numbers(report, "u_resolution") == std::vector{8.0, 4.0});
    CHECK(numbers(report, "u_output_resolution") == std::vector{16.0, 8.0});
    CHECK(numbers(report, "u_mouse") == std::vector{3.0, 5.0});
    CHECK(pixel(executor, 0, 0, 0) ==
          Rgba{static_cast<float>(now.time), 2.0f, 16.0f, 5.0f});  // 8 + 8
}

TEST_CASE_FIXTURE(Headless, "the report of an accumulating pass has its last sample") {
    Pass sum = pass("sum",
                    "uniform sampler2D before;\nuniform int u_samples;\n"
                    "void main() { color = texture(before, uv) + float(u_samples); }\n",
                    {reads("before", "sum", 1)});
    sum.accumulate = true;
    sum.repeat = 3;
    Executor executor = executor_of(look_of({sum}));
    executor.draw(frame(1));
    executor.draw(frame(2));
    CHECK(numbers(executor.drawer().report(0), "u_samples") == std::vector{5.0});  // the sixth
}
