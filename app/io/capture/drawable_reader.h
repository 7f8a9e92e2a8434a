#pragma once

#include "io/capture/x_server.h"
#include "model/look/picture.h"

#include <cstdint>
#include <span>
#include <vector>
#include <xcb/shm.h>

/// The pixels of a window or pixmap, read in parts. Shares memory with the X server if that runs on
/// this machine.
class DrawableReader {
public:
    /// `server` must outlive it.
    DrawableReader(const XServer& server, Extent extent);
    ~DrawableReader();
    DrawableReader(const DrawableReader&) = delete;
    DrawableReader& operator=(const DrawableReader&) = delete;

    Extent extent() const { return m_extent; }
    /// Reads a part of `drawable`, whose point (x, y) is the pixel (0, 0) here. `part` is in pixels
    /// of the drawable. Pixels in `kept`, which is in pixels of the result, stay. False: the
    /// drawable no longer has that part.
    Result<bool> read(xcb_drawable_t drawable, int x, int y, const ScreenArea& part,
                      std::span<const ScreenArea> kept = {});
    /// 4 bytes per pixel: blue, green, red, unused. Row 0 is the top.
    std::span<const std::uint8_t> pixels() const { return m_pixels; }

private:
    void copy_rows(const ScreenArea& here, std::span<const ScreenArea> kept,
                   const std::uint8_t* rows);

    const XServer& m_server;
    Extent m_extent;
    std::vector<std::uint8_t> m_pixels;
    xcb_shm_seg_t m_segment = XCB_NONE;  // none: pixels come through the connection
    const std::uint8_t* m_shared = nullptr;
};

/// The overlap of two areas; nullopt: none.
std::optional<ScreenArea> overlap_of(const ScreenArea& one, const ScreenArea& other);

/// Display-encoded RGB of pixels with 4 bytes: blue, green, red, unused.
Picture picture_of(Extent extent, std::span<const std::uint8_t> pixels);
