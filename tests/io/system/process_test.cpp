#include "io/system/process.h"

#include "io/system/child_process.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <cerrno>
#include <chrono>
#include <thread>

namespace fs = std::filesystem;

TEST_CASE("the program finds its own file and starts itself again") {
    CHECK(program_file().filename() == "io_tests");
    CHECK(process_id() > 0);
    auto again = ChildProcess::start({program_command(), "--help"});
    REQUIRE(again.has_value());
    CHECK(again->read_all(100000).find("doctest") != std::string::npos);
}

TEST_CASE("a detached program runs on its own, and a missing one is an error") {
    const TemporaryFolder folder;
    const fs::path file = folder / "made";
    CHECK(start_detached({"sh", "-c", "echo done >'" + file.string() + "'"}) == 0);
    const auto start = std::chrono::steady_clock::now();
    while ((!fs::exists(file) || fs::file_size(file) == 0) &&
           std::chrono::steady_clock::now() - start < std::chrono::seconds(20))
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    CHECK(content_of(file) == "done\n");
    CHECK(start_detached({"afterglow-missing-program"}) == ENOENT);
}
