#include "lab/document/automation_file.h"

#include "formats/preset/sample_preset.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>

namespace {
std::string errors_of(const std::string& text) {
    const auto points = parse_automation(text, "a.txt", sample_look());
    REQUIRE_FALSE(points.has_value());
    return to_string(points.error());
}
}  // namespace

TEST_CASE("automation consists of lines with seconds, a name and a value as typed") {
    const AutomationPoints points{{0.0, "decay", Value(0.5)},
                                  {0.25, "beam_color", Value({0.1, 0.2, 0.3})},
                                  {0.25, "tone_map", Value(2.0)},
                                  {1.5, "as_written", Value(1.0)}};
    const std::string text =
        "# Automation of phosphor: seconds name value\n"
        "0.000000 decay 0.5\n"
        "0.250000 beam_color 0.1,0.2,0.3\n"
        "0.250000 tone_map ACES\n"
        "1.500000 as_written true\n";
    CHECK(automation_text(points, sample_look()) == text);
    CHECK(parse_automation(text, "a.txt", sample_look()) == points);
    CHECK(parse_automation("\r\n  0\tdecay   0.5 \r\n#1 x\n0.25 beam_color 0.1, 0.2, 0.3", "a.txt",
                           sample_look()) == AutomationPoints{points[0], points[1]});
}

TEST_CASE("all mistakes in automation are reported at their lines") {
    CHECK(errors_of("0 decay 0.5\n"
                    "1 decai 0.5\n"
                    "x decay 0.5\n"
                    "2 decay\n"
                    "3 decay 1.5\n"
                    "2.5 decay 0.5\n"
                    "2 decay 0.5\n"
                    "4 tone_map Wild\n"
                    "-1 decay 0\n"
                    "5 noise a.png\n") ==
          "a.txt:2: error: 'phosphor' has no parameter 'decai' (did you mean 'decay'?)\n"
          "a.txt:3: error: expected 'seconds name value'\n"
          "a.txt:4: error: expected 'seconds name value'\n"
          "a.txt:5: error: 'decay' must be between 0 and 1, got 1.5\n"
          "a.txt:7: error: 2 s is earlier than 2.5 s on the line above\n"
          "a.txt:8: error: 'tone_map' must be one of 'Clamp', 'Reinhard', 'ACES', got 'Wild'\n"
          "a.txt:9: error: expected 'seconds name value'\n"
          "a.txt:10: error: 'noise' is a file and can't be automated\n");
    const TemporaryFolder folder;
    CHECK_FALSE(load_automation(folder / "none.txt", sample_look()).has_value());
}
