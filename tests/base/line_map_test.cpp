#include "base/line_map.h"

#include <doctest/doctest.h>

TEST_CASE("consecutive lines of one file are stored as one stretch") {
    LineMap lines;
    lines.push_back({"a.frag", 1});
    lines.push_back({"a.frag", 2});
    lines.append({"a.frag", 3}, 7);
    CHECK(lines.size() == 9);
    CHECK(lines.stretches().size() == 1);
    CHECK(lines[8] == Location{"a.frag", 9});
}

TEST_CASE("an include, a gap and a repeated line each start a new stretch") {
    LineMap lines;
    lines.append({"a.frag", 1}, 2);
    lines.append({"b.inc", 1}, 3);
    lines.append({"a.frag", 3}, 1);
    lines.append({"a.frag", 3}, 1);
    lines.append({"a.frag", 9}, 1);
    lines.append({"c.inc", 1}, 0);
    CHECK(lines.stretches().size() == 5);
    CHECK(lines == LineMap{{"a.frag", 1},
                           {"a.frag", 2},
                           {"b.inc", 1},
                           {"b.inc", 2},
                           {"b.inc", 3},
                           {"a.frag", 3},
                           {"a.frag", 3},
                           {"a.frag", 9}});
    CHECK(lines[1] == Location{"a.frag", 2});
    CHECK(lines[2] == Location{"b.inc", 1});
    CHECK(lines[4] == Location{"b.inc", 3});
    CHECK(lines[6] == Location{"a.frag", 3});
    CHECK(lines[7] == Location{"a.frag", 9});
}

TEST_CASE("an empty line map has no stretches") {
    CHECK(LineMap{}.empty());
    CHECK(LineMap{}.size() == 0);
    CHECK(LineMap{} == LineMap{});
}
