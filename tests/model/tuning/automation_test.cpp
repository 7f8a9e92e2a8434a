#include "model/tuning/automation.h"

#include <doctest/doctest.h>

namespace {
Look automated_look() {
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

TEST_CASE("an automation reader returns the last point at or before a time") {
    AutomationReader reader(
        {{0.0, "a", 1.0}, {0.5, "a", 2.0}, {0.5, "b", 3.0}, {0.50001, "a", 4.0}});
    CHECK(reader.take(0.25) == Values{{"a", 1.0}});
    CHECK(reader.take(0.4999).empty());
    CHECK(reader.take(0.5) == Values{{"a", 2.0}, {"b", 3.0}});
    CHECK(reader.take(9.0) == Values{{"a", 4.0}});
    CHECK(reader.take(9.0).empty());
    reader.start_again();
    CHECK(reader.take(0.6) == Values{{"a", 4.0}, {"b", 3.0}});
    AutomationReader third({{0.333333, "a", 1.0}});  // a third of a second, as a file stores it
    CHECK(third.take(1.0 / 3.0).size() == 1);
    AutomationReader two_thirds({{0.666667, "a", 1.0}});
    CHECK(two_thirds.take(2.0 / 3.0).size() == 1);
}

TEST_CASE("an automation starts with the values that differ from the defaults at time 0") {
    const Look look = automated_look();
    AutomationRecorder recorder;
    recorder.note({{"gain", 5.0}}, 1.0);  // not recording
    CHECK(recorder.points().empty());
    recorder.start(look, {{"gain", 2.0}});
    recorder.note({{"gain", 2.0}}, 3.0);
    recorder.note({{"gain", 2.5}}, 3.5);
    recorder.note({{"gain", 2.75}}, 3.5);  // changed while time is paused
    recorder.note({{"decay", 0.5}, {"noise", Value::of_path("a.png")}}, 4.0);
    CHECK(recorder.points() ==
          AutomationPoints{
              {0.0, "gain", 2.0}, {3.5, "gain", 2.75}, {4.0, "decay", 0.5}, {4.0, "gain", 1.0}});
    recorder.stop();
    recorder.note({}, 5.0);
    CHECK(recorder.points().size() == 4);
}

TEST_CASE("when time goes back, later points are recorded over") {
    const Look look = automated_look();
    AutomationRecorder recorder;
    recorder.start(look, {});
    recorder.note({{"gain", 2.0}}, 1.0);
    recorder.note({{"gain", 3.0}}, 2.0);
    recorder.note({{"gain", 3.0}}, 1.5);
    CHECK(recorder.points() == AutomationPoints{{1.0, "gain", 2.0}, {1.5, "gain", 3.0}});
}
