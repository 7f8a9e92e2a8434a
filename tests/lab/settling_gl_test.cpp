// While values rest the picture is drawn by programs that hold them as constants; nobody sees it.
#include "lab/small_lab.h"
#include "model/modulation.h"

#include <cmath>

namespace {
/// Its picture is the number of frames, times what `gain` is.
class SettlingLab : public SmallLab {
public:
    bool is_settled() { return lab().renderer()->executor().is_settled(); }
    bool settles() {
        return turn_until([&] { return is_settled(); });
    }
    void set(const char* name, double value) {
        lab().edit([&](Document& document) {
            document.set_value(name, Value(value));
            document.finish();
        });
    }
};
}  // namespace

TEST_CASE("values that rest become constants, and a turn is seen in its own frame") {
    SettlingLab small;
    small.set("gain", 2.0);
    REQUIRE(small.settles());
    small.turn(1);
    CHECK(small.shown() == 2.0f * small.frames());

    small.set("gain", 3.0);
    small.turn(1);
    CHECK_FALSE(small.is_settled());
    CHECK(small.shown() == 3.0f * small.frames());

    REQUIRE(small.settles());
    const float before = small.frames();
    small.set("step_size", 4.0);
    small.turn(5);
    CHECK(small.shown() == 3.0f * (before + 4.0f * (small.frames() - before)));
    small.lab().edit([](Document& document) { document.undo(); });
    small.turn(1);
    CHECK(small.shown() == 3.0f * (before + 20.0f + small.frames() - before - 5.0f));
}

TEST_CASE("what is modulated goes on moving while the rest is constant") {
    SettlingLab small;
    const Modulation moving{.rate = 1.0};
    small.lab().edit([&](Document& document) { document.set_modulation("gain", moving); });
    REQUIRE(small.settles());
    small.turn(7);
    CHECK(small.is_settled());
    const double gain = small.lab().renderer()->drawn_values().at("gain").number();
    CHECK(gain != 1.0);
    CHECK(std::abs(static_cast<double>(small.shown() / small.frames()) - gain) < 1e-4);
}

TEST_CASE("an edited text is drawn although the former one was settled, and settles as well") {
    SettlingLab small;
    REQUIRE(small.settles());
    small.write_by_rename("gain.glsl",
                          "uniform float gain = 1.0;  // @range 0 8\n#define gain (gain * 5.0)\n");
    REQUIRE(small.turn_until([&] { return small.shown() == 5.0f * small.frames(); }));
    CHECK_FALSE(small.is_settled());
    REQUIRE(small.settles());
    small.turn(1);
    CHECK(small.shown() == 5.0f * small.frames());
}

TEST_CASE("beside a settled picture others are drawn with values of their own") {
    SettlingLab small;
    small.set("gain", 2.0);
    REQUIRE(small.settles());
    Renderer others(small.document().drawn_look(), small.lab().renderer()->executor().programs());
    others.set_values({{"gain", Value(7.0)}});
    REQUIRE(others.resize({8, 8}, {8, 8}).has_value());
    others.claim_programs();
    others.draw({.number = 1, .span = {0.0, 1.0 / 60.0}}, Beam());
    CHECK(gpu::read_pixel(others.executor().target(1), 3, 3)[0] == 7.0f);
    small.turn(1);
    CHECK(small.is_settled());
    CHECK(small.shown() == 2.0f * small.frames());
    small.set("gain", 4.0);
    small.turn(1);
    CHECK(small.shown() == 4.0f * small.frames());
}

TEST_CASE("a picture that stands still is not settled") {
    SettlingLab small;
    small.lab().transport().pause();
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(2);
    small.turn_until([&] { return small.is_settled() || std::chrono::steady_clock::now() > end; });
    CHECK_FALSE(small.lab().is_moving());
}
