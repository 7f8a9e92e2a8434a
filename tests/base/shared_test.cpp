#include "base/shared.h"

#include "base/line_map.h"

#include <doctest/doctest.h>

#include <vector>

TEST_CASE("a copy of a shared value uses the same memory until one of them changes") {
    Shared<std::vector<int>> one(std::vector<int>{1, 2});
    Shared<std::vector<int>> copy = one;
    CHECK(&*copy == &*one);
    copy.own().push_back(3);
    CHECK(*one == std::vector<int>{1, 2});
    CHECK(*copy == std::vector<int>{1, 2, 3});
    const std::vector<int>* const mine = &*copy;
    copy.own().push_back(4);
    CHECK(&*copy == mine);  // the only owner does not copy
}

TEST_CASE("shared values compare by content, and a default one is empty") {
    CHECK(SharedText("light") == SharedText(std::string("light")));
    CHECK_FALSE(SharedText("light") == SharedText("dark"));
    CHECK(SharedText() == SharedText(""));
    CHECK(SharedText()->empty());
    SharedText text;
    text.own() += "beam";
    CHECK(std::string_view(text) == "beam");
    CHECK(SharedText()->empty());
}

TEST_CASE("lines added to a copy of a line map do not change the original") {
    LineMap map{{"a.frag", 1}};
    LineMap copy = map;
    copy.push_back({"b.frag", 7});
    CHECK(map.size() == 1);
    CHECK(copy.size() == 2);
    CHECK(copy[1] == Location{"b.frag", 7});
}
