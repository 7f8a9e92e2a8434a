#include "model/devices/date.h"

#include <doctest/doctest.h>

TEST_CASE("adding seconds to a date crosses midnights, leap days and years") {
    CHECK(date_after({2000, 1, 1, 0.0}, 59.5) == Date{2000, 1, 1, 59.5});
    CHECK(date_after({2000, 2, 28, 86399.0}, 2.0) == Date{2000, 2, 29, 1.0});
    CHECK(date_after({2001, 2, 28, 0.0}, 86400.0) == Date{2001, 3, 1, 0.0});
    CHECK(date_after({1999, 12, 31, 86399.0}, 1.0) == date_of_renders);
    CHECK(date_after(date_of_renders, 366.0 * 86400.0) == Date{2001, 1, 1, 0.0});
    CHECK(date_after(date_of_renders, -1.0) == Date{1999, 12, 31, 86399.0});
}
