#include "io/system/standard_streams.h"

#include "io/system/descriptor.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <fcntl.h>

TEST_CASE("a file or a closed descriptor is not a terminal") {
    const TemporaryFolder folder;
    const Descriptor file(::open(folder.write("a", "").c_str(), O_RDONLY | O_CLOEXEC));
    REQUIRE(file.is_open());
    CHECK_FALSE(is_terminal(file.get()));
    CHECK_FALSE(is_terminal(-1));
}
