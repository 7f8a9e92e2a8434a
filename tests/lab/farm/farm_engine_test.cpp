#include "lab/farm/farm_engine.h"

#include <doctest/doctest.h>

#include <algorithm>

TEST_CASE("a film is split into parts, and the last one can be shorter") {
    const std::vector<FarmPart> parts = split(30, 100, 30);
    REQUIRE(parts.size() == 3);
    CHECK(parts[0] == FarmPart{30, 60, {}});
    CHECK(parts[1] == FarmPart{60, 90, {}});
    CHECK(parts[2] == FarmPart{90, 100, {}});
    CHECK(split(0, 30, 30).size() == 1);
}

TEST_CASE("words with special characters are quoted for the shell") {
    CHECK(shell_quoted("audio:song.flac,mode=xy") == "audio:song.flac,mode=xy");
    CHECK(shell_quoted("") == "''");
    CHECK(shell_quoted("a b") == "'a b'");
    CHECK(shell_quoted("$(reboot)") == "'$(reboot)'");
    CHECK(shell_quoted("it's") == "'it'\\''s'");
}

TEST_CASE("every engine has one executable run, and the scripts of the parts") {
    const FarmWork work{.name = "film",
                        .directory = "/",
                        .command = {"afterglow", "render", "crt"},
                        .parts = split(0, 4, 2),
                        .join = {"afterglow", "render", "crt", "--output", "film.mp4"}};
    for (const FarmEngine& engine : farm_engines()) {
        CAPTURE(engine.name);
        const auto files = farm_files(work, engine);
        for (const char* name : {"run", "part", "join"})
            CHECK(std::ranges::count_if(files, [&](const FarmFile& file) {
                      return file.name == name && file.is_executable;
                  }) == 1);
    }
}
