#include "io/system/bounded_child.h"

#include <doctest/doctest.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <thread>

namespace {
constexpr ChildBounds bounds{
    .seconds = 20.0, .memory_bytes = std::size_t{1} << 30, .output_bytes = std::size_t{1} << 20};
using End = ChildOutput::End;
}  // namespace

TEST_CASE("work in a child process returns its text and changes nothing here") {
    int count = 0;
    const ChildOutput made = run_bounded(
        [&] {
            ++count;
            return std::string(500000, 'a');
        },
        bounds);
    CHECK(made.end == End::finished);
    CHECK(made.text == std::string(500000, 'a'));
    CHECK(count == 0);
}

TEST_CASE("a crash or an exception in the child ends only the child") {
    CHECK(run_bounded([] { return std::raise(SIGSEGV) == 0 ? "" : "no"; }, bounds).end ==
          End::failed);
    CHECK(run_bounded([]() -> std::string { throw std::runtime_error("no"); }, bounds).end ==
          End::failed);
}

TEST_CASE("a child that exceeds its time or output is killed") {
    ChildBounds few = bounds;
    few.seconds = 0.1;
    const auto sleep = [] {
        std::this_thread::sleep_for(std::chrono::minutes(10));
        return std::string();
    };
    CHECK(run_bounded(sleep, few).end == End::too_slow);
    few = bounds;
    few.output_bytes = 10;
    CHECK(run_bounded([] { return std::string(5000000, 'a'); }, few).end == End::output_too_large);
}
