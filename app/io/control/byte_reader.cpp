#include "io/control/byte_reader.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <utility>

namespace fs = std::filesystem;

namespace {
tl::unexpected<Diagnostics> cannot(const fs::path& path, const std::string& what) {
    return fail({path, 0, what + ": " + std::strerror(errno)});
}

const sockaddr* general(const sockaddr_un& address) {
    return reinterpret_cast<const sockaddr*>(&address);
}

// `name` must fit in sun_path.
sockaddr_un address_of(const std::string& name) {
    sockaddr_un address = {};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path, name.c_str(), name.size());
    return address;
}

// Removes the unused socket of a program that was killed.
Result<void> remove_stale_socket(const fs::path& path, const sockaddr_un& address) {
    struct stat status = {};
    if (::lstat(path.c_str(), &status) != 0)
        return {};
    if (!S_ISSOCK(status.st_mode))
        return fail({path, 0, "the path exists and isn't a socket. Choose another path."});
    const Descriptor asker(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    if (::connect(asker.get(), general(address), sizeof address) == 0 || errno == EAGAIN)
        return fail({path, 0, "another running program uses this socket"});
    if (errno != ECONNREFUSED)
        return cannot(path, "can't use the socket");
    if (::unlink(path.c_str()) != 0)
        return cannot(path, "can't replace the existing socket");
    return {};
}
}  // namespace

Result<void> ByteReader::make_stop() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        return cannot({}, "can't read from other programs");
    m_stop_reader = Descriptor(ends[0]);
    m_stop_writer = Descriptor(ends[1]);
    return {};
}

Result<std::unique_ptr<ByteReader>> ByteReader::read_stdin(ByteSink& sink) {
    // Reading from a terminal in the background would stop the program.
    if (::isatty(STDIN_FILENO) == 1 && ::tcgetpgrp(STDIN_FILENO) != ::getpgrp())
        return fail(
            {"stdin", 0, "another program uses this terminal. Send the beam through a pipe."});
    std::unique_ptr<ByteReader> reader(new ByteReader(sink));
    if (auto made = reader->make_stop(); !made)
        return fail(made.error());
    reader->m_thread = std::thread([self = reader.get()] {
        if (!self->read_all(STDIN_FILENO))
            self->m_sink.end();
    });
    return reader;
}

Result<std::unique_ptr<ByteReader>> ByteReader::read_named_pipe(const fs::path& path,
                                                                ByteSink& sink) {
    std::unique_ptr<ByteReader> reader(new ByteReader(sink));
    if (auto made = reader->make_stop(); !made)
        return fail(made.error());
    reader->m_pipe = Descriptor(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    if (!reader->m_pipe.is_open())
        return cannot(path, "can't open the pipe");
    struct stat status = {};
    if (::fstat(reader->m_pipe.get(), &status) != 0 || !S_ISFIFO(status.st_mode))
        return fail({path, 0, "the file is not a named pipe. Create one with mkfifo."});
    reader->m_thread = std::thread([self = reader.get()] { self->read_all(self->m_pipe.get()); });
    return reader;
}

Result<std::unique_ptr<ByteReader>> ByteReader::listen(const fs::path& path, Senders senders,
                                                       ByteSink& sink) {
    std::unique_ptr<ByteReader> reader(new ByteReader(sink));
    if (auto made = reader->make_stop(); !made)
        return fail(made.error());
    if (auto made = reader->make_socket(path); !made)
        return fail(made.error());
    reader->m_thread = std::thread([self = reader.get(), senders] { self->serve(senders); });
    return reader;
}

// Created under a temporary name and renamed once it listens, so that every visible socket accepts
// connections.
Result<void> ByteReader::make_socket(const fs::path& path) {
    const std::string made = path.string() + '~';
    if (made.size() >= sizeof sockaddr_un::sun_path)
        return fail({path, 0, "the path is too long for a socket; the limit is 106 bytes"});
    if (auto cleared = remove_stale_socket(path, address_of(path.string())); !cleared)
        return cleared;
    if (auto cleared = remove_stale_socket(made, address_of(made)); !cleared)
        return cleared;
    const ScopedFile passing(made);
    Descriptor listener(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    const sockaddr_un address = address_of(made);
    if (::bind(listener.get(), general(address), sizeof address) != 0)
        return cannot(path, "can't create the socket");
    constexpr int waiting = 8;
    // Only this user's programs may connect.
    if (::chmod(made.c_str(), S_IRUSR | S_IWUSR) != 0 || ::listen(listener.get(), waiting) != 0)
        return cannot(path, "can't open the socket");
    m_socket_file.emplace(path);
    if (::rename(made.c_str(), path.c_str()) != 0)
        return cannot(path, "can't open the socket");
    m_listener = std::move(listener);
    return {};
}

ByteReader::~ByteReader() {
    m_stop_writer = Descriptor();
    if (m_thread.joinable())
        m_thread.join();
}

// False if the thread must end.
bool ByteReader::wait_for(int descriptor) const {
    std::array<pollfd, 2> waited{pollfd{m_stop_reader.get(), POLLIN, 0},
                                 pollfd{descriptor, POLLIN, 0}};
    while (::poll(waited.data(), waited.size(), -1) < 0 && errno == EINTR) {
    }
    return waited[0].revents == 0;
}

// Whether any data was received.
bool ByteReader::read_all(int descriptor) {
    std::array<char, 16384> bytes;
    bool has_begun = false;
    while (wait_for(descriptor)) {
        const ssize_t size = ::read(descriptor, bytes.data(), bytes.size());
        if (size < 0 && (errno == EAGAIN || errno == EINTR))
            continue;
        if (size != 0 && !std::exchange(has_begun, true))
            m_sink.begin();
        if (size < 0)
            m_sink.fail_with(std::strerror(errno));
        if (size > 0)
            m_sink.take({bytes.data(), static_cast<std::size_t>(size)});
        else
            break;
    }
    if (has_begun)
        m_sink.end();
    return has_begun;
}

void ByteReader::serve(Senders senders) {
    while (wait_for(m_listener.get())) {
        const Descriptor sender(::accept4(m_listener.get(), nullptr, nullptr, SOCK_CLOEXEC));
        if (sender.is_open()) {
            if (read_all(sender.get()) && senders == Senders::one) {
                m_listener = Descriptor();  // the next sender is refused at once
                return;
            }
        } else if (errno != EAGAIN && errno != EINTR && errno != ECONNABORTED) {
            m_sink.fail_with(std::strerror(errno));
            m_sink.end();
            return;
        }
    }
}
