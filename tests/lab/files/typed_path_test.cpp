#include "lab/files/typed_path.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

TEST_CASE("a typed text is a name in the folder, or a path") {
    struct Case {
        std::string typed;
        std::filesystem::path folder;
        std::string name;
    };
    for (const auto& [typed, folder, name] :
         {Case{"", "/work/music", ""}, Case{"osci", "/work/music", "osci"},
          Case{"live/a b.wav", "/work/music/live", "a b.wav"}, Case{"../x", "/work", "x"},
          Case{"..", "/work", ""}, Case{".", "/work/music", ""},
          Case{".hid", "/work/music", ".hid"}, Case{"/etc/fonts", "/etc", "fonts"},
          Case{"/", "/", ""}, Case{"/etc/", "/etc", ""}, Case{"~", "/home/me", ""},
          Case{"~/", "/home/me", ""}, Case{"~/films/x", "/home/me/films", "x"},
          Case{"~other", "/work/music", "~other"}, Case{"'/tmp/a b.wav'", "/tmp", "a b.wav"},
          Case{" /tmp/a ", "/tmp", "a"}, Case{"file:///tmp/a%20b.wav", "/tmp", "a b.wav"},
          Case{"../../../../..", "/", ""}, Case{"'", "/work/music", "'"}}) {
        CAPTURE(typed);
        CHECK(parse_typed_path(typed, "/work/music", "/home/me") == TypedPath{folder, name});
    }
}

TEST_CASE("Tab completes as far as the names agree, then takes the first one") {
    const std::vector<FolderEntry> rows{{"Films", true}, {"film.mp4"},  {"filter.glsl"},
                                        {"grün.wav"},    {"grüße.wav"}, {"an osci.wav"}};
    struct Case {
        std::string typed;
        std::string completed;
    };
    for (const auto& [typed, completed] :
         {Case{"fi", "Fil"}, Case{"Fil", "Films/"}, Case{"filt", "filter.glsl"}, Case{"gr", "grü"},
          Case{"sub/filt", "sub/filter.glsl"}, Case{"osc", "an osci.wav"},
          Case{"film.mp4", "film.mp4"}, Case{"none", "none"}, Case{"", ""}, Case{"~", "~/"},
          Case{"..", "../"}, Case{"sub/", "sub/"}, Case{"films", "Films/"}}) {
        CAPTURE(typed);
        CHECK(completed_path(typed, rows) == completed);
    }
}

TEST_CASE("completing stops before a character that differs in its second byte") {
    // U+00FC is C3 BC, U+00F6 is C3 B6.
    CHECK(completed_path("t", {{"tü"}, {"tö"}}) == "tü");  // nothing to add: the first one
    CHECK(completed_path("t", {{"tab ü"}, {"tab ö"}}) == "tab ");
}
