#include "lab/window/source_search.h"

#include <doctest/doctest.h>

TEST_CASE("a search finds every match and ignores case") {
    const std::vector<std::string_view> lines{"vec3 Gain = gain;", "", "again"};
    CHECK(find_matches(lines, "gain") ==
          std::vector<SourceMatch>{{0, 5, 9}, {0, 12, 16}, {2, 1, 5}});
    CHECK(find_matches(lines, "absent").empty());
    CHECK(find_matches(lines, "").empty());
}

TEST_CASE("a search stops at ten thousand matches") {
    const std::string line(30000, 'a');
    CHECK(find_matches({line}, "a").size() == 10000);
}
