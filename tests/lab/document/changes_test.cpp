#include "lab/document/changes.h"

#include "lab/document/history.h"

#include <doctest/doctest.h>

namespace {
Parameter changed_parameter(const std::string& name, double initial, const std::string& unit) {
    Parameter parameter;
    parameter.name = name;
    parameter.label = label_from_name(name);
    parameter.initial = Value(initial);
    parameter.unit = unit;
    return parameter;
}

Look changed_look() {
    Look look;
    look.id = "small";
    look.name = "Small";
    look.driven_by = Driver::signal;
    look.default_signal = Spec{"lissajous", {{"x", 3.0}}};
    look.parameters = {changed_parameter("decay", 0.92, "per 1/60 s"),
                       changed_parameter("exposure", 1.5, "")};
    return look;
}

std::vector<std::string> lines(const std::vector<Change>& changes) {
    std::vector<std::string> lines;
    for (const Change& change : changes)
        lines.push_back(change.label + ": " + change.before + " | " + change.after +
                        (change.unit.empty() ? "" : " " + change.unit));
    return lines;
}
using Lines = std::vector<std::string>;
}  // namespace

TEST_CASE("only differences are listed, with both values and the unit") {
    const Look look = changed_look();
    DocumentState before = initial_state(look);
    DocumentState after = before;
    CHECK(changes_between(look, before, after).empty());
    after.values["decay"] = Value(0.61);
    before.values["exposure"] = Value(1.5);  // explicit, but equal to the default
    CHECK(lines(changes_between(look, before, after)) == Lines{"Decay: 0.92 | 0.61 per 1/60 s"});
    CHECK(lines(changes_between(look, after, before)) == Lines{"Decay: 0.61 | 0.92 per 1/60 s"});
    after.values["gone"] = Value(3.0);
    CHECK(lines(changes_between(look, before, after)) ==
          Lines{"Decay: 0.92 | 0.61 per 1/60 s", "gone: not set | 3"});
}

TEST_CASE("nearly equal values are written with enough digits to differ") {
    const Look look = changed_look();
    DocumentState before = initial_state(look);
    DocumentState after = before;
    before.values["exposure"] = Value(1.000001);
    after.values["exposure"] = Value(1.000002);
    CHECK(lines(changes_between(look, before, after)) == Lines{"Exposure: 1.000001 | 1.000002"});
}

TEST_CASE("signal settings are compared by their effective values") {
    const Look look = changed_look();
    DocumentState before = initial_state(look);
    DocumentState after = before;
    before.signal = Spec{"lissajous", {{"x", 3.0}, {"y", 2.0}}};
    after.signal = Spec{"lissajous", {{"x", 5.0}, {"y", 2.0}}};
    CHECK(lines(changes_between(look, before, after)) ==
          Lines{"Signal: X frequency: 3 | 5 per 1/60 s"});
    after.signal = Spec{"text", {{"text", std::string("HELLO")}}};
    const std::vector<Change> kinds = changes_between(look, before, after);
    REQUIRE(kinds.size() == 1);
    CHECK(kinds[0].label == "Signal");
    CHECK(kinds[0].before == "Lissajous figure");
}

TEST_CASE("source, bypass and pass overrides are listed too") {
    const Look look = changed_look();
    DocumentState before = initial_state(look);
    before.stack = {{"a", "/a", "a"}, {"b", "/b", "b"}};
    DocumentState after = before;
    after.source = "/home/me/cat.png";
    after.stack[1].is_bypassed = true;
    after.overrides["bloom"].scale = 0.5;
    CHECK(lines(changes_between(look, before, after)) ==
          Lines{"Source: none | cat.png", "Stack: a + b | a + (b)", "Pass bloom: default | 0.5×"});
}

TEST_CASE("a step has a short summary") {
    const Change decay{"decay", "Decay", "0.92", "0.61", "per 1/60 s"};
    const Change angle{"tilt", "Tilt", "0", "30", "°"};
    CHECK(summary_of({decay}, "Decay") == "0.92 → 0.61 per 1/60 s");
    CHECK(summary_of({decay}, "Reset Decay") == "0.92 → 0.61 per 1/60 s");
    CHECK(summary_of({angle}, "Paste") == "Tilt 0 → 30°");
    CHECK(summary_of({decay, angle}, "Decay") == "Decay 0.92 → 0.61 per 1/60 s, 1 more");
    CHECK(summary_of({}, "Paste").empty());
    CHECK(line_of(angle) == "Tilt 0 → 30°");
}

TEST_CASE("the history lists past and undone steps and jumps any number of steps") {
    Document document(changed_look());
    for (const double decay : {0.8, 0.7, 0.6})
        document.set_value("decay", Value(decay));
    document.undo();
    REQUIRE(history_size(document) == 4);
    CHECK(history_index(document) == 2);
    CHECK(history_step(document, 0).name == "Start");
    CHECK(history_step(document, 1).change == "0.92 → 0.8 per 1/60 s");
    CHECK(history_step(document, 2).distance == 0);
    CHECK(history_step(document, 2).details == "Decay 0.8 → 0.7 per 1/60 s");
    CHECK(history_step(document, 3).change == "0.7 → 0.6 per 1/60 s");
    CHECK(history_step(document, 3).distance == 1);

    const auto decay = [&] { return document.value(document.look().parameters[0]).number(); };
    document.travel(-2);
    CHECK(decay() == 0.92);
    CHECK(history_step(document, 3).distance == 3);
    CHECK(history_step(document, 2).change == "0.8 → 0.7 per 1/60 s");
    document.travel(3);
    CHECK(decay() == 0.6);
    document.travel(-99);
    CHECK(decay() == 0.92);
    CHECK(history_index(document) == 0);
}
