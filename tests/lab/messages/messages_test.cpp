#include "lab/messages/messages.h"

#include <doctest/doctest.h>

namespace {
Diagnostic problem_in(const char* file, const char* message) {
    return {file, 0, message};
}
}  // namespace

TEST_CASE("a notice disappears after 5 seconds, a problem after 12, a question never") {
    Messages messages;
    messages.say("Saved");
    messages.update(4.9);
    CHECK(messages.notice().has_value());
    messages.update(0.2);
    CHECK_FALSE(messages.notice().has_value());

    messages.say("can't be saved", true);
    messages.update(11.9);
    CHECK(messages.notice().has_value());
    messages.update(0.2);
    CHECK_FALSE(messages.notice().has_value());

    messages.ask("Use it?", {});
    messages.update(1000.0);
    CHECK(messages.notice().has_value());
    CHECK_FALSE(messages.is_counting());
    messages.dismiss();
    CHECK_FALSE(messages.notice().has_value());
}

TEST_CASE("a problem is withdrawn by its subject only") {
    Messages messages;
    messages.say("No sound", true, "sound device");
    messages.withdraw("file");
    CHECK(messages.notice().has_value());
    messages.withdraw("sound device");
    CHECK_FALSE(messages.notice().has_value());
}

TEST_CASE("text is appended to a notice without buttons, and replaces a problem") {
    Messages messages;
    messages.say("Opened");
    messages.append("Kept song.wav", {.name = "Use the preset's signal"});
    CHECK(messages.notice()->text == "Opened · Kept song.wav");
    REQUIRE(messages.notice()->buttons.size() == 1);
    messages.append("Kept other.wav", {.name = "Use"});
    CHECK(messages.notice()->text == "Kept other.wav");
    messages.say("failed", true);
    messages.append("Kept song.wav", {.name = "Use"});
    CHECK(messages.notice()->text == "Kept song.wav");
}

TEST_CASE("problems of the look come before those of its content") {
    Messages messages;
    messages.set_content_problems({problem_in("song.wav", "is missing")});
    messages.set_look_problems({problem_in("a.frag", "syntax error")});
    REQUIRE(messages.problems().size() == 2);
    CHECK(messages.problems()[0].diagnostic.file == "a.frag");
    CHECK(messages.problems()[1].diagnostic.file == "song.wav");
    messages.set_look_problems({});
    CHECK(messages.problems().size() == 1);
}

TEST_CASE("dismissed problems return with a new problem, not with a solved one") {
    Messages messages;
    messages.set_look_problems({problem_in("a.frag", "one"), problem_in("a.frag", "two")});
    messages.dismiss_problems();
    messages.set_look_problems({problem_in("a.frag", "one")});
    CHECK(messages.are_problems_dismissed());
    messages.set_look_problems({problem_in("a.frag", "three")});
    CHECK_FALSE(messages.are_problems_dismissed());
}

TEST_CASE("the notice about a file goes when its problem is solved") {
    Messages messages;
    messages.set_content_problems({problem_in("song.wav", "is missing")});
    messages.say(problem_in("song.wav", "is missing"));
    messages.set_content_problems({});
    CHECK_FALSE(messages.notice().has_value());
}

TEST_CASE("a dialog takes the notice about its own failure, and no other") {
    Messages messages;
    CHECK_FALSE(messages.take_problem().has_value());
    messages.say("Saved");
    CHECK_FALSE(messages.take_problem().has_value());
    CHECK(messages.notice()->text == "Saved");
    messages.say(problem_in("/presets/a.json", "can't write the file: No space left on device"));
    CHECK(messages.take_problem() == "a.json: can't write the file: No space left on device");
    CHECK_FALSE(messages.notice().has_value());
}
