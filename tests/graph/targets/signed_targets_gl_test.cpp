// Signed integer targets, with every reader of a target.
#include "about.h"
#include "gpu/objects/draw.h"
#include "graph/inspect/meter.h"
#include "graph/inspect/point_reader.h"
#include "graph/inspect/texel_reader.h"
#include "graph/inspect/viewer.h"
#include "graph/looks.h"

#include <cmath>

namespace {
Stage signed_stage(const std::string& body) {
    return {"test.frag", "#version 410 core\nin vec2 uv;\nout ivec4 color;\n" + body, {}};
}

std::vector<FormatInfo> signed_formats() {
    std::vector<FormatInfo> found;
    for (const FormatInfo& info : all_formats())
        if (info.is_signed)
            found.push_back(info);
    return found;
}

// Two's complement; as a float the maximum of 32 bits is 2^31.
float min_of(const FormatInfo& info) {
    return -static_cast<float>(std::exp2(8 * info.bytes / info.channels - 1));
}
float max_of(const FormatInfo& info) {
    return static_cast<float>(std::exp2(8 * info.bytes / info.channels - 1) - 1);
}

// The channels of the format, then 0, 0, 1.
Rgba held(const FormatInfo& info, const Rgba& written) {
    Rgba numbers{0, 0, 0, 1};
    std::copy_n(written.begin(), info.channels, numbers.begin());
    return numbers;
}

/// Writes the format's minimum and maximum, -5 and 127, and reads them through an isampler2D.
struct Ends {
    explicit Ends(const FormatInfo& info)
        : written(held(info, {min_of(info), -5.0f, max_of(info), 127.0f})) {
        Look look = look_of({pass("ends", ""), pass("back",
                                                    "uniform isampler2D image;\nvoid main() { "
                                                    "color = vec4(texture(image, uv)); }\n",
                                                    {reads("image", "ends", 0, {})})});
        const int shift = 31 - 8 * info.bytes / info.channels + 1;
        look.passes[0].format = info.format;
        look.passes[0].fragment = signed_stage("void main() { color = ivec4((-2147483647 - 1) >> " +
                                               std::to_string(shift) + ", -5, 2147483647 >> " +
                                               std::to_string(shift) + ", 127); }\n");
        executor.emplace(executor_of(look));
        executor->draw(frame(1));
    }
    const gpu::Texture& target() const { return executor->target(0); }

    Rgba written;
    std::optional<Executor> executor;
};
}  // namespace

TEST_CASE_FIXTURE(Headless, "negative numbers are read back exactly, and by the next pass") {
    REQUIRE(signed_formats().size() == 9);
    for (const FormatInfo& info : signed_formats()) {
        CAPTURE(info.name);
        const Ends ends(info);
        CHECK(pixel(*ends.executor, 0) == ends.written);
        CHECK(pixel(*ends.executor, 1) == ends.written);
        const Picture picture = gpu::read_picture(ends.target());
        for (int channel = 0; channel < info.channels; ++channel)
            CHECK(picture.pixels[picture.index(3, 2) + static_cast<std::size_t>(channel)] ==
                  ends.written[static_cast<std::size_t>(channel)]);
    }
}

TEST_CASE_FIXTURE(Headless, "texel readers return negative numbers as written") {
    auto reader = TexelReader::make();
    auto gatherer = PointReader::make();
    REQUIRE((reader && gatherer));
    for (const FormatInfo& info : signed_formats()) {
        CAPTURE(info.name);
        const Ends ends(info);
        TexelReadback readback;
        readback.ask(*reader, ends.target(), {.count = {2, 1}, .first = {1, 1}});
        gatherer->start({{ends.target(), 2, 3}, {ends.executor->target(1), 0, 0}});
        gpu::finish();
        CHECK(readback.take() == std::vector<Rgba>(2, ends.written));
        CHECK(gatherer->take() == std::vector<Rgba>(2, ends.written));
    }
}

TEST_CASE_FIXTURE(Headless, "minimum and maximum of a signed target are measured") {
    auto programs = MeterPrograms::make();
    REQUIRE(programs.has_value());
    Meter meter(std::make_shared<const MeterPrograms>(std::move(*programs)));
    for (const FormatInfo& info : signed_formats()) {
        CAPTURE(info.name);
        const Ends ends(info);
        const auto measured = [&](Channels channels) {
            meter.start(ends.target(), channels, info.channels > 1 ? -5.0 : 0.0);
            gpu::finish();
            return meter.take().value();
        };
        CHECK(measured(Channels::red).statistics ==
              Statistics{min_of(info), min_of(info), min_of(info), 16, 0, 0});
        CHECK(measured(Channels::red).clipped == 0);
        if (info.channels == 4)
            CHECK(measured(Channels::color).statistics.maximum == max_of(info));
        if (info.channels > 1)
            CHECK(measured(Channels::green).clipped == 16);
    }
}

TEST_CASE_FIXTURE(Headless, "views show negative numbers between levels, and mark them") {
    auto viewer = Viewer::make();
    auto to = gpu::Canvas::make({4, 4}, Format::rgba8);
    auto from = gpu::Canvas::make({2, 2}, Format::rgba16i);
    REQUIRE((viewer && to && from));
    from->clear({-30, -25, 127, -29});
    const auto shown = [&](ViewOptions options) {
        options.encoding = Encoding::display;
        viewer->draw(from->texture(), *to, options);
        std::array<long, 3> bytes{};
        const Rgba rgba = gpu::read_pixel(to->texture(), 1, 2);
        std::transform(rgba.begin(), rgba.begin() + 3, bytes.begin(),
                       [](float number) { return std::lround(number * 255.0f); });
        return bytes;
    };
    using Bytes = std::array<long, 3>;
    CHECK(shown({}) == Bytes{0, 0, 255});
    CHECK(shown({.levels = {-30, -20}})[0] == 0);
    CHECK(shown({.levels = {-35, -10}}) == Bytes{51, 102, 255});
    CHECK(shown({.levels = {-30, -25}, .channels = Channels::alpha}) == Bytes{51, 51, 51});
    CHECK(shown({.channels = Channels::blue, .marks_flaws = true}) == Bytes{255, 255, 255});
    CHECK(shown({.channels = Channels::green, .marks_flaws = true}) == Bytes{0, 0, 255});
    const Bytes black =
        shown({.levels = {-25, 0}, .channels = Channels::red, .marks_clipping = true});
    CHECK(black[0] == 0);
    CHECK(black[1] == 64);  // 0.25 of 255
}

TEST_CASE_FIXTURE(Headless, "negative values in feedback are kept when another pass is edited") {
    Pass down = pass("down", "", {reads("previous", "down", 1)});
    down.format = Format::r8i;
    down.fragment = signed_stage(
        "uniform isampler2D previous;\n"
        "void main() { color = texelFetch(previous, ivec2(0), 0) - 3; }\n");
    const Look look = look_of({down, pass("other", "void main() { color = vec4(1); }\n")});
    Executor executor = executor_of(look);
    executor.draw(frame(1));
    executor.draw(frame(2));
    CHECK(red(executor, 0) == -6.0f);
    Look edited = look;
    edited.passes[1].fragment = fragment("void main() { color = vec4(2); }\n");
    REQUIRE(
        executor.replace(edited, programs_of(edited, &executor.programs().generic())).has_value());
    REQUIRE(executor.resize({4, 4}, {}).has_value());
    executor.draw(frame(3));
    CHECK(red(executor, 0) == -9.0f);
    CHECK(red(executor, 1) == 2.0f);
}

TEST_CASE_FIXTURE(Headless, "a sampler of the wrong type reads transparent black") {
    const auto read_as = [](const char* sampler, Format format, const char* type) {
        Look look = look_of({pass("whole", ""), pass("back",
                                                     std::string("uniform ") + sampler +
                                                         " image;\nvoid main() { color = "
                                                         "vec4(texture(image, uv)); }\n",
                                                     {reads("image", "whole", 0, {})})});
        look.passes[0].format = format;
        look.passes[0].fragment.text = std::string("#version 410 core\nout ") + type +
                                       " color;\nvoid main() { color = " + type + "(7); }\n";
        Executor executor = executor_of(look);
        executor.draw(frame(1));
        return red(executor, 1);
    };
    CHECK(read_as("isampler2D", Format::rgba8i, "ivec4") == 7.0f);
    CHECK(read_as("usampler2D", Format::rgba8i, "ivec4") == 0.0f);
    CHECK(read_as("sampler2D", Format::rgba8i, "ivec4") == 0.0f);
    CHECK(read_as("isampler2D", Format::rgba8ui, "uvec4") == 0.0f);
    CHECK(read_as("isampler2D", Format::rgba8, "vec4") == 0.0f);
}
