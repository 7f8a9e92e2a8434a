// While values rest the picture is drawn by programs that hold them as constants; nobody sees it.
#include "lab/small_lab.h"
#include "model/tuning/modulation.h"

#include <cmath>

namespace {
/// Its picture is the number of frames, times what `gain` is.
class SettlingLab : public SmallLab {
public:
    bool is_settled() { return lab().renderer()->executor().is_settled(); }
    bool settles() {
        return turn_until([&] { return is_settled(); });
    }
    /// The text with the picture times a number.
    void save_times(int factor) {
        write_by_rename("gain.glsl",
                        "uniform float gain = 1.0;  // @range 0 8\n#define gain (gain * " +
                            std::to_string(factor) + ".0)\n");
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

TEST_CASE("an edit of a settled picture is drawn settled, and what is turned then is seen") {
    SettlingLab small;
    REQUIRE(small.settles());
    bool was_settled = true;
    small.save_times(5);
    REQUIRE(small.turn_until([&] {
        was_settled = was_settled && small.is_settled();
        return small.shown() == 5.0f * small.frames();
    }));
    CHECK(was_settled);
    small.set("gain", 2.0);
    REQUIRE(small.turn_until([&] { return small.shown() == 10.0f * small.frames(); }));
    CHECK_FALSE(small.is_settled());
    REQUIRE(small.settles());
    small.turn(1);
    CHECK(small.shown() == 10.0f * small.frames());
}

TEST_CASE("a text that comes back is drawn settled with the programs that it had") {
    SettlingLab small;
    REQUIRE(small.settles());
    for (const int factor : {5, 3, 5, 3}) {
        CAPTURE(factor);
        small.save_times(factor);
        const auto shown = static_cast<float>(factor);
        REQUIRE(small.turn_until([&] { return small.shown() == shown * small.frames(); }));
        CHECK(small.is_settled());
    }
}

TEST_CASE("an edit and a turn at the same time are both seen") {
    SettlingLab small;
    REQUIRE(small.settles());
    small.save_times(5);
    small.set("gain", 2.0);
    REQUIRE(small.turn_until([&] { return small.shown() == 10.0f * small.frames(); }));
    small.save_times(7);
    small.turn(1);
    small.set("gain", 3.0);
    REQUIRE(small.turn_until([&] { return small.shown() == 21.0f * small.frames(); }));
}

TEST_CASE("what is turned behind an edit that fails is seen") {
    SettlingLab small;
    REQUIRE(small.settles());
    small.save_times(5);
    REQUIRE(small.turn_until([&] { return small.shown() == 5.0f * small.frames(); }));
    small.write_by_rename("gain.glsl", "uniform float gain = 1.0;  // @range 0 8\nnonsense\n");
    REQUIRE(small.turn_until([&] { return !small.lab().messages().problems().empty(); }));
    small.set("gain", 2.0);
    REQUIRE(small.turn_until([&] { return small.shown() == 10.0f * small.frames(); }));
}

TEST_CASE("an edit is drawn with programs that can be turned where it is compared") {
    SettlingLab small;
    small.lab().keep_in_slot(0);
    small.set("gain", 2.0);
    REQUIRE(small.settles());
    small.lab().compare({{Other::Kind::slot, 0, {}}, CompareMode::wipe});
    REQUIRE(small.turn_until([&] { return small.lab().renderer()->variant() != nullptr; }));
    small.save_times(5);
    REQUIRE(small.turn_until([&] { return small.shown() == 10.0f * small.frames(); }));
}

TEST_CASE("an edit is drawn settled as before once nothing is compared any more") {
    SettlingLab small;
    small.lab().keep_in_slot(0);
    small.set("gain", 2.0);
    REQUIRE(small.settles());
    small.lab().compare({{Other::Kind::slot, 0, {}}, CompareMode::wipe});
    REQUIRE(small.turn_until([&] { return small.lab().renderer()->variant() != nullptr; }));
    small.lab().compare({});
    REQUIRE(small.turn_until([&] { return small.lab().renderer()->variant() == nullptr; }));
    small.turn(1);
    small.save_times(5);
    REQUIRE(small.turn_until([&] { return small.shown() == 10.0f * small.frames(); }));
    CHECK(small.is_settled());
}

TEST_CASE("an edit of other passes is drawn by the plan that it has") {
    SettlingLab small;
    REQUIRE(small.settles());
    small.write("double.frag",
                "#version 410 core\nuniform sampler2D image;\nin vec2 uv;\nout vec4 color;\n"
                "void main() { color = 2.0 * texture(image, uv); }\n");
    small.write_by_rename(
        "look.json",
        replaced(
            small_look::manifest, "\n  ]",
            ",\n{ \"name\": \"double\", \"fragment\": \"double.frag\", \"format\": \"rgba32f\", "
            "\"inputs\": { \"image\": \"show\" } }\n  ]"));
    REQUIRE(small.turn_until([&] { return small.document().look().passes.size() == 3; }));
    small.turn(1);
    const Executor& executor = small.lab().renderer()->executor();
    CHECK(gpu::read_pixel(executor.target(2), 3, 3)[0] == 2.0f * small.shown());
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
