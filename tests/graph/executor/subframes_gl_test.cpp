// Sub-frames: what counts drawn frames, and what counts source frames.
#include "graph/looks.h"

namespace {
Frame subframe(int number, int count) {
    Frame made = frame(number);
    made.subframe = subframe_of(number, count);
    return made;
}

Picture flat(float red) {
    return {{1, 1}, 4, Encoding::linear, {red, 0.0f, 0.0f, 1.0f}};
}

Input of_source(const std::string& uniform, int frames_ago) {
    return {uniform, Input::From::source, "", frames_ago, {Filter::nearest, Wrap::edge, false}};
}
}  // namespace

TEST_CASE("sub-frames are counted within a source frame") {
    CHECK(subframe_of(1, 4) == Subframe{0, 4});
    CHECK(subframe_of(4, 4) == Subframe{3, 4});
    CHECK(subframe_of(5, 4) == Subframe{0, 4});
    CHECK(source_frame_of(4, 4) == 1);
    CHECK(source_frame_of(5, 4) == 2);
    Look look = look_of({pass("a", "")});
    look.subframes = 99;
    CHECK(subframes_of(look, {}) == max_subframes);
    look.subframes = std::string("count");
    CHECK(subframes_of(look, {}) == 1);  // no such parameter
}

TEST_CASE_FIXTURE(Headless, "shaders get the sub-frame and its number in the source frame") {
    Pass counting = pass("counting",
                         "uniform int u_subframe;\nuniform int u_subframes;\nuniform int u_frame;\n"
                         "uniform int count;\nvoid main() { color = vec4(u_subframe, u_subframes, "
                         "u_frame, count); }\n");
    counting.built_ins.push_back({"count", BuiltIn::source_frame_index});
    Executor executor = executor_of(look_of({counting}), {1, 1});
    for (int number = 1; number <= 7; ++number) {
        executor.draw(subframe(number, 3));
        const int whole_frames = (number - 1) / 3;
        const std::vector<float> expected{static_cast<float>((number - 1) % 3), 3.0f,
                                          static_cast<float>(number),
                                          static_cast<float>(whole_frames)};
        CHECK(gpu::read_picture(executor.target(0)).pixels == expected);
    }
}

TEST_CASE_FIXTURE(Headless, "source@1 is the previous source picture in all sub-frames") {
    Look look = look_of({pass("both",
                              "uniform sampler2D now;\nuniform sampler2D before;\nvoid main() { "
                              "color = vec4(texture(now, uv).r, texture(before, uv).r, 0, 1); }\n",
                              {of_source("now", 0), of_source("before", 1)})});
    Executor executor = executor_of(look, {1, 1}, {1, 1});
    for (int number = 1; number <= 8; ++number) {
        const auto picture = static_cast<float>(source_frame_of(number, 4));
        if (subframe_of(number, 4).is_first())
            REQUIRE(executor.set_source(flat(picture)));
        executor.draw(subframe(number, 4));
        const Picture drawn = gpu::read_picture(executor.target(0));
        CHECK(drawn.pixels[0] == picture);
        CHECK(drawn.pixels[1] == picture - 1.0f);
    }
}

TEST_CASE_FIXTURE(Headless, "a pass per source frame sees source frames as its frames") {
    Pass whole = pass("whole",
                      "uniform sampler2D before;\nuniform int u_subframes;\nuniform int u_frame;\n"
                      "uniform float u_time;\nuniform float u_time_delta;\nvoid main() { color = "
                      "vec4(texture(before, uv).r + 1, u_frame, u_time, u_time_delta); }\n",
                      {reads("before", "whole", 1)});
    whole.per_source_frame = true;
    whole.format = Format::rgba32f;
    const Pass reader = pass("reader",
                             "uniform sampler2D now;\nuniform sampler2D before;\nvoid main() { "
                             "color = vec4(texture(now, uv).r, texture(before, uv).r, 0, 1); }\n",
                             {reads("now", "whole"), reads("before", "whole", 1)});
    Executor executor = executor_of(look_of({whole, reader}), {1, 1});
    for (int number = 1; number <= 9; ++number) {
        executor.draw(subframe(number, 3));
        const auto source_frame = static_cast<float>(source_frame_of(number, 3));
        const Picture drawn = gpu::read_picture(executor.target(0));
        CHECK(drawn.pixels[0] == source_frame);  // its draws
        CHECK(drawn.pixels[1] == source_frame);
        CHECK(drawn.pixels[2] == doctest::Approx(source_frame * 3.0f / 60.0f));
        CHECK(drawn.pixels[3] == doctest::Approx(3.0f / 60.0f));
        const Picture read = gpu::read_picture(executor.target(1));
        CHECK(read.pixels[0] == source_frame);
        CHECK(read.pixels[1] == source_frame - 1.0f);
    }
    // From a fresh start in the middle of a source frame, it has a picture.
    executor.clear_history();
    executor.draw(subframe(11, 3));
    CHECK(red(executor, 1) == 1.0f);
}
