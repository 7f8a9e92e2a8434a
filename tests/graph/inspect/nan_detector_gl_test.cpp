#include "graph/executor/nan_watch.h"
#include "graph/looks.h"

#include <cmath>
#include <limits>

namespace {
/// A texel of a fading pass becomes non-finite in frame `frame`; the next pass adds 0.5.
Look going_wrong(const std::string& number, const std::string& frame) {
    const std::string glow =
        "uniform sampler2D previous;\n"
        "uniform int u_frame;\n"
        "uniform vec2 u_resolution;\n"
        "uniform float none = 0.0;\n"
        "void main() {\n"
        "    bool is_bad = u_frame == " +
        frame +
        " && ivec2(gl_FragCoord.xy) == ivec2(37, 5);\n"
        "    color = is_bad ? vec4(1.0, " +
        number +
        ", 1.0, 1.0) : texture(previous, uv) * 0.5 + 1.0;\n"
        "}\n";
    return look_of({pass("glow", glow, {reads("previous", "glow", 1)}),
                    pass("shown",
                         "uniform sampler2D image;\n"
                         "void main() { color = texture(image, uv) + 0.5; }\n",
                         {reads("image", "glow")})});
}

struct DetectingHeadless : Headless {
    std::unique_ptr<Executor> executor;
    std::shared_ptr<NanWatch> nan_watch = std::make_shared<NanWatch>();

    void open(const Look& look, NanPolicy guard) {
        auto programs = build_programs(look);
        REQUIRE(programs.has_value());
        executor = std::make_unique<Executor>(look, std::move(*programs));
        REQUIRE(executor->resize({70, 40}, {70, 40}).has_value());
        nan_watch = std::make_shared<NanWatch>();
        set_policy(guard);
    }
    void set_policy(NanPolicy policy) {
        REQUIRE(nan_watch->set_policy(policy, *executor).has_value());
    }
    auto found(bool waits = true) { return nan_watch->take(*executor, waits); }
    void draw(int from, int to) {
        for (int number = from; number <= to; ++number) {
            Frame frame;
            frame.time = number / 60.0;
            frame.time_delta = 1.0 / 60.0;
            frame.number = number;
            executor->draw(frame);
        }
    }
    float green(int pass) { return gpu::read_pixel(executor->target(pass), 37, 34)[1]; }
};

const std::string nan = "none / none";
const std::string endless = "1.0 / none";
}  // namespace

TEST_CASE_FIXTURE(DetectingHeadless,
                  "the first non-finite value is found with pass, pixel and frame") {
    for (const std::string& number : {nan, endless, "-" + endless}) {
        open(going_wrong(number, "3"), NanPolicy::watch);
        draw(1, 2);
        CHECK_FALSE(found());
        draw(3, 9);  // later non-finite values that follow from it are not reported
        const auto trip = found();
        REQUIRE(trip);
        CHECK(*trip == NonFinitePixel{0, 37, 40 - 1 - 5, 3});
        CHECK_FALSE(std::isfinite(green(0)));
    }
}

TEST_CASE_FIXTURE(DetectingHeadless, "without waiting, the result is available some frames later") {
    open(going_wrong(nan, "2"), NanPolicy::watch);
    std::optional<NonFinitePixel> trip;
    for (int frame = 1; frame < 100 && !trip; ++frame) {
        draw(frame, frame);
        trip = found(false);
    }
    REQUIRE(trip);
    CHECK(trip->frame == 2);
}

TEST_CASE_FIXTURE(
    DetectingHeadless,
    "with clamping, a non-finite value is replaced before it is read, and still reported") {
    open(going_wrong(nan, "3"), NanPolicy::clamp);
    draw(1, 3);
    CHECK(green(0) == 0.0f);
    CHECK(green(1) == 0.5f);
    draw(4, 4);
    CHECK(green(0) == 1.0f);
    const auto trip = found();
    REQUIRE(trip);
    CHECK(*trip == NonFinitePixel{0, 37, 34, 3});
    CHECK_FALSE(found());
    open(going_wrong(endless, "3"), NanPolicy::clamp);
    draw(1, 3);
    CHECK(green(0) == std::numeric_limits<float>::max());
}

TEST_CASE_FIXTURE(DetectingHeadless, "in many large passes, the right pass and pixel are found") {
    std::vector<Pass> passes;
    for (int i = 0; i < 12; ++i) {
        const std::string own = std::to_string(i);
        const std::string wrong = i == 10 ? "1234, 321" : i == 11 ? "7, 7" : "-1, 0";
        passes.push_back(pass("p" + own,
                              "uniform sampler2D previous;\n"
                              "uniform float none = 0.0;\n"
                              "void main() {\n"
                              "    color = ivec2(gl_FragCoord.xy) == ivec2(" +
                                  wrong + ") ? vec4(none / none) : vec4(0.5);\n}\n",
                              {reads("previous", "p" + own, 1)}));
    }
    auto programs = build_programs(look_of(passes));
    REQUIRE(programs.has_value());
    executor = std::make_unique<Executor>(look_of(passes), std::move(*programs));
    REQUIRE(executor->resize({1600, 900}, {1600, 900}).has_value());
    set_policy(NanPolicy::watch);
    draw(1, 1);
    const auto trip = found();
    REQUIRE(trip);
    CHECK(*trip == NonFinitePixel{10, 1234, 900 - 1 - 321, 1});
}

TEST_CASE_FIXTURE(Headless,
                  "replacing values in place and through a second picture are equivalent") {
    const float none = std::numeric_limits<float>::quiet_NaN();
    const float endless_light = std::numeric_limits<float>::infinity();
    auto programs = build_nan_detector();
    REQUIRE(programs.has_value());
    const auto sanitized = [&](NanDetector::SanitizeMethod way, Format format,
                               const auto& numbers) {
        auto target = gpu::Canvas::make({5, 3}, format);
        REQUIRE(target.has_value());
        target->clear(numbers);
        NanDetector nan_detector(*programs, way);
        nan_detector.sanitize(*target);
        return gpu::read_pixel(target->texture(), 4, 1);
    };
    CHECK(NanDetector::best_method() ==
          NanDetector::SanitizeMethod::in_place);  // with the driver of the tests
    for (const auto way :
         {NanDetector::SanitizeMethod::in_place, NanDetector::SanitizeMethod::ping_pong}) {
        const std::array wrong{none, endless_light, -endless_light, 0.25f};
        const float maximum = std::numeric_limits<float>::max();
        CHECK(sanitized(way, Format::rgba32f, wrong) == std::array{0.0f, maximum, -maximum, 0.25f});
        constexpr float max_half = 65504.0f;
        CHECK(sanitized(way, Format::rgba16f, wrong) ==
              std::array{0.0f, max_half, -max_half, 0.25f});
    }
}

TEST_CASE_FIXTURE(DetectingHeadless, "a pass that no later pass reads is checked in its turn") {
    const Look look = look_of({pass("one", "void main() { color = vec4(1.0); }\n"),
                               pass("bad",
                                    "uniform float none = 0.0;\n"
                                    "void main() { color = vec4(none / none); }\n")});
    open(look, NanPolicy::watch);
    draw(1, 4);
    const auto trip = found();
    REQUIRE(trip);
    CHECK(trip->pass == 1);
    CHECK(trip->frame <= 2);
}

TEST_CASE_FIXTURE(DetectingHeadless,
                  "history can be sanitised afterwards, and with the detector off values stay") {
    open(going_wrong(nan, "2"), NanPolicy::off);
    draw(1, 3);
    CHECK(std::isnan(green(0)));
    CHECK_FALSE(found());
    set_policy(NanPolicy::clamp);
    nan_watch->sanitize(*executor);
    CHECK(green(0) == 0.0f);
    draw(4, 4);
    CHECK(green(0) == 1.0f);
    CHECK_FALSE(found());
}

TEST_CASE_FIXTURE(DetectingHeadless, "frame numbers restart with the history") {
    open(going_wrong(nan, "3"), NanPolicy::watch);
    draw(1, 2);
    executor->clear_history();
    draw(1, 5);
    const auto trip = found();
    REQUIRE(trip);
    CHECK(trip->frame == 3);
}

TEST_CASE_FIXTURE(
    DetectingHeadless,
    "in hidden frames history is clamped, and the first non-finite pass is reported") {
    const Look look =
        look_of({pass("calm", "void main() { color = vec4(1.0); }\n"),
                 pass("spark",
                      "uniform int u_frame;\n"
                      "uniform float none = 0.0;\n"
                      "void main() {\n"
                      "    color = vec4(u_frame == 3 && int(gl_FragCoord.x) == 37 && "
                      "int(gl_FragCoord.y) == 5 ? 1.0 / none : 1.0);\n"
                      "}\n"),
                 pass("sum",
                      "uniform sampler2D fresh, before;\n"
                      "void main() { color = texture(fresh, uv) - texture(before, uv); }\n",
                      {reads("fresh", "spark"), reads("before", "sum", 1)})});
    open(look, NanPolicy::clamp);
    const std::vector<bool> carried{false, true, true};
    for (int number = 1; number <= 5; ++number) {
        Frame frame;
        frame.number = number;
        executor->draw(frame, &carried);
    }
    CHECK(std::isfinite(green(2)));
    const auto trip = found();
    REQUIRE(trip);
    CHECK(*trip == NonFinitePixel{1, 37, 34, 3});
}
