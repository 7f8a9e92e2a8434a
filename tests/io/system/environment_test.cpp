#include "io/system/environment.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <string>

TEST_CASE("a variable of the environment is set, replaced and removed") {
    constexpr const char* name = "AFTERGLOW_TEST_VARIABLE";
    set_environment(name, "1");
    set_environment(name, "2");
    REQUIRE(std::getenv(name) != nullptr);
    CHECK(std::string(std::getenv(name)) == "2");
    CHECK(unset_environment(name));
    CHECK(std::getenv(name) == nullptr);
    CHECK_FALSE(unset_environment("A=B"));
}
