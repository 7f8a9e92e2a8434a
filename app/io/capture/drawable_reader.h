#pragma once

#include "io/capture/x_server.h"
#include "model/look/picture.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>
#include <xcb/shm.h>

/// Reads pictures of windows and pixmaps into memory that it shares with the X server, without a
/// copy. If the server runs on another machine, they come through the connection.
class DrawableReader {
public:
    /// `server` must outlive it, but not its pictures.
    DrawableReader(const XServer& server, Extent extent);
    ~DrawableReader();
    DrawableReader(const DrawableReader&) = delete;
    DrawableReader& operator=(const DrawableReader&) = delete;

    Extent extent() const { return m_extent; }
    /// Reads the part of `drawable` whose top left pixel is (x, y). The previous pixels stay in
    /// `kept`, which is in pixels of the result. False: the drawable no longer has that part.
    Result<bool> read(xcb_drawable_t drawable, int x, int y, std::span<const ScreenArea> kept = {});
    /// What was read last, as Picture::bytes. Only the thread that reads may change it, before
    /// others use it.
    const std::shared_ptr<std::uint8_t>& bytes() const { return m_bytes; }

private:
    class Memory;

    std::shared_ptr<Memory> free_memory();
    Result<std::shared_ptr<std::uint8_t>> read_shared(xcb_drawable_t drawable, int x, int y);
    Result<std::shared_ptr<std::uint8_t>> read_sent(xcb_drawable_t drawable, int x, int y);
    Result<bool> checked(std::uint32_t size) const;
    void keep(std::span<const ScreenArea> kept, std::uint8_t* fresh) const;

    const XServer& m_server;
    Extent m_extent;
    std::vector<std::shared_ptr<Memory>> m_memories;
    bool m_is_shared = true;
    std::shared_ptr<std::uint8_t> m_bytes;  // null: nothing was read
};

/// The overlap of two areas; nullopt: none.
std::optional<ScreenArea> overlap_of(const ScreenArea& one, const ScreenArea& other);
