#include "io/system/file_status.h"

#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <sys/stat.h>

namespace fs = std::filesystem;

TEST_CASE("the stamp of a file differs after its content or its name was replaced") {
    const TemporaryFolder folder;
    const fs::path file = folder.write("a", "one");
    const auto first = read_file_stamp(file);
    REQUIRE(first.has_value());
    CHECK(read_file_stamp(file) == first);
    CHECK(first->bytes == 3);

    // The same size and modification time.
    const fs::path other = folder.write("b", "two");
    fs::last_write_time(other, fs::last_write_time(file));
    fs::rename(other, file);
    const auto second = read_file_stamp(file);
    REQUIRE(second.has_value());
    CHECK(second->modified == first->modified);
    CHECK(second != first);
    CHECK(second->newest_seconds() >= second->modified.seconds);
    CHECK_FALSE(read_file_stamp(folder / "missing").has_value());
}

TEST_CASE("a missing file or one without permission is not writable") {
    const TemporaryFolder folder;
    const fs::path file = folder.write("a", "one");
    CHECK(is_writable(file));
    CHECK(is_writable(folder.path()));
    CHECK_FALSE(is_writable(folder / "missing"));
    fs::permissions(file, fs::perms::owner_read);
    CHECK(is_writable(file) == (::geteuid() == 0));  // root may write to every file
}
