#include "model/picture/film_rate.h"

#include <doctest/doctest.h>

TEST_CASE("a frame rate is written as the exact fraction it stands for") {
    CHECK(film_rate_of(60.0).text(':') == "60:1");
    CHECK(film_rate_of(12.5).text('/') == "25/2");
    CHECK(film_rate_of(59.94).text('/') == "2997/50");
    CHECK(film_rate_of(30000.0 / 1001.0).text('/') == "30000/1001");
    CHECK(film_rate_of(29.97002997).text('/') == "30000/1001");
    CHECK(film_rate_of(1000.0).text('/') == "1000/1");
    CHECK(film_rate_of(3.14159265358979).number() ==
          doctest::Approx(3.14159265358979).epsilon(1e-9));
}
