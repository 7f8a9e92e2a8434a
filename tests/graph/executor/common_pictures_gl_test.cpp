// Passes that draw into shared pictures give the same result as passes with their own.
#include "graph/executor/nan_watch.h"
#include "graph/looks.h"

#include <cmath>
#include <limits>

namespace {
const char* const shift =
    "uniform sampler2D image; uniform int u_frame;\n"
    "void main() { color = texture(image, uv.yx * 0.75) + vec4(0.125 * u_frame, uv, 1.0); }\n";

// Mipmaps, discarded pixels, feedback of one and two frames, and a charge that only the next frame
// reads.
Look busy_look() {
    const Sampler levels{Filter::linear, Wrap::edge, true};
    Pass holes = pass("holes",
                      "uniform sampler2D image;\nvoid main() {\n    if (uv.x < 0.5) discard;\n"
                      "    color = texture(image, uv);\n}\n",
                      {reads("image", "d")});
    return look_of(
        {pass("a", "uniform int u_frame;\nvoid main() { color = vec4(u_frame, uv, 1); }\n"),
         pass("charge",
              "uniform sampler2D beam; uniform sampler2D before;\n"
              "void main() { color = 0.5 * texture(before, uv) + texture(beam, uv); }\n",
              {reads("beam", "a"), reads("before", "charge", 1)}),
         pass("b", shift, {reads("image", "a")}),
         pass("c", shift, {reads("image", "b", 0, levels)}),
         pass("d", shift, {reads("image", "c", 0, levels)}), holes,
         pass("glow",
              "uniform sampler2D now; uniform sampler2D before; uniform sampler2D older;\n"
              "uniform sampler2D held;\n"
              "void main() { color = texture(now, uv) + 0.5 * texture(before, uv) +\n"
              "              0.25 * texture(older, uv) + texture(held, uv); }\n",
              {reads("now", "holes"), reads("before", "glow", 1), reads("older", "glow", 2),
               reads("held", "charge", 1)}),
         pass("e", shift, {reads("image", "glow")}), pass("f", shift, {reads("image", "e")}),
         pass("show", shift, {reads("image", "f", 0, levels)})});
}

std::vector<bool> last_of(const Look& look) {
    std::vector<bool> displayed(look.passes.size(), false);
    displayed.back() = true;
    return displayed;
}

Executor drawing_once(const Look& look, Extent extent = {8, 8}) {
    Executor executor = executor_of(look, extent);
    REQUIRE(executor.set_displayed(last_of(look), Redraws::never).has_value());
    return executor;
}

std::vector<float> picture_of(const Executor& executor) {
    return gpu::read_picture(executor.target(static_cast<int>(executor.look().passes.size()) - 1))
        .pixels;
}
}  // namespace

TEST_CASE_FIXTURE(Headless, "shared pictures do not change the displayed picture") {
    const Look look = busy_look();
    Executor apart = executor_of(look, {8, 8});
    Executor common = drawing_once(look);
    // One picture serves the newest glow, then e, then the newest charge.
    CHECK(memory_of(apart.plan()) - memory_of(common.plan()) == 2 * 8 * 8 * 16);
    CHECK(draw_order(common.plan()).back() == 1);
    const std::vector<bool> carried = feedback_passes(look);
    for (int n = 1; n <= 12; ++n) {
        CAPTURE(n);
        const bool is_displayed = n % 3 != 2;
        apart.draw(frame(n), is_displayed ? nullptr : &carried);
        common.draw(frame(n), is_displayed ? nullptr : &carried);
        if (is_displayed)
            CHECK(picture_of(common) == picture_of(apart));
    }
    apart.draw(frame(1));  // from the first frame again
    common.draw(frame(1));
    CHECK(picture_of(common) == picture_of(apart));
}

TEST_CASE_FIXTURE(Headless, "history continues when sharing of pictures starts and ends") {
    const Look look = busy_look();
    Executor apart = executor_of(look, {8, 8});
    Executor turning = executor_of(look, {8, 8});
    for (int n = 1; n <= 9; ++n) {
        CAPTURE(n);
        const bool is_once = n % 3 != 0;
        REQUIRE(turning
                    .set_displayed(is_once ? last_of(look) : std::vector<bool>{},
                                   is_once ? Redraws::never : Redraws::possible)
                    .has_value());
        CHECK(turning.plan().common.empty() != is_once);
        apart.draw(frame(n));
        turning.draw(frame(n));
        CHECK(picture_of(turning) == picture_of(apart));
    }
    REQUIRE(turning.set_displayed(last_of(look), Redraws::never).has_value());
    REQUIRE(turning.replace(look, programs_of(look)).has_value());
    apart.draw(frame(10));
    turning.draw(frame(10));
    CHECK(picture_of(turning) == picture_of(apart));
}

TEST_CASE_FIXTURE(Headless, "drawing in bands gives the same result with shared pictures") {
    const Look look = busy_look();
    Executor apart = executor_of(look, {8, 8});
    Executor common = drawing_once(look);
    for (int n = 1; n <= 4; ++n) {
        apart.draw(frame(n));
        common.draw(frame(n), nullptr, Slices::in_place);
        while (!common.drawer().continue_frame(1e-9)) {
        }
        CHECK(picture_of(common) == picture_of(apart));
    }
}

TEST_CASE_FIXTURE(Headless,
                  "the pass that wrote a non-finite value is found despite shared pictures") {
    Look look = busy_look();
    look.passes[5].fragment = fragment(
        "uniform sampler2D image; uniform int u_frame;\n"
        "void main() { color = u_frame == 3 ? vec4(1.0 / 0.0) : texture(image, uv); }\n");
    Executor common = drawing_once(look);
    const auto nan_watch = std::make_shared<NanWatch>();
    REQUIRE(nan_watch->set_policy(NanPolicy::clamp, common).has_value());
    const std::vector<bool> carried = feedback_passes(look);
    for (int n = 1; n <= 3; ++n)
        common.draw(frame(n), &carried);
    const auto trip = nan_watch->take(common, true);
    REQUIRE(trip.has_value());
    CHECK(trip->pass == 5);
    CHECK(trip->frame == 3);
    common.draw(frame(4));
    for (const float number : picture_of(common))
        CHECK(std::abs(number) <= std::numeric_limits<float>::max());
}

TEST_CASE_FIXTURE(Headless, "unread inputs and left-out passes need no memory") {
    Look look = look_of(
        {pass("spare", "void main() { color = vec4(3.0); }\n"),
         pass("a", "uniform int u_frame;\nvoid main() { color = vec4(u_frame); }\n",
              {reads("unread", "spare"), reads("before", "a", 1)}),
         pass("show", "uniform sampler2D image;\nvoid main() { color = texture(image, uv); }\n",
              {reads("image", "a")})});
    Executor executor = drawing_once(look, {4, 4});
    CHECK(executor.plan().targets[1].slots == 1);
    REQUIRE(executor.set_runs({PassRun::left_out, PassRun::drawn, PassRun::drawn}).has_value());
    CHECK(memory_of(executor.plan()) == (2 * 4 * 4 + 1) * 16);
    executor.draw(frame(1));
    executor.draw(frame(2));
    CHECK(red(executor, 2) == 2.0f);
    Look reading = look;  // after this edit the pass reads it
    reading.passes[1].fragment = fragment(
        "uniform sampler2D before; uniform sampler2D unread;\n"
        "void main() { color = texture(before, uv) + texture(unread, uv) + 1.0; }\n");
    REQUIRE(executor.set_runs({}).has_value());
    REQUIRE(executor.replace(reading, programs_of(reading)).has_value());
    executor.draw(frame(3));
    executor.draw(frame(4));
    CHECK(red(executor, 2) == 2 * 4.0f);  // an unread history starts at 0
}
