#pragma once

#include "base/diagnostic.h"
#include "io/files/descriptor.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

/// Another program that was started for what it writes or makes; ended with its owner.
class ChildProcess {
public:
    /// What a program gets besides its words.
    struct Files {
        int inputs = 0;   // that it is fed: none, its standard input, or second_input too
        int output = -1;  // a file that it finds as given_output; -1: none
    };
    static constexpr int second_input = 3;
    static constexpr int given_output = 4;

    /// Starts the program of that name from $PATH. An error without a file: the program is not
    /// installed, or the system has no room for it.
    static Result<ChildProcess> start(const std::vector<std::string>& command, Files files);
    static Result<ChildProcess> start(const std::vector<std::string>& command) {
        return start(command, {0, -1});
    }

    ChildProcess(ChildProcess&& other) noexcept;
    ChildProcess& operator=(ChildProcess&& other) noexcept;
    ~ChildProcess();

    /// The next bytes of its output, up to `size`; fewer only at the output's end.
    std::size_t read(char* bytes, std::size_t size);
    /// All that is left of its output, at most `most` bytes.
    std::string read_all(std::size_t most);
    /// The same, but nothing where its output has not ended within so many seconds.
    std::optional<std::string> read_all_within(double seconds, std::size_t most);
    /// Feeds one of its inputs, from 0, and waits while it has enough; false where it reads no
    /// more. Each on a thread of its own, if need be.
    bool feed(int input, std::string_view bytes) const;
    /// There is no more of this input.
    void end_input(int input) { m_inputs[static_cast<std::size_t>(input)] = Descriptor(); }
    /// Ends it at once, if it has not ended.
    void end();
    /// Waits for its end; true when it was satisfied.
    bool finish();
    /// What it has said on stderr so far: the first line.
    std::string complaint() const;

private:
    using Inputs = std::array<Descriptor, 2>;

    ChildProcess(pid_t process, Inputs inputs, Descriptor output, Descriptor complaints)
        : m_process(process),
          m_inputs(std::move(inputs)),
          m_output(std::move(output)),
          m_complaints(std::move(complaints)) {}

    pid_t m_process = -1;     // -1: has ended
    Inputs m_inputs;          // sockets, which end nobody by a signal
    Descriptor m_output;      // a pipe's end
    Descriptor m_complaints;  // a file in memory, which never makes the program wait
};
