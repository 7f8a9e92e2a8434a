#include "gpu/driver_cache.h"

#include "io/temporary_folder.h"

#include <doctest/doctest.h>

TEST_CASE("free space of a folder is checked without leaving a file there") {
    const TemporaryFolder folder;
    CHECK(gpu::has_free_space(folder.path(), 4096));
    CHECK(gpu::has_free_space(folder / "not/there/yet", 4096));
    CHECK_FALSE(gpu::has_free_space(folder.path(), std::size_t{1} << 60));
    CHECK(std::filesystem::is_empty(folder.path()));
}
