#include "io/desktop/file_chooser.h"

#include "io/desktop/portal_session.h"

#include <algorithm>
#include <cstdint>
#include <sys/eventfd.h>
#include <unistd.h>
#include <utility>

namespace {
FileReply unavailable() {
    return {.kind = FileReply::Kind::failed, .problem = "it is not available"};
}
}  // namespace

FileChooser::FileChooser(std::function<void()> wake)
    : m_wake(std::move(wake)), m_event(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
    if (m_event.is_open())
        m_thread = std::thread([this] { run(); });
}

FileChooser::~FileChooser() {
    m_is_ending = true;
    send(std::nullopt);
    if (m_thread.joinable())
        m_thread.join();
}

void FileChooser::send(std::optional<FileRequest> command) {
    {
        const std::lock_guard lock(m_mutex);
        m_reply.reset();
        if (command && !m_is_available)
            m_reply = unavailable();
        else
            m_commands.push_back(std::move(command));
    }
    constexpr std::uint64_t one = 1;
    if (m_event.is_open())
        (void)!::write(m_event.get(), &one, sizeof(one));  // only fails if it is readable already
    m_wake();
}

std::deque<std::optional<FileRequest>> FileChooser::take_commands() {
    std::uint64_t count = 0;
    (void)!::read(m_event.get(), &count, sizeof(count));
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_commands, {});
}

void FileChooser::ask(FileRequest request) {
    send(std::move(request));
}

void FileChooser::cancel() {
    send(std::nullopt);
}

void FileChooser::set_reply(FileReply reply) {
    {
        const std::lock_guard lock(m_mutex);
        if (m_commands.empty())  // otherwise it answers an earlier request
            m_reply = std::move(reply);
    }
    m_wake();
}

std::optional<FileReply> FileChooser::take_reply() {
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_reply, std::nullopt);
}

void FileChooser::run() {
    const auto session =
        PortalSession::open({.on_availability =
                                 [this](bool is_available) {
                                     m_is_available = is_available;
                                     m_wake();
                                 },
                             .on_reply = [this](FileReply reply) { set_reply(std::move(reply)); }});
    while (session && session->process() && !m_is_ending && session->wait(m_event.get()))
        for (const auto& command : take_commands()) {
            if (command)
                session->ask(*command);
            else
                session->cancel();
        }
    {
        const std::lock_guard lock(m_mutex);
        m_is_available = false;
        if (std::ranges::any_of(std::exchange(m_commands, {}),
                                [](const auto& command) { return command.has_value(); }))
            m_reply = unavailable();
    }
    m_wake();
}
