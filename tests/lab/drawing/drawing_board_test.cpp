#include "lab/drawing/drawing_board.h"

#include "signals/signal_table.h"

#include <doctest/doctest.h>

#include <cmath>

namespace {
constexpr double board_pixel = 0.01;  // half screens

Look scope() {
    Look look;
    look.id = "scope";
    look.driven_by = Driver::signal;
    look.default_signal = Spec{"lissajous", {{"x", 3.0}}};
    return look;
}

/// A person with a pen in the hand and an empty drawing.
struct Desk {
    Document document{scope()};
    DrawingBoard board;

    explicit Desk(PenTool tool = PenTool::freehand) {
        board.replace(Drawing{{{}}}, "New drawing", document);
        board.set_pen({true, tool, false}, document);
    }

    void click(double x, double y) {
        board.press({x, y}, board_pixel, document);
        board.release(board_pixel, document);
    }
    /// A straight pull of the pen.
    void pull(BeamPlace from, BeamPlace to) {
        board.press(from, board_pixel, document);
        for (int i = 1; i <= 20; ++i)
            board.move({std::lerp(from[0], to[0], i / 20.0), std::lerp(from[1], to[1], i / 20.0)},
                       board_pixel, document);
        board.release(board_pixel, document);
    }
    void undo() {
        document.undo();
        board.follow(document);
    }
    std::string strokes() const {
        const auto& settings = document.state().signal.settings;
        return std::get<std::string>(settings.at("strokes"));
    }
    Keyframe keyframe() const { return board.drawing()->keyframes[board.keyframe()]; }
};
}  // namespace

TEST_CASE("a pull of the pen is one stroke and one step of undo") {
    Desk desk;
    desk.pull({-0.5, 0.0}, {0.5, 0.2});
    CHECK(desk.strokes() == "[L-0.5 0 0.5 0.2]");
    desk.pull({0.0, -0.5}, {0.0, 0.5});
    CHECK(desk.keyframe().size() == 2);
    CHECK(desk.document.history().undo_name() == "Stroke");
    desk.undo();
    CHECK(desk.strokes() == "[L-0.5 0 0.5 0.2]");
    desk.undo();
    CHECK(desk.strokes() == "[]");
    CHECK(desk.document.history().undo_name() == "New drawing");
    desk.document.redo();
    CHECK(desk.strokes() == "[L-0.5 0 0.5 0.2]");
    desk.undo();
    desk.undo();
    CHECK(desk.document.state().signal.kind == "lissajous");
    CHECK_FALSE(desk.board.has_pen());
}

TEST_CASE("a click without a pull leaves nothing") {
    Desk desk;
    desk.click(0.1, 0.1);
    CHECK(desk.strokes() == "[]");
    CHECK(desk.document.history().undo_name() == "New drawing");
}

TEST_CASE("clicks make a line, which is one step; the first point closes it") {
    Desk desk(PenTool::points);
    desk.click(-0.5, 0.0);
    REQUIRE(desk.board.open_line() != nullptr);
    desk.click(0.5, 0.0);
    desk.click(0.5, 0.5);
    CHECK(desk.strokes() == "[L-0.5 0 0.5 0 0.5 0.5]");
    desk.click(-0.47, 0.02);  // a few pixels from where it began
    CHECK(desk.strokes() == "[L-0.5 0 0.5 0 0.5 0.5z]");
    CHECK(desk.board.open_line() == nullptr);
    desk.click(0.0, -0.5);
    desk.click(0.3, -0.5);
    desk.board.end_line(desk.document);
    desk.click(0.0, -0.8);
    desk.click(0.3, -0.8);
    desk.click(0.31, -0.8);  // the same place again ends it
    CHECK(desk.board.open_line() == nullptr);
    CHECK(desk.keyframe().size() == 3);
    desk.undo();
    desk.undo();
    CHECK(desk.strokes() == "[L-0.5 0 0.5 0 0.5 0.5z]");
    desk.undo();
    CHECK(desk.strokes() == "[]");
}

TEST_CASE("undo takes back a line that is under way, and the next click begins another") {
    Desk desk(PenTool::points);
    for (const double x : {-0.5, 0.0, 0.5})
        desk.click(x, 0.0);
    desk.undo();
    CHECK(desk.strokes() == "[]");
    CHECK(desk.board.open_line() == nullptr);
    desk.click(0.0, 0.3);
    desk.click(0.2, 0.3);
    CHECK(desk.strokes() == "[L0 0.3 0.2 0.3]");
}

TEST_CASE("a stroke is deleted by pointing at it") {
    Desk desk;
    desk.pull({-0.5, 0.0}, {0.5, 0.0});
    desk.pull({-0.5, 0.5}, {0.5, 0.5});
    desk.board.set_pen({true, PenTool::erase, false}, desk.document);
    desk.click(0.0, 0.25);
    CHECK(desk.keyframe().size() == 2);
    desk.click(0.0, 0.47);
    CHECK(desk.strokes() == "[L-0.5 0 0.5 0]");
    CHECK(desk.document.history().undo_name() == "Delete stroke");
}

TEST_CASE("a point of a finished stroke is dragged in one step of undo, the others stay") {
    Desk desk(PenTool::points);
    for (const BeamPlace place : {BeamPlace{-0.5, 0.0}, {0.0, 0.5}, {0.5, 0.0}})
        desk.click(place[0], place[1]);
    desk.board.set_pen({true, PenTool::edit, false}, desk.document);
    CHECK(desk.board.grip_at({0.05, 0.45}, board_pixel) == StrokeGrip{0, 1});
    desk.pull({0.05, 0.45}, {0.15, -0.35});  // it follows the hand, and does not jump to it
    CHECK(desk.strokes() == "[L-0.5 0 0.1 -0.3 0.5 0]");
    CHECK(desk.document.history().undo_name() == "Move point");
    CHECK_FALSE(desk.document.history().is_in_gesture());
    desk.pull({0.1, -0.3}, {0.2, -0.3});  // the same once more is a step of its own
    CHECK(desk.strokes() == "[L-0.5 0 0.2 -0.3 0.5 0]");
    desk.undo();
    CHECK(desk.strokes() == "[L-0.5 0 0.1 -0.3 0.5 0]");
    desk.undo();
    CHECK(desk.strokes() == "[L-0.5 0 0 0.5 0.5 0]");
    CHECK(desk.document.history().undo_name() == "Stroke");
    desk.document.redo();
    desk.board.follow(desk.document);
    CHECK(desk.strokes() == "[L-0.5 0 0.1 -0.3 0.5 0]");
}

TEST_CASE("a click that trembles on a point is no step, and what lies nowhere near is not moved") {
    Desk desk;
    desk.pull({-0.5, 0.0}, {0.5, 0.0});
    desk.board.set_pen({true, PenTool::edit, false}, desk.document);
    desk.pull({-0.5, 0.0}, {-0.48, 0.01});
    desk.pull({0.0, 0.3}, {0.2, 0.3});
    CHECK(desk.strokes() == "[L-0.5 0 0.5 0]");
    CHECK(desk.document.history().undo_name() == "Stroke");
}

TEST_CASE("a line is dragged as a whole where no point is near") {
    Desk desk;
    desk.pull({-0.5, 0.5}, {0.5, 0.5});
    desk.pull({-0.5, 0.0}, {0.5, 0.0});
    desk.board.set_pen({true, PenTool::edit, false}, desk.document);
    CHECK(desk.board.grip_at({0.1, 0.05}, board_pixel) == StrokeGrip{1, std::nullopt});
    desk.pull({0.0, 0.0}, {0.25, -0.5});
    CHECK(desk.strokes() == "[L-0.5 0.5 0.5 0.5;L-0.25 -0.5 0.75 -0.5]");
    CHECK(desk.document.history().undo_name() == "Move stroke");
    desk.undo();
    CHECK(desk.strokes() == "[L-0.5 0.5 0.5 0.5;L-0.5 0 0.5 0]");
}

TEST_CASE("undo in the middle of a drag lets go of the point") {
    Desk desk;
    desk.pull({-0.5, 0.0}, {0.5, 0.0});
    desk.board.set_pen({true, PenTool::edit, false}, desk.document);
    desk.board.press({0.5, 0.0}, board_pixel, desk.document);
    desk.board.move({0.5, 0.4}, board_pixel, desk.document);
    CHECK(desk.strokes() == "[L-0.5 0 0.5 0.4]");
    desk.undo();
    desk.board.move({0.5, 0.5}, board_pixel, desk.document);
    desk.board.release(board_pixel, desk.document);
    CHECK(desk.strokes() == "[L-0.5 0 0.5 0]");
    desk.board.press({0.5, 0.0}, board_pixel, desk.document);
    desk.undo();  // the stroke itself, before the hand has moved
    desk.board.move({0.5, 0.5}, board_pixel, desk.document);
    desk.board.release(board_pixel, desk.document);
    CHECK(desk.strokes() == "[]");
}

TEST_CASE("the other button deletes a point; of two points the stroke goes with it") {
    Desk desk(PenTool::points);
    for (const BeamPlace place : {BeamPlace{-0.5, 0.0}, {0.0, 0.5}, {0.5, 0.0}, {-0.5, 0.0}})
        desk.click(place[0], place[1]);
    CHECK(desk.strokes() == "[L-0.5 0 0 0.5 0.5 0z]");
    const auto other_button = [&](const BeamPlace& place) {
        desk.board.press_other(place, board_pixel, desk.document);
    };
    other_button({0.0, 0.5});  // with another tool it deletes nothing
    desk.board.set_pen({true, PenTool::edit, false}, desk.document);
    other_button({0.25, 0.25});  // nor on a line
    CHECK(desk.strokes() == "[L-0.5 0 0 0.5 0.5 0z]");
    other_button({0.0, 0.5});
    CHECK(desk.strokes() == "[L-0.5 0 0.5 0]");  // two points close nothing
    CHECK(desk.document.history().undo_name() == "Delete point");
    other_button({0.5, 0.0});
    CHECK(desk.strokes() == "[]");
    CHECK(desk.document.history().undo_name() == "Delete stroke");
    desk.undo();
    desk.undo();
    CHECK(desk.strokes() == "[L-0.5 0 0 0.5 0.5 0z]");
}

TEST_CASE("keyframes come, go and change places, each in one step") {
    Desk desk;
    desk.pull({0.0, 0.0}, {0.5, 0.0});
    desk.board.duplicate_keyframe(desk.document);
    CHECK(desk.board.keyframe() == 1);
    CHECK(desk.strokes() == "[L0 0 0.5 0][L0 0 0.5 0]");
    desk.board.clear_keyframe(desk.document);
    desk.pull({0.0, 0.1}, {0.5, 0.1});
    desk.board.add_keyframe(desk.document);
    desk.pull({0.0, 0.2}, {0.5, 0.2});
    CHECK(desk.strokes() == "[L0 0 0.5 0][L0 0.1 0.5 0.1][L0 0.2 0.5 0.2]");
    desk.board.move_keyframe(-1, desk.document);
    CHECK(desk.board.keyframe() == 1);
    CHECK(desk.strokes() == "[L0 0 0.5 0][L0 0.2 0.5 0.2][L0 0.1 0.5 0.1]");
    desk.board.move_keyframe(-5, desk.document);
    CHECK(desk.strokes() == "[L0 0.2 0.5 0.2][L0 0 0.5 0][L0 0.1 0.5 0.1]");
    desk.board.choose_keyframe(2, desk.document);
    desk.board.remove_keyframe(desk.document);
    CHECK(desk.board.keyframe() == 1);
    desk.board.remove_keyframe(desk.document);
    desk.board.remove_keyframe(desk.document);  // the last one stays
    CHECK(desk.strokes() == "[L0 0.2 0.5 0.2]");
    desk.undo();
    CHECK(desk.strokes() == "[L0 0.2 0.5 0.2][L0 0 0.5 0]");
}

TEST_CASE("while the pen is in the hand its keyframe stands still, the document's does not") {
    Desk desk;
    desk.pull({0.0, 0.0}, {0.5, 0.0});
    desk.board.add_keyframe(desk.document);
    const Spec shown = desk.board.shown(desk.document.state().signal);
    CHECK(std::get<std::string>(shown.settings.at("play")) == "still");
    CHECK(std::get<double>(shown.settings.at("keyframe")) == 2.0);
    REQUIRE(completed(shown).has_value());
    CHECK(desk.document.state().signal.settings.count("play") == 0);
    desk.board.set_pen({}, desk.document);
    CHECK(desk.board.shown(desk.document.state().signal) == desk.document.state().signal);
}

TEST_CASE("a drawing that is full takes no more points") {
    Desk desk;
    Drawing full{{{{}}}};
    for (std::size_t i = 0; i < most_drawing_points; ++i)
        full.keyframes[0][0].points.push_back({0.0, i % 2 == 0 ? 0.0 : 0.5});
    desk.board.replace(full, "Load drawing", desk.document);
    desk.pull({-0.5, 0.0}, {-0.5, 0.5});
    CHECK(desk.keyframe().size() == 1);
    desk.board.duplicate_keyframe(desk.document);
    CHECK(desk.board.drawing()->keyframes.size() == 1);
}
