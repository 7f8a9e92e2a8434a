#include "formats/cues/cue_sheet.h"

#include <doctest/doctest.h>

#include <cmath>

namespace {
using Command = Cue::Command;

constexpr const char* cue_show =
    "# My show\n"
    "\n"
    "0:00 preset \"Amber P3\"\n"
    "1:23.5  preset green morph 2   # the drop\n"
    "83.75 parameter decay 0.9 over 1.5\n"
    "1:30 parameter tint 0.1 0.2 0.3\n"
    "2:00 restart\n"
    "1:02:03.25 blackout on\n";

std::vector<Cue> cues_of(const CueSheet& sheet) {
    std::vector<Cue> cues;
    for (const CueLine& line : sheet.lines())
        if (line.cue)
            cues.push_back(*line.cue);
    return cues;
}

CueSheet sheet_of(const char* text) {
    auto sheet = parse_cue_sheet(text, "show.txt");
    if (!sheet)
        FAIL(to_string(sheet.error()));
    return std::move(*sheet);
}

std::string errors_of(const char* text) {
    const auto sheet = parse_cue_sheet(text, "show.txt");
    REQUIRE_FALSE(sheet.has_value());
    return to_string(sheet.error());
}
}  // namespace

TEST_CASE("a cue file has a command at each time") {
    const std::vector<Cue> cues = cues_of(sheet_of(cue_show));
    REQUIRE(cues.size() == 6);
    CHECK(cues[0] == Cue{.seconds = 0.0, .command = Command::preset, .name = "Amber P3"});
    CHECK(cues[1] ==
          Cue{.seconds = 83.5, .command = Command::preset, .name = "green", .over = 2.0});
    CHECK(cues[2] == Cue{.seconds = 83.75,
                         .command = Command::parameter,
                         .name = "decay",
                         .value = "0.9",
                         .over = 1.5});
    CHECK(cues[3].value == "0.1 0.2 0.3");
    CHECK(cues[4].command == Command::restart);
    CHECK(cues[5] == Cue{.seconds = 3723.25, .command = Command::blackout, .is_on = true});
}

TEST_CASE("a file is written back as it was") {
    for (const char* text :
         {cue_show, "", "# no cue", "0:01 restart", "0:01 restart\r\n\r\n# end\r\n",
          "0:01 restart\r\n0:02 restart\n# end", "\uFEFF0:01 restart\n", "\n\n\n"})
        CHECK(sheet_of(text).text() == text);
}

TEST_CASE("an edit changes its own line only, and keeps its comment") {
    CueSheet sheet = sheet_of(cue_show);
    Cue cue = *sheet.lines()[3].cue;
    cue.seconds = 84.0;
    sheet.change(4, cue);
    std::string expected = cue_show;
    const std::string before = "1:23.5  preset green morph 2   # the drop";
    expected.replace(expected.find(before), before.size(),
                     "1:24 preset \"green\" morph 2   # the drop");
    CHECK(sheet.text() == expected);
    sheet.remove(4);
    CHECK(sheet.text().find("the drop") == std::string::npos);
    CHECK(cues_of(sheet).size() == 5);
}

TEST_CASE("a new cue is inserted before the first later one") {
    CueSheet sheet = sheet_of("# a\n0:10 restart\n# b\n0:30 restart");
    sheet.add({.seconds = 20.0, .command = Command::blackout, .is_on = false});
    sheet.add({.seconds = 40.0, .command = Command::restart});
    CHECK(sheet.text() ==
          "# a\n0:10 restart\n# b\n0:20 blackout off\n0:30 restart\n0:40 restart\n");
    CueSheet windows = sheet_of("0:10 restart\r\n");
    windows.add({.seconds = 20.0, .command = Command::restart});
    CHECK(windows.text() == "0:10 restart\r\n0:20 restart\r\n");
}

TEST_CASE("every cue reads back from its text") {
    for (const Cue& cue : std::vector<Cue>{
             {.seconds = 0.0625, .name = "A \"quoted\" \\ name # 1", .over = 0.125},
             {.seconds = 59.999,
             .command = Command::parameter,
             .name = "crt/mask",
             .value = "Slot mask"},
             {.seconds = 60.0,
             .command = Command::parameter,
             .name = "a",
             .value = "over",
             .over = 3.0},
             {.seconds = 3600.0,
             .command = Command::parameter,
             .name = "tint",
             .value = "0.1, 0.2, -3e-05"},
             {.seconds = 3601.0, .command = Command::parameter, .name = "a name # 1", .value = "1"},
             {.seconds = 1.0, .command = Command::blackout, .is_on = false},
             {.seconds = 2.0, .command = Command::restart}}) {
        const auto read = parse_cue(cue_text(cue));
        REQUIRE(read.has_value());
        Cue expected = cue;
        expected.seconds = std::round(cue.seconds * 1000.0) / 1000.0;
        CHECK(*read == expected);
    }
}

TEST_CASE("all errors are reported with their lines") {
    CHECK(errors_of("1:2x restart\n"
                    "1:75 restart\n"
                    "0:01 prest amber\n"
                    "0:01\n"
                    "0:01 preset\n"
                    "# fine\n"
                    "0:01 preset amber over 2\n"
                    "0:01 preset amber morph x\n"
                    "0:01 preset \"amber\n"
                    "0:01 parameter decay\n"
                    "0:01 blackout maybe\n"
                    "0:01 restart now\n"
                    "0:01 parameter \"\" 1\n") ==
          "show.txt:1: error: expected a time up to 24:00:00, such as 1:23.5 or 83.5, got '1:2x'\n"
          "show.txt:2: error: expected a time up to 24:00:00, such as 1:23.5 or 83.5, got '1:75'\n"
          "show.txt:3: error: unknown command 'prest' (did you mean 'preset'?); use one of: "
          "preset, parameter, restart, blackout\n"
          "show.txt:4: error: expected a command after the time: preset, parameter, restart, "
          "blackout\n"
          "show.txt:5: error: expected a preset name, such as preset \"Amber P3\"\n"
          "show.txt:7: error: expected 'morph SECONDS' or the end of the line, got 'over'\n"
          "show.txt:8: error: expected seconds from 0 to 86400 after 'morph', got 'x'\n"
          "show.txt:9: error: missing closing quote (\")\n"
          "show.txt:10: error: expected a parameter and its value, such as parameter decay 0.9\n"
          "show.txt:11: error: expected 'blackout on' or 'blackout off'\n"
          "show.txt:12: error: 'restart' takes no arguments, got 'now'\n"
          "show.txt:13: error: expected a parameter and its value, such as parameter decay 0.9\n");
}

TEST_CASE("times have hours, minutes and seconds") {
    CHECK(parse_cue_time("83.5") == 83.5);
    CHECK(parse_cue_time("1:23.5") == 83.5);
    CHECK(parse_cue_time("1:00:01") == 3601.0);
    for (const char* bad :
         {"", ":", "1:", "-1", "1e3", "nan", "1:2:3:4", "1.5:00", "0:60", "99:59:59"})
        CHECK_FALSE(parse_cue_time(bad).has_value());
    CHECK(cue_time_text(83.5) == "1:23.5");
    CHECK(cue_time_text(59.9999) == "1:00");
    CHECK(cue_time_text(3723.25) == "1:02:03.25");
}

TEST_CASE("a hostile file is refused or read, but never hangs") {
    CHECK_FALSE(parse_cue_sheet(std::string(100'000, '\n'), "a.txt").has_value());
    CHECK_FALSE(parse_cue_sheet(std::string(1'000'000, '"'), "a.txt").has_value());
    CHECK_FALSE(parse_cue_sheet(std::string_view("\0\1\2", 3), "a.txt").has_value());
}
