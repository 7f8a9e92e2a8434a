#include "base/diagnostic.h"

#include <doctest/doctest.h>

TEST_CASE("repeated diagnostics are listed once, and at most 256 warnings are kept") {
    Diagnostics all{{"a.frag", 1, "first"}};
    add_new(all, {{"a.frag", 1, "first"}, {"b.frag", 1, "first"}});
    CHECK(all.size() == 2);
    for (int line = 2; line < 5000; ++line)
        add_new(all, {"a.frag", line, "again", Severity::warning});
    REQUIRE(all.size() == 2 + 256 + 1);
    CHECK(to_string(all.back()) ==
          "a.frag: warning: more than 256 warnings; only the first 256 are listed");
    add_new(all, {"a.frag", 5000, "an error behind many warnings"});
    CHECK(all.back().severity == Severity::error);
}
