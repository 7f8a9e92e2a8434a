#include "io/system/bounded_child.h"

#include "io/system/descriptor.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {
using Clock = std::chrono::steady_clock;

// Data and stack: the sixth number of /proc/self/statm, in pages.
std::size_t data_bytes() {
    std::ifstream statm("/proc/self/statm");
    std::size_t pages = 0;
    for (int i = 0; i < 6; ++i)
        statm >> pages;
    return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

void limit(int resource, std::size_t maximum) {
    const rlimit bound{maximum, maximum};
    ::setrlimit(static_cast<__rlimit_resource>(resource), &bound);
}

// Exits without the program's cleanup: its objects belong to the parent.
[[noreturn]] void work_in_child(const std::function<std::string()>& work, const ChildBounds& bounds,
                                int output) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGABRT, SIGSEGV, SIGBUS, SIGXCPU})
        ::signal(signal, SIG_DFL);
    if (const int nothing = ::open("/dev/null", O_WRONLY); nothing >= 0)
        ::dup2(nothing, STDERR_FILENO);  // hides messages of libraries
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_DATA, data_bytes() + bounds.memory_bytes);
    limit(RLIMIT_CPU, static_cast<std::size_t>(std::ceil(bounds.seconds)) + 1);
    try {
        write_all(output, work());
    } catch (...) {
        ::_exit(1);
    }
    ::_exit(0);
}

// Reads to the end of the output, or until it exceeds a limit.
ChildOutput::End read_bounded(int input, const ChildBounds& bounds, std::string& text) {
    const auto end = Clock::now() + std::chrono::duration<double>(bounds.seconds);
    std::array<char, 65536> block{};
    while (true) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        pollfd waited{input, POLLIN, 0};
        const int ready = left > 0 ? ::poll(&waited, 1, static_cast<int>(left)) : 0;
        if (ready < 0 && errno == EINTR)
            continue;
        if (ready <= 0)
            return ChildOutput::End::too_slow;
        const ssize_t count = ::read(input, block.data(), block.size());
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0)
            return ChildOutput::End::finished;
        text.append(block.data(), static_cast<std::size_t>(count));
        if (text.size() > bounds.output_bytes)
            return ChildOutput::End::output_too_large;
    }
}

ChildOutput not_started() {
    return {{}, ChildOutput::End::not_started, std::strerror(errno)};
}
}  // namespace

ChildOutput run_bounded(const std::function<std::string()>& work, const ChildBounds& bounds) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        return not_started();
    const pid_t child = ::fork();
    if (child == 0)
        work_in_child(work, bounds, ends[1]);
    const Descriptor input(ends[0]);
    Descriptor output(ends[1]);
    if (child < 0)
        return not_started();
    output = Descriptor();
    ChildOutput made;
    made.end = read_bounded(input.get(), bounds, made.text);
    if (made.end != ChildOutput::End::finished)
        ::kill(child, SIGKILL);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    const bool is_good = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    if (made.end == ChildOutput::End::finished && !is_good)
        made.end = ChildOutput::End::failed;
    return made;
}
