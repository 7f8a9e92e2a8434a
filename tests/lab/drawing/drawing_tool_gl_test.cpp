#include "base/file.h"
#include "lab/small_lab.h"

#include <cmath>

namespace {
constexpr const char* drawn_signal = R"({
  "format": "afterglow-look", "version": 1, "name": "Small", "driven_by": "signal",
  "default_signal": { "kind": "lissajous", "x": 3, "y": 2 }, "settle_frames": 1,
  "passes": [
    { "name": "sum", "fragment": "sum.frag", "format": "rgba32f", "inputs": { "previous": "sum@1" } },
    { "name": "show", "fragment": "show.frag", "format": "rgba32f", "inputs": { "image": "sum" } }
  ]
})";

std::string strokes_of(const Lab& lab) {
    const auto& settings = lab.document()->state().signal.settings;
    const auto found = settings.find("strokes");
    return found == settings.end() ? std::string() : std::get<std::string>(found->second);
}

void pull(Lab& lab, const BeamPosition& from, const BeamPosition& to) {
    const BeamMapping placing = lab.drawing().placing();
    lab.drawing().pen_down(placing.pixel_of(from));
    lab.drawing().pen_move(placing.pixel_of(to));
    lab.drawing().pen_up();
}

void write(const std::filesystem::path& file, const std::string& text) {
    REQUIRE(write_atomically(file, text).has_value());
}

/// The lowest and highest lit point of the beam at a time.
std::array<float, 2> lit_heights(const Lab& lab, double seconds) {
    std::array<float, 2> heights{9.0f, -9.0f};
    for (const BeamPoint& point : lab.player().signal().trace({seconds, seconds + 1.0 / 60.0}))
        if (point.intensity > 0.0f)
            heights = {std::min(heights[0], point.y), std::max(heights[1], point.y)};
    return heights;
}
}  // namespace

TEST_CASE("an active pen shows a still keyframe, and without it the keyframes play") {
    SmallLab small(drawn_signal);
    Lab& lab = small.lab();
    lab.drawing().take_pen(true);
    CHECK(strokes_of(lab) == "[]");
    pull(lab, {-0.5, -0.5}, {0.5, -0.5});
    lab.drawing().edit_keyframes(&EditedDrawing::add_keyframe);
    pull(lab, {-0.5, 0.5}, {0.5, 0.5});
    CHECK(strokes_of(lab) == "[S-0.5 -0.5 0.5 -0.5][S-0.5 0.5 0.5 0.5]");
    REQUIRE(small.update_until([&] { return lit_heights(lab, 0.0)[0] > 0.4f; }));
    CHECK(std::abs(lit_heights(lab, 1.0)[1] - 0.5f) < 1e-4f);
    lab.drawing().take_pen(false);
    // Each keyframe is held for half a second. A transition takes one second.
    REQUIRE(small.update_until([&] { return lit_heights(lab, 0.0)[1] < -0.4f; }));
    CHECK(std::abs(lit_heights(lab, 1.0)[1]) < 1e-3f);
    CHECK(std::abs(lit_heights(lab, 1.6)[0] - 0.5f) < 1e-4f);
}

TEST_CASE("an opened SVG replaces the drawing, and its errors are reported") {
    SmallLab small(drawn_signal);
    Lab& lab = small.lab();
    lab.drawing().take_pen(true);
    lab.drawing().save(small.folder() / "empty.svg");
    CHECK(lab.messages().notice()->text == "The drawing is empty. Draw something first.");
    pull(lab, {-0.5, -0.5}, {0.5, -0.5});
    lab.drawing().save(small.folder() / "mine");
    CHECK(lab.messages().notice()->text == "Saved \"mine.svg\"");
    const std::string drawn = strokes_of(lab);
    lab.drawing().edit_keyframes(&EditedDrawing::clear_keyframe);
    write(small.folder() / "broken.svg", "<svg>\n<path d='M0 0 L'");
    lab.looks().open_file(small.folder() / "broken.svg");
    CHECK(lab.messages().notice()->text.find("broken.svg:2: ") == 0);
    CHECK(strokes_of(lab) == "[]");
    lab.looks().open_file(small.folder() / "mine.svg");
    CHECK(strokes_of(lab) == drawn);
    CHECK(lab.document()->history().undo_name() == "Load drawing");
    lab.drawing().take_pen(false);
    std::string hatching = "<svg><path d='";
    for (std::size_t i = 0; i <= max_drawing_points / 2; ++i)
        hatching += "M" + std::to_string(i) + " 0v10000";
    write(small.folder() / "long.svg", hatching + "'/></svg>");
    lab.looks().open_file(small.folder() / "long.svg");
    CHECK(lab.messages().notice()->text.find("plays from its file. Its 20002 points") !=
          std::string::npos);
    CHECK(strokes_of(lab).empty());
    REQUIRE(small.update_until([&] { return lab.player().signal().sound().drawing != nullptr; }));
    CHECK(std::abs(lit_heights(lab, 0.0)[1] - 0.8f) < 0.01f);  // 1.6 in total
}

TEST_CASE("an opened scene is drawn") {
    SmallLab small(drawn_signal);
    write(small.folder() / "s.json",
          "{ \"format\": \"afterglow-scene\", \"version\": 1, \"items\": [\n"
          "{ \"shape\": \"line\", \"from\": [-0.5, 0.25], \"to\": [0.5, 0.25] } ] }");
    small.lab().looks().open_file(small.folder() / "s.json");
    REQUIRE(small.update_until([&] { return small.player().signal().sound().scene != nullptr; }));
    CHECK(lit_heights(small.lab(), 0.0)[0] == 0.25f);
}
