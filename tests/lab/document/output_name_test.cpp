#include "lab/document/output_name.h"

#include "io/temporary_folder.h"
#include "lab/document/opened_preset.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>

namespace fs = std::filesystem;

TEST_CASE("a default name has the look, the preset and the date") {
    Look look;
    look.id = "phosphor+crt";
    Document document(look);
    CHECK(output_stem(document, {2026, 3, 7}) == "phosphor+crt-2026-03-07");
    opened_preset(document).identity.name = "Amber P3 (mine) / Ä";
    opened_preset(document).file = "amber.json";
    CHECK(output_stem(document, {2026, 11, 26}) == "phosphor+crt-amber-p3-mine-2026-11-26");
}

TEST_CASE("a default name is that of no other file") {
    const TemporaryFolder folder;
    CHECK(unused_name(folder.path(), "a", ".mp4") == "a.mp4");
    std::ofstream(folder / "a.mp4") << "x";
    std::ofstream(folder / "a-2.mp4") << "x";
    CHECK(unused_name(folder.path(), "a", ".mp4") == "a-3.mp4");
    CHECK(unused_name(folder.path(), "a", ".mov") == "a.mov");
    CHECK(unused_name(folder.path(), "a", ".mp4", [&](const fs::path& file) {
              return file == folder / "a-3.mp4";
          }) == "a-4.mp4");
    CHECK(unused_name(folder.path(), "b", "_%04d.png") == "b_%04d.png");
    std::ofstream(folder / "b_0600.png") << "x";
    CHECK(unused_name(folder.path(), "b", "_%04d.png") == "b-2_%04d.png");
}

TEST_CASE("a typed name is in the folder, a typed path is where it says") {
    CHECK(typed_file("a.mp4", "/films") == "/films/a.mp4");
    CHECK(typed_file("  ../a.mp4 ", "/films/old") == "/films/a.mp4");
    CHECK(typed_file("/b/a.mp4", "/films") == "/b/a.mp4");
    CHECK(has_own_folder(" /b/a.mp4"));
    CHECK(has_own_folder("~/a.mp4"));
    CHECK(!has_own_folder("b/a.mp4"));
    const char* const home = std::getenv("HOME");
    if (home)
        CHECK(typed_file("~/a.mp4", "/films") == fs::path(home) / "a.mp4");
}
