#include "io/system/child_process.h"

#include "io/files/atomic_file.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <fcntl.h>
#include <thread>

TEST_CASE("a child process is fed by two inputs, writes to an open file, and prints output") {
    const TemporaryFolder folder;
    auto file = AtomicFile::create(folder / "made");
    REQUIRE(file.has_value());
    auto started =
        ChildProcess::start({"sh", "-c", "cat <&3 >/dev/fd/4; cat >>/dev/fd/4; echo done"},
                            {.inputs = 2, .output = file->descriptor()});
    REQUIRE(started.has_value());
    ChildProcess& program = *started;
    const std::string much(1000000, 'a');
    std::thread second([&] {
        CHECK(program.feed(1, "second "));
        program.end_input(1);
    });
    CHECK(program.feed(0, much));
    program.end_input(0);
    second.join();
    CHECK(program.read_all(100) == "done\n");
    CHECK(program.finish());
    REQUIRE(file->finish().has_value());
    CHECK(content_of(folder / "made") == "second " + much);
}

TEST_CASE("a child process that stops reading is detected without a signal") {
    auto program = ChildProcess::start({"sh", "-c", "echo no >&2; exit 3"}, {.inputs = 1});
    REQUIRE(program.has_value());
    bool is_connected = true;
    for (int i = 0; i < 1000 && is_connected; ++i)
        is_connected = program->feed(0, std::string(10000, 'a'));
    CHECK_FALSE(is_connected);
    CHECK_FALSE(program->finish());
    CHECK(program->complaint() == "no");
}

TEST_CASE("descriptors of a child process do not collide with those it expects") {
    const TemporaryFolder folder;
    std::vector<Descriptor> taken;  // gives the file and the sockets other descriptors each time
    for (int i = 0; i < 4; ++i) {
        const auto name = folder / std::to_string(i);
        auto file = AtomicFile::create(name);
        REQUIRE(file.has_value());
        auto program = ChildProcess::start({"sh", "-c", "cat <&3 >/dev/fd/4"},
                                           {.inputs = 2, .output = file->descriptor()});
        REQUIRE(program.has_value());
        CHECK(program->feed(1, "sound"));
        program->end_input(1);
        CHECK(program->finish());
        REQUIRE(file->finish().has_value());
        CHECK(content_of(name) == "sound");
        taken.emplace_back(::open("/dev/null", O_RDONLY | O_CLOEXEC));
    }
}

TEST_CASE("a child process that is stuck is ended, one that works is not") {
    auto stuck = ChildProcess::start({"sleep", "600"}, {.inputs = 1});
    REQUIRE(stuck.has_value());
    stuck->set_timeout(0.5);
    bool is_read = true;
    for (int i = 0; i < 1000 && is_read; ++i)
        is_read = stuck->feed(0, std::string(10000, 'a'));
    CHECK_FALSE(is_read);
    CHECK_FALSE(stuck->finish());
    CHECK(stuck->fault() == "stopped after 0.5 s without progress");

    auto waiting = ChildProcess::start({"sleep", "600"}, {.inputs = 1});
    REQUIRE(waiting.has_value());
    waiting->set_timeout(0.5);
    CHECK_FALSE(waiting->finish());
    CHECK(waiting->fault() == "stopped after 0.5 s without progress");

    auto busy = ChildProcess::start(
        {"sh", "-c", "i=0; while [ $i -lt 600000 ]; do i=$((i+1)); done"}, {.inputs = 1});
    REQUIRE(busy.has_value());
    busy->set_timeout(0.4);
    CHECK(busy->finish());
    CHECK(busy->fault() == "");
}

TEST_CASE("the end of a child process has a reason, and its environment can be extended") {
    auto killed = ChildProcess::start({"sh", "-c", "kill -11 $$"});
    REQUIRE(killed.has_value());
    CHECK_FALSE(killed->finish());
    CHECK(killed->fault() == "stopped by signal 11 (Segmentation fault)");
    auto failed = ChildProcess::start({"sh", "-c", "exit 7"});
    REQUIRE(failed.has_value());
    CHECK_FALSE(failed->finish());
    CHECK(failed->fault() == "exited with status 7");
    auto told = ChildProcess::start({"sh", "-c", "echo \"$AFTERGLOW_TEST $HOME\""},
                                    {.environment = {"AFTERGLOW_TEST=a=b", "HOME=/nowhere"}});
    REQUIRE(told.has_value());
    CHECK(told->read_all(100) == "a=b /nowhere\n");
}
