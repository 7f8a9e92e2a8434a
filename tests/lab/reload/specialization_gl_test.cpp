// While values are static the picture is drawn by specialised programs, without a visible
// difference.
#include "lab/document/parameter_edits.h"
#include "lab/small_lab.h"
#include "model/tuning/modulation.h"

#include <cmath>

namespace {
/// Its picture is the frame number times `gain`.
class SpecializingLab : public SmallLab {
public:
    bool is_specialized() { return lab().renderer()->executor().programs().is_specialized(); }
    bool specializes() {
        return update_until([&] { return is_specialized(); });
    }
    /// Saves the text with the picture multiplied by `factor`.
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

TEST_CASE("static values become constants, and a change is drawn in its own frame") {
    SpecializingLab small;
    small.set("gain", 2.0);
    REQUIRE(small.specializes());
    small.update(1);
    CHECK(small.shown() == 2.0f * small.frames());

    small.set("gain", 3.0);
    small.update(1);
    CHECK_FALSE(small.is_specialized());
    CHECK(small.shown() == 3.0f * small.frames());

    REQUIRE(small.specializes());
    const float before = small.frames();
    small.set("step_size", 4.0);
    small.update(5);
    CHECK(small.shown() == 3.0f * (before + 4.0f * (small.frames() - before)));
    small.lab().edit([](Document& document) { document.undo(); });
    small.update(1);
    CHECK(small.shown() == 3.0f * (before + 20.0f + small.frames() - before - 5.0f));
}

TEST_CASE("a modulated parameter keeps moving while the others are constants") {
    SpecializingLab small;
    const Modulation moving{.rate = 1.0};
    small.lab().edit([&](Document& document) { set_modulation(document, "gain", moving); });
    REQUIRE(small.specializes());
    small.update(7);
    CHECK(small.is_specialized());
    const double gain = small.lab().renderer()->executor().graph().values().at("gain").number();
    CHECK(gain != 1.0);
    CHECK(std::abs(static_cast<double>(small.shown() / small.frames()) - gain) < 1e-4);
}

TEST_CASE("an edit of a specialised picture is drawn specialised, and later changes too") {
    SpecializingLab small;
    REQUIRE(small.specializes());
    bool was_specialized = true;
    small.save_times(5);
    REQUIRE(small.update_until([&] {
        was_specialized = was_specialized && small.is_specialized();
        return small.shown() == 5.0f * small.frames();
    }));
    CHECK(was_specialized);
    small.set("gain", 2.0);
    REQUIRE(small.update_until([&] { return small.shown() == 10.0f * small.frames(); }));
    CHECK_FALSE(small.is_specialized());
    REQUIRE(small.specializes());
    small.update(1);
    CHECK(small.shown() == 10.0f * small.frames());
}

TEST_CASE("a text that returns is drawn with its earlier specialised programs") {
    SpecializingLab small;
    REQUIRE(small.specializes());
    for (const int factor : {5, 3, 5, 3}) {
        CAPTURE(factor);
        small.save_times(factor);
        const auto shown = static_cast<float>(factor);
        REQUIRE(small.update_until([&] { return small.shown() == shown * small.frames(); }));
        CHECK(small.is_specialized());
    }
}

TEST_CASE("an edit and a simultaneous change are both drawn") {
    SpecializingLab small;
    REQUIRE(small.specializes());
    small.save_times(5);
    small.set("gain", 2.0);
    REQUIRE(small.update_until([&] { return small.shown() == 10.0f * small.frames(); }));
    small.save_times(7);
    small.update(1);
    small.set("gain", 3.0);
    REQUIRE(small.update_until([&] { return small.shown() == 21.0f * small.frames(); }));
}

TEST_CASE("a change after a failed edit is drawn") {
    SpecializingLab small;
    REQUIRE(small.specializes());
    small.save_times(5);
    REQUIRE(small.update_until([&] { return small.shown() == 5.0f * small.frames(); }));
    small.write_by_rename("gain.glsl", "uniform float gain = 1.0;  // @range 0 8\nnonsense\n");
    REQUIRE(small.update_until([&] { return !small.lab().messages().problems().empty(); }));
    small.set("gain", 2.0);
    REQUIRE(small.update_until([&] { return small.shown() == 10.0f * small.frames(); }));
}

TEST_CASE("an edit is drawn with programs that can be turned where it is compared") {
    SpecializingLab small;
    small.lab().frames().comparison().store(0);
    small.set("gain", 2.0);
    REQUIRE(small.specializes());
    small.lab().frames().comparison().choose({{Other::Kind::slot, 0, {}}, CompareMode::wipe});
    REQUIRE(small.update_until(
        [&] { return small.lab().renderer()->executors().variant() != nullptr; }));
    small.save_times(5);
    REQUIRE(small.update_until([&] { return small.shown() == 10.0f * small.frames(); }));
}

TEST_CASE("an edit after the end of a comparison is drawn with specialised programs") {
    SpecializingLab small;
    small.lab().frames().comparison().store(0);
    small.set("gain", 2.0);
    REQUIRE(small.specializes());
    small.lab().frames().comparison().choose({{Other::Kind::slot, 0, {}}, CompareMode::wipe});
    REQUIRE(small.update_until(
        [&] { return small.lab().renderer()->executors().variant() != nullptr; }));
    small.lab().frames().comparison().choose({});
    REQUIRE(small.update_until(
        [&] { return small.lab().renderer()->executors().variant() == nullptr; }));
    small.update(1);
    small.save_times(5);
    REQUIRE(small.update_until([&] { return small.shown() == 10.0f * small.frames(); }));
    CHECK(small.is_specialized());
}

TEST_CASE("an edit that adds a pass is drawn with its own plan") {
    SpecializingLab small;
    REQUIRE(small.specializes());
    small.write("double.frag",
                "#version 410 core\nuniform sampler2D image;\nin vec2 uv;\nout vec4 color;\n"
                "void main() { color = 2.0 * texture(image, uv); }\n");
    small.write_by_rename(
        "look.json",
        replaced(
            small_look::manifest, "\n  ]",
            ",\n{ \"name\": \"double\", \"fragment\": \"double.frag\", \"format\": \"rgba32f\", "
            "\"inputs\": { \"image\": \"show\" } }\n  ]"));
    REQUIRE(small.update_until([&] { return small.document().look().passes.size() == 3; }));
    small.update(1);
    const Executor& executor = small.lab().renderer()->executor();
    CHECK(gpu::read_pixel(executor.target(2), 3, 3)[0] == 2.0f * small.shown());
}

TEST_CASE("another renderer with the same programs draws its own values") {
    SpecializingLab small;
    small.set("gain", 2.0);
    REQUIRE(small.specializes());
    Executors others(Executor(small.document().drawn_look(),
                              small.lab().renderer()->executor().programs().generic()));
    others.picture().set_values({{"gain", Value(7.0)}});
    REQUIRE(others.picture().resize({8, 8}, {8, 8}).has_value());
    others.draw({.number = 1, .span = {0.0, 1.0 / 60.0}}, Beam());
    CHECK(gpu::read_pixel(others.picture().target(1), 3, 3)[0] == 7.0f);
    small.update(1);
    CHECK(small.is_specialized());
    CHECK(small.shown() == 2.0f * small.frames());
    small.set("gain", 4.0);
    small.update(1);
    CHECK(small.shown() == 4.0f * small.frames());
}

TEST_CASE("a paused picture is not specialised") {
    SpecializingLab small;
    small.lab().player().pause();
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(2);
    small.update_until(
        [&] { return small.is_specialized() || std::chrono::steady_clock::now() > end; });
    CHECK_FALSE(small.lab().is_moving());
}
