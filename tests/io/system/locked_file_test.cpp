#include "io/system/locked_file.h"

#include "io/temporary_folder.h"

#include <doctest/doctest.h>

namespace fs = std::filesystem;

TEST_CASE("a locked file keeps its last text, and is unlocked when it is closed") {
    const TemporaryFolder folder;
    const fs::path file = folder / "mark";
    CHECK_FALSE(is_unlocked(file));  // missing
    {
        const LockedFile mark(file);
        REQUIRE(mark.is_open());
        CHECK(mark.replace("a long text"));
        CHECK(mark.replace("short"));
        CHECK_FALSE(is_unlocked(file));
        CHECK_FALSE(LockedFile(file).replace("of another program"));
    }
    CHECK(is_unlocked(file));
    CHECK(content_of(file) == "short");
    CHECK(fs::status(file).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
}

TEST_CASE("a file in a missing folder is not opened") {
    const TemporaryFolder folder;
    const LockedFile mark(folder / "missing/mark");
    CHECK_FALSE(mark.is_open());
    CHECK_FALSE(mark.replace("text"));
    CHECK_FALSE(LockedFile().is_open());
}
