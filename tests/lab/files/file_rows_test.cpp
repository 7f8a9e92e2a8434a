#include "lab/files/file_rows.h"

#include <doctest/doctest.h>

#include <ctime>
#include <string>

namespace {
std::vector<std::string> names(const std::vector<FolderEntry>& rows) {
    std::vector<std::string> list;
    for (const FolderEntry& row : rows)
        list.push_back(row.name);
    return list;
}

using Names = std::vector<std::string>;

FolderListing listing() {
    return {.folder = "/music",
            .entries = {{"osci.wav", false, 300, 50},
                        {"Zebra", true, 0, 10},
                        {"frame 10.png", false, 10, 40},
                        {"frame 2.png", false, 20, 30},
                        {".cache", true, 0, 60},
                        {"my oscilloscope", true, 0, 20},
                        {"OSCAR.wav", false, 100, 20}},
            .problem = {}};
}
}  // namespace

TEST_CASE("folders come first, names are sorted without case and by the value of numbers") {
    CHECK(names(file_rows(listing(), {})) == Names{"my oscilloscope", "Zebra", "frame 2.png",
                                                   "frame 10.png", "OSCAR.wav", "osci.wav"});
}

TEST_CASE("the typed text lists names that begin with it, then names that contain it") {
    CHECK(names(file_rows(listing(), {.typed = "osc"})) ==
          Names{"OSCAR.wav", "osci.wav", "my oscilloscope"});
    CHECK(names(file_rows(listing(), {.typed = "OSCI"})) == Names{"osci.wav", "my oscilloscope"});
    CHECK(file_rows(listing(), {.typed = "none"}).empty());
}

TEST_CASE("a name that is typed in full, perhaps without its extension, comes first") {
    const FolderListing games{.folder = {},
                              .entries = {{"game over.png", false, 1, 1},
                                          {"game", true, 0, 1},
                                          {"game.png", false, 1, 1},
                                          {"Game.tar.gz", false, 1, 1}},
                              .problem = {}};
    CHECK(names(file_rows(games, {.typed = "game"})) ==
          Names{"game", "game.png", "game over.png", "Game.tar.gz"});
}

TEST_CASE("hidden entries are listed when wanted, or when a dot is typed") {
    CHECK(names(file_rows(listing(), {.shows_hidden = true})).front() == ".cache");
    CHECK(names(file_rows(listing(), {.typed = ".c"})) == Names{".cache"});
    CHECK(names(file_rows(listing(), {.typed = "cache"})).empty());
}

TEST_CASE("files are sorted by size or date, in both directions") {
    using Key = FileOrder::Key;
    const auto sorted = [](Key key, bool is_descending) {
        const Names all = names(file_rows(listing(), {.order = {key, is_descending}}));
        return Names(all.begin() + 2, all.end());  // without the folders
    };
    CHECK(sorted(Key::size, false) ==
          Names{"frame 10.png", "frame 2.png", "OSCAR.wav", "osci.wav"});
    CHECK(sorted(Key::size, true) == Names{"osci.wav", "OSCAR.wav", "frame 2.png", "frame 10.png"});
    CHECK(sorted(Key::modified, true) ==
          Names{"osci.wav", "frame 10.png", "frame 2.png", "OSCAR.wav"});
    CHECK(sorted(Key::name, true) == Names{"osci.wav", "OSCAR.wav", "frame 10.png", "frame 2.png"});
}

TEST_CASE("ten thousand entries are filtered and sorted within a frame") {
    FolderListing large;
    for (int i = 0; i < 10000; ++i)
        large.entries.push_back({"shot " + std::to_string(i * 7919 % 10000) + ".png"});
    const std::clock_t start = std::clock();
    const auto rows = file_rows(large, {.typed = "shot"});
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    CHECK(rows.size() == 10000);
    CHECK(rows[9999].name == "shot 9999.png");
    CHECK(seconds < 0.5);  // in an unoptimised build; about 0.01 s otherwise
}

TEST_CASE("names with numbers have a strict order") {
    CHECK(is_name_before("a2", "a10"));
    CHECK_FALSE(is_name_before("a10", "a2"));
    CHECK(is_name_before("a", "b"));
    CHECK(is_name_before("A1", "b1"));
    CHECK(is_name_before("a", "ab"));
    CHECK(is_name_before("a01", "a1") != is_name_before("a1", "a01"));
    CHECK_FALSE(is_name_before("a1", "a1"));
}

TEST_CASE("sizes have two or three digits and units of 1000") {
    CHECK(file_size_text(0) == "0 B");
    CHECK(file_size_text(999) == "999 B");
    CHECK(file_size_text(1000) == "1.0 KB");
    CHECK(file_size_text(9949) == "9.9 KB");
    CHECK(file_size_text(9950) == "10 KB");
    CHECK(file_size_text(999499) == "999 KB");
    CHECK(file_size_text(999500) == "1.0 MB");
    CHECK(file_size_text(4'200'000'000) == "4.2 GB");
}

TEST_CASE("an unknown date is not shown") {
    CHECK(modified_text(0).empty());
    CHECK(modified_text(1'000'000'000).starts_with("2001-09-"));  // 9 September 2001, UTC
}
