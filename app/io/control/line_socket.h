#pragma once

#include "base/diagnostic.h"
#include "io/system/descriptor.h"

#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>

/// A connection to a socket file of another program that answers in lines of text.
class LineSocket {
public:
    /// Error: no program listens there.
    static Result<LineSocket> connect(const std::filesystem::path& file);

    /// Writes a line. Error: the program closed the connection.
    Result<void> write_line(std::string_view line) const;
    /// The next line, without its end. Error: none within the time, or the connection is closed.
    Result<std::string> read_line(std::chrono::milliseconds longest);

private:
    explicit LineSocket(Descriptor socket) : m_socket(std::move(socket)) {}

    Descriptor m_socket;
    std::string m_read;  // not yet returned
};
