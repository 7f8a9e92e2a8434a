#pragma once

#include "base/diagnostic.h"
#include "io/system/descriptor.h"
#include "model/look/extent.h"
#include "model/picture/frame_rate_fraction.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

/// The pixels of one picture in memory that PipeWire shares between programs.
struct PipeWirePixels {
    std::span<std::uint8_t> bytes;  // 4 per pixel, 8 bits per channel, row 0 at the top
    std::size_t stride = 0;         // bytes from row to row
    Extent extent;
    bool is_rgb = false;  // R, G, B and one unused byte; otherwise B, G, R and one unused byte
};

/// A video stream from or to a PipeWire server. Used by one thread. The server's events arrive on a
/// thread of its own.
class PipeWireVideo {
public:
    /// Called on that thread: reads or fills a picture.
    using Process = std::function<void(const PipeWirePixels& pixels)>;

    /// Offers a camera with this name to other programs. `process` fills each picture. Errors have
    /// no file: no server runs.
    static Result<std::unique_ptr<PipeWireVideo>> offer(const std::string& name, Extent extent,
                                                        FrameRateFraction rate, Process process);
    /// Reads the node with this number. `socket`: connected to its server; not open: the user's
    /// server. `process` reads each picture.
    static Result<std::unique_ptr<PipeWireVideo>> read(const Descriptor& socket, std::uint32_t node,
                                                       Process process);
    ~PipeWireVideo();
    PipeWireVideo(const PipeWireVideo&) = delete;
    PipeWireVideo& operator=(const PipeWireVideo&) = delete;

    /// Whether both ends are connected, so that pictures are sent.
    bool is_streaming() const;
    /// Why it has ended; "": it has not.
    std::string problem() const;
    /// Of an offered camera: sends a picture.
    void send();

private:
    class Stream;
    explicit PipeWireVideo(std::unique_ptr<Stream> stream);

    std::unique_ptr<Stream> m_stream;
};
