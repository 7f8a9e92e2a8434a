#include "io/cache/disk_cache.h"

#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <chrono>
#include <vector>

namespace fs = std::filesystem;

namespace {
std::vector<fs::path> files_in(const fs::path& folder) {
    return {fs::directory_iterator(folder), fs::directory_iterator()};
}

void grow_older(const fs::path& file, std::chrono::hours age) {
    fs::last_write_time(file, fs::file_time_type::clock::now() - age);
}
}  // namespace

TEST_CASE("a cached entry is found again, also in a new process") {
    const TemporaryFolder folder;
    const std::string value("light\0and shade", 15);
    {
        DiskCache cache(folder / "a/b", "program 1");
        CHECK_FALSE(cache.find("what").has_value());
        cache.keep("what", value);
        CHECK(cache.find("what") == value);
    }
    DiskCache next(folder / "a/b", "program 1");
    CHECK(next.find("what") == value);
    CHECK_FALSE(next.find("whatever").has_value());
    next.keep("what", "other");
    CHECK(next.find("what") == "other");
}

TEST_CASE("entries of another program version are not found") {
    const TemporaryFolder folder;
    DiskCache(folder.path(), "program 1").keep("what", "light");
    CHECK_FALSE(DiskCache(folder.path(), "program 2").find("what").has_value());
    CHECK(DiskCache(folder.path(), "program 1").find("what") == "light");
}

TEST_CASE("truncated, changed, foreign and empty cache files are ignored") {
    const TemporaryFolder folder;
    DiskCache cache(folder.path(), "program");
    cache.keep("what", "light");
    const fs::path file = files_in(folder.path()).front();
    const std::string whole = content_of(file);
    std::vector<std::string> broken{"", "something else", whole + "!"};
    for (std::size_t size = 0; size < whole.size(); ++size)
        broken.push_back(whole.substr(0, size));
    for (std::size_t at = 0; at < whole.size(); ++at) {
        broken.push_back(whole);
        broken.back()[at] = static_cast<char>(~broken.back()[at]);
    }
    for (const std::string& text : broken) {
        folder.write(file.filename(), text);
        CHECK_FALSE(cache.find("what").has_value());
    }
    cache.keep("what", "light");
    CHECK(cache.find("what") == "light");
}

TEST_CASE("an entry stored under another key is not returned") {
    const TemporaryFolder folder;
    DiskCache cache(folder.path(), "program");
    cache.keep("one", "light");
    const fs::path of_one = files_in(folder.path()).front();
    cache.keep("two", "shade");
    for (const fs::path& file : files_in(folder.path()))
        if (file != of_one)
            fs::copy_file(of_one, file, fs::copy_options::overwrite_existing);
    CHECK(cache.find("one") == "light");
    CHECK_FALSE(cache.find("two").has_value());
}

TEST_CASE("a full disk cache evicts the least recently used entry") {
    const TemporaryFolder folder;
    const std::string value(1000, 'x');
    const std::string mine = folder.write("notes.txt", std::string(50000, '.'));
    DiskCache cache(folder.path(), "program", 5000);
    for (const char* key : {"a", "b", "c"})
        cache.keep(key, value);
    for (const fs::path& file : files_in(folder.path()))
        grow_older(file, std::chrono::hours(48));
    REQUIRE(cache.find("a").has_value());  // is the most recently used now
    for (const char* key : {"d", "e"})
        cache.keep(key, value);
    std::size_t left = 0;
    for (const char* key : {"a", "b", "c", "d", "e"})
        left += cache.find(key) ? 1U : 0U;
    CHECK(left == 4);
    CHECK(cache.find("a").has_value());
    CHECK(cache.find("e").has_value());
    CHECK(fs::exists(mine));
    cache.keep("f", std::string(6000, 'x'));  // larger than the limit
    CHECK_FALSE(cache.find("f").has_value());
}

TEST_CASE("an unwritable cache folder is not an error") {
    const TemporaryFolder folder;
    const fs::path file = folder.write("file", "in the way");
    DiskCache cache(file / "shaders", "program");
    cache.keep("what", "light");
    CHECK_FALSE(cache.find("what").has_value());
    CHECK(content_of(file) == "in the way");
}
