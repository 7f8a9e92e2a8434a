#include "io/system/machine_memory.h"

#include <doctest/doctest.h>

TEST_CASE("the memory of this machine is known") {
    CHECK(machine_memory() > std::uint64_t{16} << 20);
}
