#include "lab/window/look_list.h"

#include "lab/window/search_words.h"

#include <doctest/doctest.h>

namespace {
std::vector<ListedLook> looks() {
    return {{{"crt", "/data/shaders/crt", true}, "CRT", "Scanlines.", {}},
            {{"phosphor", "/data/shaders/phosphor", true}, "Phosphor", "A tube.", {}},
            {{"phosphor+crt", {}, false}, "Phosphor + CRT", "A stack of looks.", {}}};
}
}  // namespace

TEST_CASE("a search finds all words in any case and order") {
    CHECK(has_search_words("Amber P3, slow", "p3 AMBER"));
    CHECK(has_search_words("anything", ""));
    CHECK_FALSE(has_search_words("Amber P3", "amber p4"));
}

TEST_CASE("matching looks keep their order") {
    const std::vector<ListedLook> all = looks();
    const auto found = matching_looks(all, "crt");
    REQUIRE(found.size() == 2);
    CHECK(found[0]->name == "CRT");
    CHECK(found[1]->name == "Phosphor + CRT");
    CHECK(matching_looks(all, "tube").size() == 1);
}

TEST_CASE("recent looks leave out the open one and name those that are not listed by their file") {
    const std::vector<ListedLook> all = looks();
    const auto recent = recent_looks(
        {"/data/shaders/phosphor", "/data/shaders/crt", "/other/two.slangp", "phosphor+crt"}, all,
        "/data/shaders/phosphor");
    REQUIRE(recent.size() == 3);
    CHECK(recent[0].name == "CRT");
    CHECK(recent[1].name == "two.slangp");
    CHECK(recent[1].argument == "/other/two.slangp");
    CHECK(recent[2].name == "Phosphor + CRT");
    CHECK(recent_looks(std::vector<std::string>(20, "/a"), all, "").size() == 10);
}
