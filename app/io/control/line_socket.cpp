#include "io/control/line_socket.h"

#include <cerrno>
#include <cstring>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <system_error>

Result<LineSocket> LineSocket::connect(const std::filesystem::path& file) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string& name = file.native();
    if (name.size() >= sizeof address.sun_path)
        return fail({file, 0, "is too long for a socket"});
    std::memcpy(address.sun_path, name.c_str(), name.size() + 1);
    Descriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
    if (!socket.is_open() ||
        ::connect(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
        return fail({file, 0, std::generic_category().message(errno)});
    return LineSocket(std::move(socket));
}

Result<void> LineSocket::write_line(std::string_view line) const {
    std::string rest = std::string(line) + "\n";
    while (!rest.empty()) {
        // Without a signal if the program has gone.
        const auto count = ::send(m_socket.get(), rest.data(), rest.size(), MSG_NOSIGNAL);
        if (count < 0 && errno != EINTR)
            return fail({{}, 0, std::generic_category().message(errno)});
        rest.erase(0, count < 0 ? 0 : static_cast<std::size_t>(count));
    }
    return {};
}

Result<std::string> LineSocket::read_line(std::chrono::milliseconds longest) {
    constexpr std::size_t most_bytes = 1 << 20;
    const auto end = std::chrono::steady_clock::now() + longest;
    while (true) {
        if (const std::size_t line_end = m_read.find('\n'); line_end != m_read.npos) {
            std::string line = m_read.substr(0, line_end);
            m_read.erase(0, line_end + 1);
            return line;
        }
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
            end - std::chrono::steady_clock::now());
        pollfd wanted{m_socket.get(), POLLIN, 0};
        if (left.count() <= 0 || ::poll(&wanted, 1, static_cast<int>(left.count())) <= 0)
            return fail({{}, 0, "no answer"});
        char buffer[4096];
        const auto count = ::recv(m_socket.get(), buffer, sizeof buffer, 0);
        if (count <= 0 || m_read.size() > most_bytes)
            return fail({{}, 0, "the connection was closed"});
        m_read.append(buffer, static_cast<std::size_t>(count));
    }
}
