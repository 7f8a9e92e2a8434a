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

/// A document with an empty drawing and an active pen.
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
    /// A straight drag of the pen.
    void pull(BeamPosition from, BeamPosition to) {
        board.press(from, board_pixel, document);
        for (int i = 1; i <= 20; ++i)
            board.move({std::lerp(from[0], to[0], i / 20.0), std::lerp(from[1], to[1], i / 20.0)},
                       board_pixel, document);
        board.release(board_pixel, document);
    }
    void edit(const KeyframeChange& change) { board.edit_keyframes(change, document); }
    void move_keyframe(int places) {
        edit([places](EditedDrawing& drawing, Document& edited) {
            drawing.move_keyframe(places, edited);
        });
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

TEST_CASE("a drag of the pen is one stroke and one undo step") {
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

TEST_CASE("a click without a drag draws nothing") {
    Desk desk;
    desk.click(0.1, 0.1);
    CHECK(desk.strokes() == "[]");
    CHECK(desk.document.history().undo_name() == "New drawing");
}

TEST_CASE("clicks draw a line in one undo step, and the first point closes it") {
    Desk desk(PenTool::points);
    desk.click(-0.5, 0.0);
    REQUIRE(desk.board.open_line() != nullptr);
    desk.click(0.5, 0.0);
    desk.click(0.5, 0.5);
    CHECK(desk.strokes() == "[L-0.5 0 0.5 0 0.5 0.5]");
    desk.click(-0.47, 0.02);  // a few pixels from the first point
    CHECK(desk.strokes() == "[L-0.5 0 0.5 0 0.5 0.5z]");
    CHECK(desk.board.open_line() == nullptr);
    desk.click(0.0, -0.5);
    desk.click(0.3, -0.5);
    desk.board.end_line(desk.document);
    desk.click(0.0, -0.8);
    desk.click(0.3, -0.8);
    desk.click(0.31, -0.8);  // a click on the last point ends the line
    CHECK(desk.board.open_line() == nullptr);
    CHECK(desk.keyframe().size() == 3);
    desk.undo();
    desk.undo();
    CHECK(desk.strokes() == "[L-0.5 0 0.5 0 0.5 0.5z]");
    desk.undo();
    CHECK(desk.strokes() == "[]");
}

TEST_CASE("undo removes an unfinished line, and the next click starts another") {
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

TEST_CASE("a stroke is deleted by a click on it") {
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

TEST_CASE("a drag of a point is one undo step and keeps the other points") {
    Desk desk(PenTool::points);
    for (const BeamPosition place : {BeamPosition{-0.5, 0.0}, {0.0, 0.5}, {0.5, 0.0}})
        desk.click(place[0], place[1]);
    desk.board.set_pen({true, PenTool::edit, false}, desk.document);
    CHECK(desk.board.grip_at({0.05, 0.45}, board_pixel) == StrokeGrip{0, 1});
    desk.pull({0.05, 0.45}, {0.15, -0.35});  // it moves relative to the pointer, without a jump
    CHECK(desk.strokes() == "[L-0.5 0 0.1 -0.3 0.5 0]");
    CHECK(desk.document.history().undo_name() == "Move point");
    CHECK_FALSE(desk.document.history().is_in_gesture());
    desk.pull({0.1, -0.3}, {0.2, -0.3});  // another drag is a separate step
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

TEST_CASE("a tiny drag of a point, or a drag away from all strokes, changes nothing") {
    Desk desk;
    desk.pull({-0.5, 0.0}, {0.5, 0.0});
    desk.board.set_pen({true, PenTool::edit, false}, desk.document);
    desk.pull({-0.5, 0.0}, {-0.48, 0.01});
    desk.pull({0.0, 0.3}, {0.2, 0.3});
    CHECK(desk.strokes() == "[L-0.5 0 0.5 0]");
    CHECK(desk.document.history().undo_name() == "Stroke");
}

TEST_CASE("a drag away from the points moves the whole stroke") {
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

TEST_CASE("undo during a drag releases the point") {
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
    desk.undo();  // undoes the stroke itself, before the pointer has moved
    desk.board.move({0.5, 0.5}, board_pixel, desk.document);
    desk.board.release(board_pixel, desk.document);
    CHECK(desk.strokes() == "[]");
}

TEST_CASE("the secondary button deletes a point, and a two-point stroke with it") {
    Desk desk(PenTool::points);
    for (const BeamPosition place : {BeamPosition{-0.5, 0.0}, {0.0, 0.5}, {0.5, 0.0}, {-0.5, 0.0}})
        desk.click(place[0], place[1]);
    CHECK(desk.strokes() == "[L-0.5 0 0 0.5 0.5 0z]");
    const auto right_click = [&](const BeamPosition& place) {
        desk.board.press_other(place, board_pixel, desk.document);
    };
    right_click({0.0, 0.5});  // deletes nothing with another tool
    desk.board.set_pen({true, PenTool::edit, false}, desk.document);
    right_click({0.25, 0.25});  // nor on a line
    CHECK(desk.strokes() == "[L-0.5 0 0 0.5 0.5 0z]");
    right_click({0.0, 0.5});
    CHECK(desk.strokes() == "[L-0.5 0 0.5 0]");  // two points cannot be closed
    CHECK(desk.document.history().undo_name() == "Delete point");
    right_click({0.5, 0.0});
    CHECK(desk.strokes() == "[]");
    CHECK(desk.document.history().undo_name() == "Delete stroke");
    desk.undo();
    desk.undo();
    CHECK(desk.strokes() == "[L-0.5 0 0 0.5 0.5 0z]");
}

TEST_CASE("keyframes are added, removed and reordered in one step each") {
    Desk desk;
    desk.pull({0.0, 0.0}, {0.5, 0.0});
    desk.edit(&EditedDrawing::duplicate_keyframe);
    CHECK(desk.board.keyframe() == 1);
    CHECK(desk.strokes() == "[L0 0 0.5 0][L0 0 0.5 0]");
    desk.edit(&EditedDrawing::clear_keyframe);
    desk.pull({0.0, 0.1}, {0.5, 0.1});
    desk.edit(&EditedDrawing::add_keyframe);
    desk.pull({0.0, 0.2}, {0.5, 0.2});
    CHECK(desk.strokes() == "[L0 0 0.5 0][L0 0.1 0.5 0.1][L0 0.2 0.5 0.2]");
    desk.move_keyframe(-1);
    CHECK(desk.board.keyframe() == 1);
    CHECK(desk.strokes() == "[L0 0 0.5 0][L0 0.2 0.5 0.2][L0 0.1 0.5 0.1]");
    desk.move_keyframe(-5);
    CHECK(desk.strokes() == "[L0 0.2 0.5 0.2][L0 0 0.5 0][L0 0.1 0.5 0.1]");
    desk.edit([](EditedDrawing& drawing, Document&) { drawing.choose_keyframe(2); });
    desk.edit(&EditedDrawing::remove_keyframe);
    CHECK(desk.board.keyframe() == 1);
    desk.edit(&EditedDrawing::remove_keyframe);
    desk.edit(&EditedDrawing::remove_keyframe);  // the last keyframe stays
    CHECK(desk.strokes() == "[L0 0.2 0.5 0.2]");
    desk.undo();
    CHECK(desk.strokes() == "[L0 0.2 0.5 0.2][L0 0 0.5 0]");
}

TEST_CASE("an active pen freezes the shown keyframe, but not that of the document") {
    Desk desk;
    desk.pull({0.0, 0.0}, {0.5, 0.0});
    desk.edit(&EditedDrawing::add_keyframe);
    const Spec shown = desk.board.shown(desk.document.state().signal);
    CHECK(std::get<std::string>(shown.settings.at("play")) == "still");
    CHECK(std::get<double>(shown.settings.at("keyframe")) == 2.0);
    REQUIRE(completed(shown).has_value());
    CHECK(desk.document.state().signal.settings.count("play") == 0);
    desk.board.set_pen({}, desk.document);
    CHECK(desk.board.shown(desk.document.state().signal) == desk.document.state().signal);
}

TEST_CASE("a full drawing accepts no more points") {
    Desk desk;
    Drawing full{{{{}}}};
    for (std::size_t i = 0; i < max_drawing_points; ++i)
        full.keyframes[0][0].points.push_back({0.0, i % 2 == 0 ? 0.0 : 0.5});
    desk.board.replace(full, "Load drawing", desk.document);
    desk.pull({-0.5, 0.0}, {-0.5, 0.5});
    CHECK(desk.keyframe().size() == 1);
    desk.edit(&EditedDrawing::duplicate_keyframe);
    CHECK(desk.board.drawing()->keyframes.size() == 1);
}
