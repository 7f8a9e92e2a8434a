#include "formats/settings/session_format.h"

#include <doctest/doctest.h>

namespace {
SessionState state(const std::string& step, double decay) {
    SessionState made;
    made.step = step;
    made.preset.look = "phosphor";
    made.preset.signal = Spec{"lissajous", {{"x", 3.0}}};
    made.preset.values = {{"decay", Value(decay)}};
    return made;
}

Session session() {
    Session made;
    made.look = "/looks/phosphor/look.json";
    made.opened.front().file = "/presets/phosphor/P31 \"bench\".json";
    made.opened.front().saved = state("", 0.9);
    made.current = state("", 0.95);
    made.current.overrides["bloom_x"] = {
        .format = Format::rgba32f, .scale = 0.25, .filter = Filter::nearest};
    made.past = {state("Decay", 0.92), state("Exposure", 0.93)};
    made.future = {state("Decay", 0.99)};
    made.opened.push_back({"/presets/phosphor/amber.json", state("", 0.92)});
    made.past[1].opened = 1;
    made.time = 12.5;
    made.speed = 0.25;
    made.is_playing = false;
    made.comparison = {.other = {Other::Kind::slot, 1},
                       .mode = CompareMode::difference,
                       .measure = DifferenceMeasure::squared,
                       .gain_stops = 3.5,
                       .has_equal_brightness = true};
    made.slots["phosphor"][1] = Slot{"Amber", {{"decay", Value(0.1 + 0.2)}}};
    made.slots["phosphor+crt"][0] = Slot{{}, {{"crt/tint", Value({0.25, 1.0, 0.5})}}};
    made.fixed_size = {836, 640};
    made.fits_shape = true;
    made.parameter_settings["phosphor"] = {
        {"decay", {.is_favourite = true}},
        {"exposure", {.is_locked = true, .ends = Limit{0.5, 2.0}}}};
    made.preset_stars = {"phosphor/P31 bench", "phosphor+crt/arcade"};
    made.window = {{"left_size", 250.5}, {"width", 1440.0}};
    return made;
}
}  // namespace

TEST_CASE("a session is written and read back unchanged") {
    const auto read = parse_session(session_to_json(session()), "session.json");
    REQUIRE(read.has_value());
    CHECK(*read == session());
}

TEST_CASE("a session in which no look was opened is read back unchanged") {
    Session empty;
    empty.opened.push_back({"/presets/phosphor/amber.json", {}});
    const auto read = parse_session(session_to_json(empty), "session.json");
    REQUIRE(read.has_value());
    CHECK(*read == empty);
    const auto unnamed = parse_session(
        "{\"format\": \"afterglow-session\", \"version\": 1,\n\"slots\": {\"\": {}}}", "s.json");
    REQUIRE_FALSE(unnamed.has_value());
    CHECK(unnamed.error().front().line == 2);
}

TEST_CASE("a new session has no fixed picture size, and an older session follows the view") {
    CHECK_FALSE(Session{}.follows_view);
    CHECK(Session{}.fixed_size.is_empty());
    const auto older = parse_session(R"({"format": "afterglow-session", "version": 1})", "s.json");
    REQUIRE(older.has_value());
    CHECK(older->follows_view);
    CHECK_FALSE(older->fits_shape);
    Session fresh = session();
    fresh.fixed_size = {};
    fresh.fits_shape = false;
    const auto read = parse_session(session_to_json(fresh), "s.json");
    REQUIRE(read.has_value());
    CHECK(*read == fresh);
}

TEST_CASE("only the latest 200 undo steps are kept") {
    Session made = session();
    made.past.clear();
    for (int i = 0; i < 500; ++i)
        made.past.push_back(state("step " + std::to_string(i), 0.5));
    const auto read = parse_session(session_to_json(made), "session.json");
    REQUIRE(read.has_value());
    REQUIRE(read->past.size() == 200);
    CHECK(read->past.back().step == "step 499");
    CHECK(read->past.front().step == "step 300");
}

TEST_CASE("cues are written once for all states that have them, and other ones up to 1 MiB") {
    Session long_show = session();
    const CueText cues{"/shows/a.txt", std::string(200'000, '#')};
    long_show.current.cues = long_show.opened.front().saved.cues = cues;
    long_show.past.clear();
    for (int i = 0; i < 100; ++i)
        long_show.past.push_back(state("Decay", 0.01 * i));
    for (SessionState& step : long_show.past)
        step.cues = cues;
    const std::string json = session_to_json(long_show);
    CHECK(json.size() < 300'000);
    auto read = parse_session(json, "session.json");
    REQUIRE(read.has_value());
    CHECK(*read == long_show);
    for (std::size_t i = 0; i < 100; ++i)
        long_show.past[i].cues.text[0] = static_cast<char>('!' + i % 10);
    read = parse_session(session_to_json(long_show), "session.json");
    REQUIRE(read.has_value());
    CHECK(read->past.size() == 5);  // of 200,000 bytes each
    CHECK(read->past.back() == long_show.past.back());
}

TEST_CASE("a truncated, foreign or newer session is rejected") {
    const std::string whole = session_to_json(session());
    for (std::size_t length = 0; length + 2 < whole.size(); length += 7)
        CHECK_FALSE(parse_session(whole.substr(0, length), "session.json").has_value());
    for (const char* text : {"[]", "{}", R"({"format": "afterglow-preset", "version": 1})",
                             R"({"format": "afterglow-session", "version": 2})",
                             R"({"format": "afterglow-session", "version": 1, "speed": "fast"})",
                             R"({"format": "afterglow-session", "version": 1, "past": [
                                 {"preset": {"format": "afterglow-preset", "version": 1},
                                  "opened": 1}]})"})
        CHECK_FALSE(parse_session(text, "session.json").has_value());
}

TEST_CASE("a comparison with a file is restored, and a wipe of older versions is read") {
    Session made = session();
    made.comparison.other = {Other::Kind::file, 0, "/home/me/crt photo.png"};
    const auto read = parse_session(session_to_json(made), "session.json");
    REQUIRE(read.has_value());
    CHECK(read->comparison == made.comparison);
    const auto older = parse_session(
        R"({"format": "afterglow-session", "version": 1, "is_wiping": true})", "session.json");
    REQUIRE(older.has_value());
    CHECK(older->comparison == Comparison{.mode = CompareMode::wipe});
}
