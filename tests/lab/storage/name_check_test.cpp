#include "lab/storage/name_check.h"

#include <doctest/doctest.h>

#include <array>
#include <string>

namespace {
struct Case {
    std::string typed;
    bool is_valid;
    std::string suggestion = {};
};
}  // namespace

TEST_CASE("preset names that are not valid on every file system get a valid suggestion") {
    const std::string hundred(100, 'x');
    for (const auto& [typed, is_valid, suggestion] :
         {Case{"Amber P3 (mine) +2", true}, Case{"Grün 31.5_b", true}, Case{hundred, true},
          Case{"a/b", false, "a-b"}, Case{"../../etc", false, "etc"},
          Case{".hidden", false, "hidden"}, Case{" spaces ", false, "spaces"},
          Case{"what?*", false, "what"}, Case{"tab\there", false, "tab-here"},
          Case{"///", false, ""}, Case{hundred + "y", false, hundred}}) {
        CAPTURE(typed);
        const NameCheck check = check_preset_name(typed);
        CHECK(check.is_valid == is_valid);
        CHECK(check.problem.empty() == is_valid);
        CHECK(check.suggestion == suggestion);
        if (!suggestion.empty())
            CHECK(check_preset_name(suggestion).is_valid);
    }
}

TEST_CASE("the folder name of a look is lowercase") {
    for (const auto& [typed, is_valid, suggestion] :
         {Case{"my-look_2", true}, Case{"2nd", true}, Case{"My Look", false, "my-look"},
          Case{"a+b", false, "a-b"}, Case{"../x", false, "x"}, Case{"-x", false, "x"},
          Case{"Glow!!", false, "glow"}, Case{"ß", false, ""}}) {
        CAPTURE(typed);
        const NameCheck check = check_look_id(typed);
        CHECK(check.is_valid == is_valid);
        CHECK(check.suggestion == suggestion);
        if (!suggestion.empty())
            CHECK(check_look_id(suggestion).is_valid);
    }
}

TEST_CASE("an empty name is not valid and needs no explanation") {
    const std::array extensions{std::string(".png")};
    CHECK(check_preset_name("") == NameCheck{});
    CHECK(check_look_id("") == NameCheck{});
    CHECK(check_file_name("", {.extensions = extensions}) == NameCheck{});
}

TEST_CASE("a long name is cut between characters") {
    std::string name(99, 'x');
    name += "ü";  // 101 bytes
    CHECK(valid_preset_name(name) == std::string(99, 'x'));
}

TEST_CASE("a file to save has one of the extensions, or gets the first") {
    const std::array extensions{std::string(".png"), std::string(".exr")};
    const FileNameRule rule{extensions, "Pictures"};
    CHECK(with_extension("a", rule) == "a.png");
    CHECK(with_extension("a.EXR", rule) == "a.EXR");
    const std::string longest(251, 'x');  // 255 bytes with ".png"
    for (const auto& [typed, is_valid, suggestion] :
         {Case{"a", true}, Case{"a.png", true}, Case{"a.EXR", true}, Case{"frame_%04d.png", true},
          Case{"a.jpg", false, "a.png"}, Case{"take 1.2", false, "take 1.2.png"},
          Case{"v1.final cut", false, "v1.final cut.png"}, Case{longest, true},
          Case{longest + "y", false, longest + ".png"}, Case{"..", false, ""}}) {
        CAPTURE(typed);
        const NameCheck check = check_file_name(typed, rule);
        CHECK(check.is_valid == is_valid);
        CHECK(check.suggestion == suggestion);
        if (!suggestion.empty())
            CHECK(check_file_name(suggestion, rule).is_valid);
    }
    CHECK(check_file_name("a.jpg", rule).problem == "Pictures are saved as .png or .exr.");
}
