#include "io/files/scoped_file.h"

#include "io/files/atomic_file.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <csignal>
#include <memory>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace {
// Runs a child process that holds `files` one after the other, each created before the previous one
// is released. Then `signal` ends it. Returns the signal that ended it.
int ended_by(int signal, const std::vector<fs::path>& files) {
    const pid_t child = ::fork();
    if (child == 0) {
        (void)std::signal(signal, SIG_DFL);  // replaces the handler of the test program
        std::unique_ptr<ScopedFile> held;
        for (const fs::path& file : files)
            held = std::make_unique<ScopedFile>(file);
        (void)std::raise(signal);
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}
}  // namespace

TEST_CASE("a transient file is removed when a signal ends the process, also after an earlier one") {
    const TemporaryFolder folder;
    const fs::path first = folder.path() / "first";
    const fs::path second = folder.path() / "second";
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        CAPTURE(signal);
        REQUIRE(write_atomically(first, "").has_value());
        REQUIRE(write_atomically(second, "").has_value());
        CHECK(ended_by(signal, {first, second}) == signal);
        CHECK_FALSE(fs::exists(first));
        CHECK_FALSE(fs::exists(second));
    }
}
