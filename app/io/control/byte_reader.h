#pragma once

#include "base/diagnostic.h"
#include "io/files/scoped_file.h"
#include "io/system/descriptor.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

/// Receives bytes from another program; called on the reader's thread. take() may block, which also
/// blocks the sender.
class ByteSink {
public:
    virtual ~ByteSink() = default;

    virtual void begin() = 0;  // a sender has connected
    virtual void take(std::string_view bytes) = 0;
    virtual void end() = 0;  // the sender has finished
    virtual void fail_with(const std::string& why) = 0;
};

/// Reads bytes from other programs on its own thread. The destructor joins the thread, immediately
/// unless the sink blocks.
class ByteReader {
public:
    /// Reads the program's standard input.
    static Result<std::unique_ptr<ByteReader>> read_stdin(ByteSink& sink);
    /// Reads a named pipe until its writer closes it.
    static Result<std::unique_ptr<ByteReader>> read_named_pipe(const std::filesystem::path& path,
                                                               ByteSink& sink);
    enum class Senders { one, one_after_the_other };
    /// Listens on a Unix socket at `path`, which exists while this object lives. A connection
    /// without data does not count as a sender.
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
    std::optional<ScopedFile> m_socket_file;
    Descriptor m_pipe;
    Descriptor m_stop_reader;
    Descriptor m_stop_writer;  // closed to end the thread
    std::thread m_thread;
};
