// Comparisons of the picture: slots, a picture from a file, the difference.
#include "about.h"
#include "formats/preset/preset_format.h"
#include "io/pictures/picture_file.h"
#include "lab/document/opened_preset.h"
#include "lab/session.h"
#include "lab/small_lab.h"
#include "lab/views/views.h"
#include "model/look/color.h"

namespace fs = std::filesystem;

namespace {
constexpr const char* even = R"(#version 410 core
uniform sampler2D image;
uniform float level = 0.5;   // @range 0 1
uniform float unseen = 0.5;  // @range 0 1
in vec2 uv;
out vec4 color;
void main() { color = vec4(vec3(level + 0.0 * unseen * texture(image, uv).r), 1.0); }
)";

/// A look with a uniform grey picture, drawn into a view of the same size.
class Grey : public SmallLab {
public:
    Grey() {
        write_by_rename("show.frag", even);
        REQUIRE(update_until([&] { return find_parameter(document().look(), "level"); }));
        lab().player().pause();
        auto made = Views::make();
        REQUIRE(made.has_value());
        m_views = std::make_unique<Views>(std::move(*made));
        window.views.sizes.picture = {8, 8};
    }
    void set(const char* name, double value) {
        lab().edit([&](Document& document) {
            document.set_value(name, Value(value));
            document.finish();
        });
    }
    void rest() {
        lab().update(0.0);
        REQUIRE(update_until([&] { return !lab().is_moving() || lab().messages().notice(); }));
        for (int i = 0; i < 3; ++i) {
            lab().update(0.0);
            REQUIRE(update_until([&] { return !lab().renderer()->replay().is_running(); }));
        }
        m_views->update(lab(), window);
    }
    /// Updates the views until `condition` holds. GPU readbacks take several updates.
    template <class Condition>
    void look_until(Condition condition) {
        for (int i = 0; i < 2000 && !condition(); ++i) {
            m_views->update(lab(), window);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        m_views->update(lab(), window);
        REQUIRE(condition());
    }
    /// The red value of a pixel of the view.
    double seen(int x = 4) {
        const Picture picture = m_views->main().read_picture();
        return static_cast<double>(picture.pixels[picture.index(x, 4)]);
    }
    fs::path picture_file(const char* name, Extent extent, std::array<float, 3> rgb) {
        Picture picture{extent, 3, Encoding::display, {}};
        for (int i = 0; i < extent.width * extent.height; ++i)
            picture.pixels.insert(picture.pixels.end(), rgb.begin(), rgb.end());
        REQUIRE(save_picture(picture, folder() / name).has_value());
        return folder() / name;
    }
    Views& views() { return *m_views; }

    WindowState window;

private:
    std::unique_ptr<Views> m_views;
};

constexpr double step = 1.0 / 255.0;
}  // namespace

TEST_CASE("a slot stores values and recalls them as one undo step") {
    Grey small;
    small.set("level", 0.25);
    small.lab().frames().comparison().store(1);
    CHECK(small.lab().frames().comparison().is_in_slot(1));
    CHECK_FALSE(small.lab().frames().comparison().is_in_slot(0));
    small.set("level", 0.75);
    small.set("unseen", 0.125);
    CHECK_FALSE(small.lab().frames().comparison().is_in_slot(1));
    small.lab().frames().comparison().recall(1);
    CHECK(small.document().values() == Values{{"level", Value(0.25)}});
    CHECK(small.document().history().undo_name() == "Recall slot B");
    small.lab().edit([](Document& document) { document.undo(); });
    CHECK(small.document().values() == Values{{"level", Value(0.75)}, {"unseen", Value(0.125)}});

    small.lab().frames().comparison().recall(2);
    CHECK(small.lab().messages().notice()->text == "Slot C is empty");
    CHECK(small.document().history().redo_name() == "Recall slot B");
}

TEST_CASE("a recalled slot brings its preset back, and never that of another one") {
    Grey small;
    small.set("level", 0.25);
    small.lab().presets().save_as("first");
    const std::filesystem::path first = preset_file(small.document());
    small.lab().frames().comparison().store(0);
    small.set("level", 0.5);
    small.lab().presets().save_as("second");
    const auto second = load_preset(preset_file(small.document()));
    REQUIRE(second.has_value());
    small.lab().edit([&](Document& document) {
        open_preset(document, *second, first.parent_path() / "second.json");
    });
    small.lab().frames().comparison().recall(0);
    CHECK(preset_file(small.document()) == first);
    CHECK_FALSE(is_modified(small.document()));

    small.lab().edit([](Document& document) { document.undo(); });
    CHECK(preset_name(small.document()) == "second");
    std::filesystem::remove(first);
    small.lab().frames().comparison().recall(0);
    CHECK(preset_name(small.document()) == "first");
    CHECK(preset_file(small.document()).empty());
    CHECK_FALSE(small.lab().presets().can_save_over());
}

TEST_CASE("slots and the comparison are restored at the next start") {
    Grey small;
    small.set("level", 0.25);
    small.lab().frames().comparison().store(2);
    small.set("level", 0.75);
    small.lab().frames().comparison().compare_with({Other::Kind::slot, 2});
    const auto session = parse_session(session_to_json(session_of(small.lab(), {})), "s.json");
    REQUIRE(session.has_value());
    small.start();
    small.lab().frames().comparison().set_all_slots(session->slots);
    restore(small.lab(), *session);
    REQUIRE(
        small.update_until([&] { return small.lab().frames().comparison().sides().has_value(); }));
    CHECK(small.lab().frames().comparison().slots()[2]->values == Values{{"level", Value(0.25)}});
    CHECK(small.lab().frames().comparison().mode() == CompareMode::wipe);
    CHECK(small.lab().frames().comparison().sides()->other == "Slot C");
}

TEST_CASE("a wipe shows the slot on its side and follows changes of the slot") {
    Grey small;
    small.lab().frames().comparison().store(0);
    small.set("level", 1.0);
    small.lab().frames().comparison().compare_with({Other::Kind::slot, 0});
    small.rest();
    CHECK(small.seen(1) == about(0.5, step));
    CHECK(small.seen(6) == 1.0);
    small.set("level", 0.75);
    small.lab().frames().comparison().store(0);
    small.rest();
    CHECK(small.seen(1) == about(0.75, step));
    small.lab().frames().comparison().clear_slot(0);
    small.rest();
    CHECK(small.lab().frames().comparison().mode() == CompareMode::off);
    CHECK(small.lab().renderer()->executors().variant() == nullptr);
}

TEST_CASE("a flash shows the other picture and leaves the document unchanged") {
    Grey small;
    small.set("level", 0.25);
    small.lab().frames().comparison().store(0);
    small.set("level", 1.0);
    const std::string before = small.document().history().undo_name();
    small.lab().frames().comparison().show_reference(true);
    small.rest();
    CHECK(small.lab().frames().comparison().mode() == CompareMode::off);
    CHECK(small.seen() == about(0.25, step));
    small.lab().frames().comparison().show_reference(false);
    small.rest();
    CHECK(small.seen() == 1.0);
    CHECK(small.document().history().undo_name() == before);
    CHECK_FALSE(small.document().history().can_redo());
    CHECK(small.lab().renderer()->executors().variant() != nullptr);  // kept for the next flash
    small.lab().update(6.0);
    small.lab().update(0.0);
    CHECK(small.lab().renderer()->executors().variant() == nullptr);
}

TEST_CASE("side-by-side pictures get half the view each") {
    Grey small;
    small.lab().frames().comparison().store(0);
    small.set("level", 1.0);
    small.window.views.sizes.picture = {18, 8};
    small.lab().frames().comparison().compare_with({Other::Kind::slot, 0});
    small.lab().frames().comparison().set_mode(CompareMode::side_by_side);
    small.rest();
    CHECK(small.views().main().picture().extent == Extent{8, 8});
    CHECK(small.views().main().reference().extent == Extent{8, 8});
    CHECK(small.seen() == 1.0);
    small.lab().frames().comparison().set_mode(CompareMode::off);
    small.rest();
    CHECK(small.views().main().picture().extent == Extent{18, 8});
    CHECK(small.views().main().reference().handle == 0);
}

TEST_CASE("a comparison with a picture file follows the file on disk") {
    Grey small;
    const auto file = small.picture_file("photo.png", {8, 8}, {0.2f, 0.4f, 0.6f});
    small.lab().frames().comparison().compare_with_file(file);
    small.rest();
    CHECK(small.lab().renderer()->executors().variant() == nullptr);
    CHECK(small.lab().frames().comparison().sides()->other == "photo.png");
    CHECK(small.seen(1) == about(0.2, step));
    CHECK(small.seen(6) == about(0.5, step));

    const auto next = small.picture_file("next.png", {8, 8}, {0.8f, 0.4f, 0.6f});
    std::filesystem::rename(next, file);
    REQUIRE(small.update_until([&] {
        small.rest();
        return small.seen(1) > 0.7;
    }));
    CHECK(small.seen(1) == about(0.8, step));
}

TEST_CASE("a picture of another size is fitted, and the sizes are reported") {
    Grey small;
    small.lab().frames().comparison().compare_with_file(
        small.picture_file("wide.png", {32, 16}, {1.0f, 1.0f, 1.0f}));
    CHECK(small.lab().messages().notice()->text ==
          "Comparing with \"wide.png\" (32 × 16, scaled to 8 × 8)");
    CHECK(small.lab().frames().comparison().sides()->other == "wide.png · 32 × 16, scaled");
    small.rest();
    const Picture seen = small.views().main().read_picture();
    CHECK(seen.pixels[seen.index(1, 4)] == 1.0f);
    CHECK(seen.pixels[seen.index(1, 0)] == 0.0f);
    CHECK(seen.pixels[seen.index(1, 7)] == 0.0f);
}

TEST_CASE("a file that is not a picture is reported and not compared") {
    Grey small;
    small.lab().frames().comparison().compare_with_file(small.look_folder() / "look.json");
    REQUIRE(small.lab().messages().notice());
    CHECK(small.lab().messages().notice()->is_problem);
    CHECK(small.lab().messages().notice()->text.find("look.json") != std::string::npos);
    CHECK(small.lab().frames().comparison().selection().chosen() == Comparison{});
}

TEST_CASE("the difference view applies its gain and reports its statistics") {
    Grey small;
    small.lab().frames().comparison().compare_with_file(
        small.picture_file("grey.png", {8, 8}, {0.6f, 0.6f, 0.6f}));
    Comparison comparison = small.lab().frames().comparison().selection().chosen();
    comparison.mode = CompareMode::difference;
    comparison.gain_stops = 2.0;
    small.lab().frames().comparison().choose(comparison);
    small.rest();
    const double apart = 153.0 / 255.0 - 0.5;
    CHECK(small.seen() == about(4.0 * apart, step / apart));
    small.look_until([&] { return small.views().main().compared().distances().has_value(); });
    const Distances distances = *small.views().main().compared().distances();
    CHECK(distances.mean == about(apart, 1e-5));
    CHECK(distances.rms == about(apart, 1e-5));
    CHECK(distances.psnr_db == about(20.0, 1e-4));
    CHECK(distances.share_beyond == 1.0);

    comparison.measure = DifferenceMeasure::relative;
    comparison.gain_stops = 0.0;
    small.lab().frames().comparison().choose(comparison);
    small.rest();
    CHECK(small.seen() == about(apart / 0.6, step / apart));
}

TEST_CASE("equal brightness scales the other picture to the same mean light") {
    Grey small;
    small.lab().frames().comparison().compare_with_file(
        small.picture_file("dark.png", {8, 8}, {0.0f, 0.2f, 0.0f}));
    Comparison comparison = small.lab().frames().comparison().selection().chosen();
    comparison.has_equal_brightness = true;
    small.lab().frames().comparison().choose(comparison);
    small.set("level", 0.3);
    small.rest();
    small.look_until([&] { return small.views().main().compared().stops().has_value(); });
    const double factor = srgb_decode(0.3) / (0.7152 * srgb_decode(0.2));
    CHECK(*small.views().main().compared().stops() == about(std::log2(factor), 1e-3));
    const Picture seen = small.views().main().read_picture();
    CHECK(static_cast<double>(seen.pixels[seen.index(1, 4) + 1]) ==
          about(srgb_encode(factor * srgb_decode(0.2)), 2 * step));
    CHECK(seen.pixels[seen.index(1, 4)] == 0.0f);
}

TEST_CASE("without a comparison no other picture is kept on the GPU") {
    Grey small;
    small.rest();
    CHECK(small.views().main().compared().other() == nullptr);
    small.lab().frames().comparison().store(0);
    small.rest();
    CHECK(small.lab().renderer()->executors().variant() == nullptr);
}
