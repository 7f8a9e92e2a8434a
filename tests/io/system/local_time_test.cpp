#include "io/system/local_time.h"

#include <doctest/doctest.h>

#include <initializer_list>

TEST_CASE("a local time converts back to the same moment") {
    for (const std::time_t time : {std::time_t{0}, std::time_t{1700000000}}) {
        std::tm local = local_time(time);
        CHECK(std::mktime(&local) == time);
    }
}
