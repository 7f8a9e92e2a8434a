#include "model/look/stack_size.h"

#include <doctest/doctest.h>

TEST_CASE("a stack has at most 64 looks") {
    std::string looks = "crt";
    CHECK(fault_of_stack_size(looks).empty());
    for (int i = 1; i < 64; ++i)
        looks += "+crt";
    CHECK(fault_of_stack_size(looks).empty());
    CHECK(fault_of_stack_size(looks + "+crt") == "the stack has 65 looks; the limit is 64");
    CHECK_FALSE(fault_of_stack_size(std::string(20'000, '+')).empty());
}
