#include "io/system/child_process.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <thread>
#include <utility>

extern char** environ;

namespace {
// Owns a posix_spawn_file_actions_t.
class FileActions {
public:
    FileActions() { posix_spawn_file_actions_init(&m_actions); }
    ~FileActions() { posix_spawn_file_actions_destroy(&m_actions); }
    FileActions(const FileActions&) = delete;
    FileActions& operator=(const FileActions&) = delete;

    void use(int descriptor, int as) {
        posix_spawn_file_actions_adddup2(&m_actions, descriptor, as);
    }
    const posix_spawn_file_actions_t* get() const { return &m_actions; }

private:
    posix_spawn_file_actions_t m_actions{};
};

tl::unexpected<Diagnostics> no_pipe() {
    return fail({{}, 0, fmt::format("can't create a pipe: {}", std::strerror(errno))});
}

struct InputLink {
    Descriptor ours;
    Descriptor theirs;
};

Result<InputLink> make_input() {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
        return no_pipe();
    ::shutdown(ends[0], SHUT_RD);
    return InputLink{Descriptor(ends[0]), Descriptor(ends[1])};
}

// A duplicate with a number above those of the files that the child gets.
Descriptor out_of_the_way(int descriptor) {
    constexpr int first_free = ChildProcess::given_output + 1;
    return Descriptor(descriptor < 0 ? -1 : ::fcntl(descriptor, F_DUPFD_CLOEXEC, first_free));
}

int wait_for(pid_t process) {
    int status = 0;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

// All its threads so far; 0 if it has ended.
double processor_seconds(pid_t process) {
    clockid_t clock{};
    timespec time{};
    if (::clock_getcpuclockid(process, &clock) != 0 || ::clock_gettime(clock, &time) != 0)
        return 0.0;
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::string fault_of(int status) {
    if (WIFSIGNALED(status))
        return fmt::format("stopped by signal {} ({}){}", WTERMSIG(status),
                           ::strsignal(WTERMSIG(status)),
                           WTERMSIG(status) == SIGKILL ? ", possibly out of memory" : "");
    const int code = WEXITSTATUS(status);
    return code == 0 ? "" : fmt::format("exited with status {}", code);
}

// The environment of a child: ours, with some variables added or replaced.
class Environment {
public:
    explicit Environment(std::vector<std::string> more) : m_more(std::move(more)) {
        for (std::string& variable : m_more)
            m_variables.push_back(variable.data());
        for (char** variable = environ; *variable; ++variable)
            if (!is_replaced(*variable))
                m_variables.push_back(*variable);
        m_variables.push_back(nullptr);
    }
    char* const* get() const { return m_variables.data(); }

private:
    bool is_replaced(std::string_view variable) const {
        const std::string_view name = variable.substr(0, variable.find('=') + 1);
        return std::ranges::any_of(
            m_more, [&](const std::string& other) { return other.starts_with(name); });
    }

    std::vector<std::string> m_more;
    std::vector<char*> m_variables;
};
}  // namespace

/// Notices that a child is stuck: it uses no processor time.
class ChildProcess::StallDetector {
public:
    StallDetector(pid_t process, double timeout) : m_process(process), m_timeout(timeout) {}

    /// Call it repeatedly while waiting.
    bool is_stuck() {
        constexpr double idle = 1e-3;  // s, which a waiting process may also use
        const auto now = Clock::now();
        const double used = processor_seconds(m_process);
        if (used - m_used > idle) {
            m_used = used;
            m_last = now;
        }
        return std::chrono::duration<double>(now - m_last).count() > m_timeout;
    }

private:
    using Clock = std::chrono::steady_clock;

    pid_t m_process;
    double m_timeout;
    double m_used = 0.0;
    Clock::time_point m_last = Clock::now();
};

Result<ChildProcess> ChildProcess::start(const std::vector<std::string>& command,
                                         const Files& files) {
    Inputs fed;
    Inputs read;
    for (int i = 0; i < files.inputs; ++i) {
        auto made = make_input();
        if (!made)
            return fail(made.error());
        fed[static_cast<std::size_t>(i)] = std::move(made->ours);
        read[static_cast<std::size_t>(i)] = std::move(made->theirs);
    }
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        return no_pipe();
    Descriptor output(ends[0]);
    const Descriptor input(ends[1]);
    Descriptor complaints(::memfd_create("complaints", MFD_CLOEXEC));
    const Descriptor nothing(::open("/dev/null", O_RDWR | O_CLOEXEC));
    FileActions actions;
    actions.use(read[0].is_open() ? read[0].get() : nothing.get(), STDIN_FILENO);
    actions.use(input.get(), STDOUT_FILENO);
    actions.use(complaints.is_open() ? complaints.get() : nothing.get(), STDERR_FILENO);
    const Descriptor second = out_of_the_way(read[1].get());
    const Descriptor given = out_of_the_way(files.output);
    if (second.is_open())
        actions.use(second.get(), second_input);
    if (given.is_open())
        actions.use(given.get(), given_output);
    std::vector<std::string> words = command;
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    pid_t process = -1;
    const Environment environment(files.environment);
    const int error = ::posix_spawnp(&process, arguments.front(), actions.get(), nullptr,
                                     arguments.data(), environment.get());
    if (error == ENOENT)
        return fail({{}, 0, fmt::format("the program '{}' isn't installed", command.front())});
    if (error != 0)
        return fail(
            {{}, 0, fmt::format("can't start '{}': {}", command.front(), std::strerror(error))});
    return ChildProcess(process, std::move(fed), std::move(output), std::move(complaints));
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : m_process(std::exchange(other.m_process, -1)),
      m_inputs(std::move(other.m_inputs)),
      m_output(std::move(other.m_output)),
      m_complaints(std::move(other.m_complaints)),
      m_timeout(other.m_timeout),
      m_fault(std::move(other.m_fault)) {}

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
    std::swap(m_process, other.m_process);
    m_inputs = std::move(other.m_inputs);
    m_output = std::move(other.m_output);
    m_complaints = std::move(other.m_complaints);
    m_timeout = other.m_timeout;
    m_fault = std::move(other.m_fault);
    return *this;
}

ChildProcess::~ChildProcess() {
    end();
}

void ChildProcess::end() {
    if (m_process < 0)
        return;
    ::kill(m_process, SIGKILL);
    wait_for(std::exchange(m_process, -1));
}

std::size_t ChildProcess::read(char* bytes, std::size_t size) {
    std::size_t done = 0;
    while (done < size) {
        const ssize_t got = ::read(m_output.get(), bytes + done, size - done);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            break;
        done += static_cast<std::size_t>(got);
    }
    return done;
}

std::optional<std::size_t> ChildProcess::read_within(double seconds, char* bytes,
                                                     std::size_t size) {
    pollfd waits{m_output.get(), POLLIN, 0};
    if (::poll(&waits, 1, static_cast<int>(std::ceil(seconds * 1000.0))) <= 0)
        return 0;
    const ssize_t got = ::read(m_output.get(), bytes, size);
    if (got < 0 && errno == EINTR)
        return 0;
    return got <= 0 ? std::nullopt : std::optional(static_cast<std::size_t>(got));
}

std::string ChildProcess::read_all(std::size_t maximum) {
    std::string text(maximum, '\0');
    text.resize(read(text.data(), maximum));
    return text;
}

std::optional<std::string> ChildProcess::read_all_within(double seconds, std::size_t maximum,
                                                         const std::atomic<bool>* is_cancelled) {
    constexpr long between_looks = 100;  // ms
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    std::string text;
    std::array<char, 4096> piece{};
    for (;;) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        pollfd waits{m_output.get(), POLLIN, 0};
        const int ready = ::poll(&waits, 1, static_cast<int>(std::clamp(left, 0L, between_looks)));
        const bool is_over = left <= 0 || (is_cancelled && *is_cancelled);
        if ((ready < 0 && errno == EINTR) || (ready == 0 && !is_over))
            continue;
        if (ready <= 0 || is_over)
            return std::nullopt;
        const ssize_t got =
            ::read(m_output.get(), piece.data(), std::min(piece.size(), maximum - text.size()));
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return text;
        text.append(piece.data(), static_cast<std::size_t>(got));
    }
}

void ChildProcess::set_timeout(double seconds) {
    m_timeout = seconds;
    constexpr timeval between_looks{0, 200'000};
    if (m_inputs[0].is_open())
        ::setsockopt(m_inputs[0].get(), SOL_SOCKET, SO_SNDTIMEO, &between_looks,
                     sizeof between_looks);
}

void ChildProcess::end_stuck() {
    end();
    m_fault = fmt::format("stopped after {} s without progress", format_number(m_timeout));
}

bool ChildProcess::feed(int input, std::string_view bytes) {
    const int descriptor = m_inputs[static_cast<std::size_t>(input)].get();
    std::optional<StallDetector> detector;
    while (!bytes.empty()) {
        const ssize_t sent = ::send(descriptor, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR)
            continue;
        if (sent < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
            if (!detector)
                detector.emplace(m_process, m_timeout);
            if (!detector->is_stuck())
                continue;
            end_stuck();
            return false;
        }
        if (sent <= 0)
            return false;
        detector.reset();
        bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
}

// The status; that of a killed process if it is stuck.
int ChildProcess::wait_for_exit() {
    if (std::isinf(m_timeout))
        return wait_for(std::exchange(m_process, -1));
    constexpr auto between_looks = std::chrono::milliseconds(10);
    StallDetector detector(m_process, m_timeout);
    int status = 0;
    while (::waitpid(m_process, &status, WNOHANG) == 0) {
        if (detector.is_stuck()) {
            end_stuck();
            return SIGKILL;
        }
        std::this_thread::sleep_for(between_looks);
    }
    m_process = -1;
    return status;
}

bool ChildProcess::finish() {
    if (m_process < 0)
        return false;
    const int status = wait_for_exit();
    if (m_fault.empty())
        m_fault = fault_of(status);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::string ChildProcess::complaint() const {
    std::array<char, 512> start{};
    const ssize_t got = ::pread(m_complaints.get(), start.data(), start.size(), 0);
    const std::string_view text(start.data(), got > 0 ? static_cast<std::size_t>(got) : 0);
    const auto lines = split_lines(text);
    std::string line(lines.empty() ? std::string_view() : trim(lines.front()));
    for (char& letter : line)
        if (static_cast<unsigned char>(letter) < ' ')
            letter = ' ';
    return line;
}
