#include "lab/files/folder_listing.h"

#include "io/temporary_folder.h"
#include "lab/files/folder_reader.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace fs = std::filesystem;

namespace {
std::vector<std::string> sorted_names(const FolderListing& listing) {
    std::vector<std::string> names;
    for (const FolderEntry& entry : listing.entries)
        names.push_back(entry.name + (entry.is_folder ? "/" : ""));
    std::ranges::sort(names);
    return names;
}

using Names = std::vector<std::string>;

void wait_for(FolderReader& reader, const FolderRequest& request) {
    reader.update(request);
    while (reader.is_reading()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        reader.update(request);
    }
}
}  // namespace

TEST_CASE("a folder is listed with sizes, dates and hidden entries") {
    const TemporaryFolder folder;
    folder.write("a.wav", "12345");
    folder.write(".hidden.wav", "");
    folder.write("b.txt", "");
    fs::create_directories(folder / "sub.d");
    const FolderListing all = list_folder(folder.path(), {});
    CHECK(all.problem.empty());
    CHECK(all.is_writable);
    CHECK(sorted_names(all) == Names{".hidden.wav", "a.wav", "b.txt", "sub.d/"});
    const FolderListing sounds = list_folder(folder.path(), {".wav"});
    CHECK(sorted_names(sounds) == Names{".hidden.wav", "a.wav", "sub.d/"});
    const auto sound = std::ranges::find(sounds.entries, "a.wav", &FolderEntry::name);
    CHECK(sound->bytes == 5);
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(now).count();
    CHECK(std::abs(sound->modified - seconds) < 60);
}

TEST_CASE("files of other programs with a wanted ending are left out") {
    const TemporaryFolder folder;
    folder.write("look.json", "");
    folder.write("preset.json", R"({"format": "afterglow-preset"})");
    folder.write("shadertoy.json", R"([{"renderpass": []}])");
    folder.write("package.json", R"({"name": "x"})");
    folder.write("CMakeLists.txt", "");
    CHECK(sorted_names(list_folder(folder.path(), {".json", ".txt"})) ==
          Names{"look.json", "preset.json", "shadertoy.json"});
}

TEST_CASE("a folder that can't be read says why") {
    const TemporaryFolder folder;
    const fs::path file = folder.write("file", "");
    CHECK(list_folder(folder / "none", {}).problem == "This folder doesn't exist.");
    CHECK(list_folder(file, {}).problem == "This isn't a folder.");
    CHECK_FALSE(list_folder(folder / "none", {}).is_writable);
    fs::create_symlink(folder / "loop", folder / "loop");
    CHECK(list_folder(folder / "loop", {}).problem.starts_with("Can't read this folder: "));
}

TEST_CASE("the reader lists folders in the background, and filters without reading again") {
    const TemporaryFolder folder;
    folder.write("osci.wav", "");
    folder.write("other.wav", "");
    FolderReader reader;
    FolderRequest request{.folder = folder.path()};
    wait_for(reader, request);
    CHECK(reader.listing().folder == folder.path());
    CHECK(reader.rows().size() == 2);
    request.filter.typed = "osci";
    reader.update(request);
    CHECK_FALSE(reader.is_reading());
    REQUIRE(reader.rows().size() == 1);
    CHECK(reader.rows()[0].name == "osci.wav");

    request.folder = folder / "none";
    wait_for(reader, request);
    CHECK(reader.rows().empty());
    CHECK(reader.listing().problem == "This folder doesn't exist.");

    reader.update(std::nullopt);
    CHECK(reader.listing().folder.empty());
    request = {.folder = folder.path()};
    wait_for(reader, request);
    CHECK(reader.rows().size() == 2);
}
