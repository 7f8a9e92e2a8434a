#include "io/files/atomic_folder.h"

#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace {
long entries_of(const fs::path& folder) {
    return std::ranges::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

void write(const fs::path& file, const char* text) {
    std::ofstream(file) << text;
}
}  // namespace

TEST_CASE("a folder replaces its target as a whole, and nothing else remains") {
    const TemporaryFolder folder;
    folder.write("out/old.txt", "old");
    folder.write("out.new/mine.txt", "mine");
    folder.write("out.old/mine.txt", "mine");
    auto made = AtomicFolder::create(folder / "out/");
    REQUIRE(made.has_value());
    write(made->path() / "new.txt", "new");
    CHECK(content_of(folder / "out/old.txt") == "old");
    REQUIRE(made->finish().has_value());
    { const AtomicFolder ended(std::move(*made)); }
    CHECK(content_of(folder / "out/new.txt") == "new");
    CHECK(!fs::exists(folder / "out/old.txt"));
    CHECK(content_of(folder / "out.new/mine.txt") == "mine");
    CHECK(content_of(folder / "out.old/mine.txt") == "mine");
    CHECK(entries_of(folder.path()) == 3);
}

TEST_CASE("an unfinished folder leaves the target as it was") {
    const TemporaryFolder folder;
    folder.write("out/old.txt", "old");
    {
        const auto made = AtomicFolder::create(folder / "out");
        REQUIRE(made.has_value());
        write(made->path() / "new.txt", "new");
    }
    CHECK(content_of(folder / "out/old.txt") == "old");
    CHECK(entries_of(folder.path()) == 1);
}

TEST_CASE("missing parents are created, and a parent that is a file is reported") {
    const TemporaryFolder folder;
    {
        auto made = AtomicFolder::create(folder / "a/b/out");
        REQUIRE(made.has_value());
        REQUIRE(made->finish().has_value());
    }
    CHECK(fs::is_directory(folder / "a/b/out"));
    CHECK((fs::status(folder / "a/b/out").permissions() & fs::perms::group_read) ==
          (fs::status(folder / "a").permissions() & fs::perms::group_read));
    folder.write("file", "");
    const auto made = AtomicFolder::create(folder / "file/out");
    REQUIRE(!made.has_value());
    CHECK(made.error().front().file == folder / "file/out");
}
