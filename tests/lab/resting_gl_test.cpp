#include "gpu/counted_draws.h"
#include "lab/small_lab.h"

namespace {
constexpr const char* manifest = R"({
  "format": "afterglow-look", "version": 1, "name": "Small", "driven_by": "nothing", "settle_frames": 20,
  "passes": [
    { "name": "sum", "fragment": "sum.frag", "format": "rgba32f", "inputs": { "previous": "sum@1" } },
    { "name": "show", "fragment": "show.frag", "format": "rgba8", "inputs": { "image": "sum" } }
  ]
})";
constexpr const char* still = R"({
  "format": "afterglow-look", "version": 1, "name": "Small", "driven_by": "nothing",
  "passes": [
    { "name": "sum", "fragment": "show.frag", "format": "rgba32f", "accumulate": true, "converge": 4 },
    { "name": "show", "fragment": "show.frag", "format": "rgba8", "inputs": { "image": "sum" } }
  ]
})";

void rest(SmallLab& small) {
    REQUIRE(small.update_until(
        [&] { return !small.lab().is_moving() || small.lab().frames().has_converged(); }));
    small.update(2);
}

void turn_gain(SmallLab& small, double gain) {
    small.lab().edit([&](Document& document) { document.set_value("gain", Value(gain)); });
}
}  // namespace

TEST_CASE("a paused picture makes draw calls only after a change") {
    SmallLab small(manifest);
    small.lab().player().pause();
    rest(small);
    const CountedDraws draws;
    small.update(100);
    CHECK(CountedDraws::take() == 0);
    for (const double gain : {2.0, 3.0}) {
        turn_gain(small, gain);
        small.update(1);
        CHECK(CountedDraws::take() == 1);  // the last pass
        CHECK(small.lab().renderer()->executor().drawer().draw_calls() == 1);
        small.update(100);
        CHECK(CountedDraws::take() == 0);
    }
    turn_gain(small, 3.0);  // unchanged
    small.update(1);
    CHECK(CountedDraws::take() == 0);
    small.lab().player().play();
    small.update(3);
    CHECK(CountedDraws::take() >= 3 * 2);
}

TEST_CASE("a converged picture makes no draw calls while time continues") {
    SmallLab small(still);
    rest(small);
    CHECK(small.player().transport().is_playing());
    CHECK(small.lab().frames().has_converged());
    const CountedDraws draws;
    small.update(100);
    CHECK(CountedDraws::take() == 0);
    CHECK_FALSE(small.lab().is_moving());
}
