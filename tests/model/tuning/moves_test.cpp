#include "model/tuning/moves.h"

#include <doctest/doctest.h>

namespace {
Look moved_look() {
    Look look;
    for (const char* name : {"decay", "gain", "noise"}) {
        Parameter parameter;
        parameter.name = name;
        parameter.initial = Value(1.0);
        look.parameters.push_back(parameter);
    }
    look.parameters[2].control = Control::image;
    look.parameters[2].initial = Value::of_path("");
    return look;
}
}  // namespace

TEST_CASE("an automation reader returns the last move at or before a time") {
    MovesReader reader({{0.0, "a", 1.0}, {0.5, "a", 2.0}, {0.5, "b", 3.0}, {0.50001, "a", 4.0}});
    CHECK(reader.take(0.25) == Values{{"a", 1.0}});
    CHECK(reader.take(0.4999).empty());
    CHECK(reader.take(0.5) == Values{{"a", 2.0}, {"b", 3.0}});
    CHECK(reader.take(9.0) == Values{{"a", 4.0}});
    CHECK(reader.take(9.0).empty());
    reader.start_again();
    CHECK(reader.take(0.6) == Values{{"a", 4.0}, {"b", 3.0}});
    MovesReader third({{0.333333, "a", 1.0}});  // a third of a second, as a file stores it
    CHECK(third.take(1.0 / 3.0).size() == 1);
    MovesReader two_thirds({{0.666667, "a", 1.0}});
    CHECK(two_thirds.take(2.0 / 3.0).size() == 1);
}

TEST_CASE("an automation starts with the values that differ from the defaults at time 0") {
    const Look look = moved_look();
    MovesRecorder recorder;
    recorder.note({{"gain", 5.0}}, 1.0);  // not recording
    CHECK(recorder.moves().empty());
    recorder.start(look, {{"gain", 2.0}});
    recorder.note({{"gain", 2.0}}, 3.0);
    recorder.note({{"gain", 2.5}}, 3.5);
    recorder.note({{"gain", 2.75}}, 3.5);  // changed while time is paused
    recorder.note({{"decay", 0.5}, {"noise", Value::of_path("a.png")}}, 4.0);
    CHECK(recorder.moves() ==
          Moves{{0.0, "gain", 2.0}, {3.5, "gain", 2.75}, {4.0, "decay", 0.5}, {4.0, "gain", 1.0}});
    recorder.stop();
    recorder.note({}, 5.0);
    CHECK(recorder.moves().size() == 4);
}

TEST_CASE("when time goes back, later moves are recorded over") {
    const Look look = moved_look();
    MovesRecorder recorder;
    recorder.start(look, {});
    recorder.note({{"gain", 2.0}}, 1.0);
    recorder.note({{"gain", 3.0}}, 2.0);
    recorder.note({{"gain", 3.0}}, 1.5);
    CHECK(recorder.moves() == Moves{{1.0, "gain", 2.0}, {1.5, "gain", 3.0}});
}
