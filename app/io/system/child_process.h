#pragma once

#include "base/diagnostic.h"
#include "io/system/descriptor.h"

#include <array>
#include <atomic>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

/// A child process that is started for its output; the destructor kills it.
class ChildProcess {
public:
    /// What the child gets besides its arguments.
    struct Files {
        int inputs = 0;   // 0, 1 (its standard input) or 2 (also second_input)
        int output = -1;  // a file that it gets as given_output; -1: no file
        std::vector<std::string> environment = {};  // variables in addition to ours: "NAME=VALUE"
    };
    static constexpr int second_input = 3;
    static constexpr int given_output = 4;

    /// Starts a program from $PATH. Errors have no file: the program is not installed, or the
    /// system lacks resources.
    static Result<ChildProcess> start(const std::vector<std::string>& command, const Files& files);
    static Result<ChildProcess> start(const std::vector<std::string>& command) {
        return start(command, Files());
    }

    ChildProcess(ChildProcess&& other) noexcept;
    ChildProcess& operator=(ChildProcess&& other) noexcept;
    ~ChildProcess();

    /// Reads the next bytes of its output, up to `size`; fewer only at the end of the output.
    std::size_t read(char* bytes, std::size_t size);
    /// Reads the bytes that it has written, up to `size`. Waits at most `seconds` for the first
    /// one; 0: none came. nullopt: the output has ended.
    std::optional<std::size_t> read_within(double seconds, char* bytes, std::size_t size);
    /// Reads the remaining output, at most `maximum` bytes.
    std::string read_all(std::size_t maximum);
    /// As read_all; nullopt if the output has not ended within `seconds`, or when cancelled.
    std::optional<std::string> read_all_within(double seconds, std::size_t maximum,
                                               const std::atomic<bool>* is_cancelled = nullptr);
    /// Ends a child that uses no processor time for this long, while feed(0) or finish() waits.
    void set_timeout(double seconds);
    /// Writes to one of its inputs, from 0, and blocks while its buffer is full. False if the child
    /// no longer reads it. Each input may be fed from its own thread.
    bool feed(int input, std::string_view bytes);
    /// Closes an input.
    void end_input(int input) { m_inputs[static_cast<std::size_t>(input)] = Descriptor(); }
    /// Kills it if it is still running.
    void end();
    /// Waits for it to exit; true if the exit status is 0.
    bool finish();
    /// The first line of its stderr so far.
    std::string complaint() const;
    /// Why it failed; empty after exit status 0: "stopped by signal 9 (Killed)".
    const std::string& fault() const { return m_fault; }

private:
    class StallDetector;
    void end_stuck();
    int wait_for_exit();
    using Inputs = std::array<Descriptor, 2>;

    ChildProcess(pid_t process, Inputs inputs, Descriptor output, Descriptor complaints)
        : m_process(process),
          m_inputs(std::move(inputs)),
          m_output(std::move(output)),
          m_complaints(std::move(complaints)) {}

    pid_t m_process = -1;     // -1: has exited
    Inputs m_inputs;          // sockets: a failed write raises no signal
    Descriptor m_output;      // read end of a pipe
    Descriptor m_complaints;  // a file in memory, so the child never blocks on stderr
    double m_timeout = std::numeric_limits<double>::infinity();
    std::string m_fault;
};
