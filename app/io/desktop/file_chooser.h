#pragma once

#include "io/desktop/file_request.h"
#include "io/system/descriptor.h"

#include <atomic>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

/// The desktop's file dialog: the FileChooser portal of the session bus. All waiting happens on its
/// own thread. Without a session bus or portal it is never available.
class FileChooser {
public:
    /// `wake` is called on the chooser's thread when is_available() or take_reply() changes.
    explicit FileChooser(std::function<void()> wake);
    /// Closes an open dialog.
    ~FileChooser();
    FileChooser(const FileChooser&) = delete;
    FileChooser& operator=(const FileChooser&) = delete;

    /// Whether the desktop has such a dialog. False until it has answered after the start.
    bool is_available() const { return m_is_available; }
    /// Opens a dialog. An open one is closed without a reply.
    void ask(FileRequest request);
    /// Closes the open dialog without a reply.
    void cancel();
    /// The reply to the last request; nullopt: not yet.
    std::optional<FileReply> take_reply();

private:
    void run();
    void send(std::optional<FileRequest> command);
    std::deque<std::optional<FileRequest>> take_commands();
    void set_reply(FileReply reply);

    std::function<void()> m_wake;
    std::atomic<bool> m_is_available = false;
    std::atomic<bool> m_is_ending = false;
    Descriptor m_event;  // readable: there are commands, or the thread ends
    std::mutex m_mutex;
    std::deque<std::optional<FileRequest>> m_commands;  // nullopt: cancel
    std::optional<FileReply> m_reply;
    std::thread m_thread;
};
