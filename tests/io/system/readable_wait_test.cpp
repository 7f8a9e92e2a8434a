#include "io/system/readable_wait.h"

#include <doctest/doctest.h>

#include <array>
#include <thread>

namespace {
struct Pipe {
    Pipe() {
        std::array<int, 2> ends{};
        REQUIRE(::pipe(ends.data()) == 0);
        reader = Descriptor(ends[0]);
        writer = Descriptor(ends[1]);
    }
    Descriptor reader;
    Descriptor writer;
};
}  // namespace

TEST_CASE("a wait ends when data arrives, and again while it is not read") {
    const Pipe pipe;
    const ReadableWait wait(pipe.reader.get());
    REQUIRE(wait.is_possible());
    std::thread writer([&] { CHECK(write_all(pipe.writer.get(), "a")); });
    CHECK(wait.wait());
    CHECK(wait.wait());
    CHECK(wait.pause(std::chrono::milliseconds(1)));
    writer.join();
}

TEST_CASE("another thread ends a wait") {
    const Pipe pipe;
    ReadableWait wait(pipe.reader.get());
    std::thread stopper([&] { wait.stop(); });
    CHECK_FALSE(wait.wait());
    CHECK_FALSE(wait.pause(std::chrono::minutes(10)));
    stopper.join();
}

TEST_CASE("nothing waits for a missing descriptor") {
    CHECK_FALSE(ReadableWait(-1).is_possible());
}
