#pragma once

#include "base/diagnostic.h"
#include "io/files/descriptor.h"
#include "io/files/passing_file.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

/// Where bytes of another program go; called on the reader's thread. take() may wait, and lets the
/// sender wait meanwhile.
class ByteSink {
public:
    virtual ~ByteSink() = default;

    virtual void begin() = 0;  // a sender is there
    virtual void take(std::string_view bytes) = 0;
    virtual void end() = 0;  // it sends nothing more
    virtual void fail_with(const std::string& why) = 0;
};

/// Reads what other programs send, on a thread of its own. It ends at once with its owner, if the
/// sink waits for nothing then.
class ByteReader {
public:
    /// The program's standard input.
    static Result<std::unique_ptr<ByteReader>> read_stdin(ByteSink& sink);
    enum class Senders { one, one_after_the_other };
    /// A Unix socket, made at `path` for as long as this lives. Who connects and sends nothing is
    /// no sender.
    static Result<std::unique_ptr<ByteReader>> listen(const std::filesystem::path& path,
                                                      Senders senders, ByteSink& sink);
    ~ByteReader();
    ByteReader(const ByteReader&) = delete;
    ByteReader& operator=(const ByteReader&) = delete;

private:
    explicit ByteReader(ByteSink& sink) : m_sink(sink) {}

    Result<void> make_stop();
    Result<void> make_socket(const std::filesystem::path& path);
    bool read_all(int descriptor);
    void serve(Senders senders);
    bool wait_for(int descriptor) const;

    ByteSink& m_sink;
    Descriptor m_listener;
    std::optional<PassingFile> m_socket_file;
    Descriptor m_stop_reader;
    Descriptor m_stop_writer;  // closed to end the thread
    std::thread m_thread;
};
