#include "model/picture/frame_rate_fraction.h"

#include <doctest/doctest.h>

TEST_CASE("a frame rate is written as the exact fraction it stands for") {
    CHECK(frame_rate_fraction(60.0).text(':') == "60:1");
    CHECK(frame_rate_fraction(12.5).text('/') == "25/2");
    CHECK(frame_rate_fraction(59.94).text('/') == "2997/50");
    CHECK(frame_rate_fraction(30000.0 / 1001.0).text('/') == "30000/1001");
    CHECK(frame_rate_fraction(29.97002997).text('/') == "30000/1001");
    CHECK(frame_rate_fraction(1000.0).text('/') == "1000/1");
    CHECK(frame_rate_fraction(3.14159265358979).number() ==
          doctest::Approx(3.14159265358979).epsilon(1e-9));
}
