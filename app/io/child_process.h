#pragma once

#include "base/diagnostic.h"
#include "io/descriptor.h"

#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

/// Another program that was started for its output; ended with its owner.
class ChildProcess {
public:
    /// Starts the program of that name from $PATH with nothing to read. An error without a file:
    /// the program is not installed, or the system has no room for it.
    static Result<ChildProcess> start(const std::vector<std::string>& command);

    ChildProcess(ChildProcess&& other) noexcept;
    ChildProcess& operator=(ChildProcess&& other) noexcept;
    ~ChildProcess();

    /// The next bytes of its output, up to `size`; fewer only at the output's end.
    std::size_t read(char* bytes, std::size_t size);
    /// All that is left of its output, at most `most` bytes.
    std::string read_all(std::size_t most);
    /// The same, but nothing where its output has not ended within so many seconds.
    std::optional<std::string> read_all_within(double seconds, std::size_t most);
    /// Waits for its end; true when it was satisfied.
    bool finish();
    /// What it has said on stderr so far: the first line.
    std::string complaint() const;

private:
    ChildProcess(pid_t process, Descriptor output, Descriptor complaints)
        : m_process(process), m_output(std::move(output)), m_complaints(std::move(complaints)) {}
    void end();

    pid_t m_process = -1;     // -1: has ended
    Descriptor m_output;      // a pipe's end
    Descriptor m_complaints;  // a file in memory, which never makes the program wait
};
