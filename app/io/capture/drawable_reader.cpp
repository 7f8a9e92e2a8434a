#include "io/capture/drawable_reader.h"

#include <algorithm>
#include <cstring>
#include <sys/ipc.h>
#include <sys/shm.h>
#include <utility>

namespace {
constexpr std::size_t pixel_bytes = 4;

std::size_t bytes_of(Extent extent) {
    return static_cast<std::size_t>(extent.width) * static_cast<std::size_t>(extent.height) *
           pixel_bytes;
}
}  // namespace

std::optional<ScreenArea> overlap_of(const ScreenArea& one, const ScreenArea& other) {
    const int left = std::max(one.x, other.x);
    const int top = std::max(one.y, other.y);
    const int right = std::min(one.x + one.extent.width, other.x + other.extent.width);
    const int bottom = std::min(one.y + one.extent.height, other.y + other.extent.height);
    if (left >= right || top >= bottom)
        return std::nullopt;
    return ScreenArea{left, top, {right - left, bottom - top}};
}

/// Memory for one picture, shared with the server. It stays while a picture uses it, also after the
/// connection has ended.
class DrawableReader::Memory {
public:
    Memory(xcb_connection_t* connection, std::size_t size) {
        const int memory = ::shmget(IPC_PRIVATE, size, IPC_CREAT | 0600);
        if (memory < 0)
            return;
        void* const shared = ::shmat(memory, nullptr, 0);
        if (shared != reinterpret_cast<void*>(-1)) {
            m_bytes = static_cast<std::uint8_t*>(shared);
            m_segment = xcb_generate_id(connection);
            const XcbReply<xcb_generic_error_t> refusal(xcb_request_check(
                connection, xcb_shm_attach_checked(connection, m_segment,
                                                   static_cast<std::uint32_t>(memory), 0)));
            if (refusal)
                m_segment = XCB_NONE;
        }
        ::shmctl(memory, IPC_RMID, nullptr);  // freed when both have detached it
    }
    ~Memory() {
        if (m_bytes)
            ::shmdt(m_bytes);
    }
    Memory(const Memory&) = delete;
    Memory& operator=(const Memory&) = delete;

    std::uint8_t* bytes() const { return m_bytes; }
    /// None: the server can't use it.
    xcb_shm_seg_t segment() const { return m_segment; }

private:
    std::uint8_t* m_bytes = nullptr;
    xcb_shm_seg_t m_segment = XCB_NONE;
};

DrawableReader::DrawableReader(const XServer& server, Extent extent)
    : m_server(server), m_extent(extent) {}

DrawableReader::~DrawableReader() {
    for (const auto& memory : m_memories)
        if (memory->segment() != XCB_NONE)
            xcb_shm_detach(m_server.connection(), memory->segment());
}

// Memory that no picture uses.
std::shared_ptr<DrawableReader::Memory> DrawableReader::free_memory() {
    for (const auto& memory : m_memories)
        if (memory.use_count() == 1)
            return memory;
    m_memories.push_back(std::make_shared<Memory>(m_server.connection(), bytes_of(m_extent)));
    return m_memories.back();
}

// False: the server refused.
Result<bool> DrawableReader::checked(std::uint32_t size) const {
    if (m_server.is_lost())
        return fail({{}, 0, "the X server has ended the connection"});
    if (size != 0 && size != bytes_of(m_extent))
        return fail({{}, 0, "the screen doesn't have 24 bits per pixel. Use another screen mode."});
    return size != 0;
}

Result<std::shared_ptr<std::uint8_t>> DrawableReader::read_shared(xcb_drawable_t drawable, int x,
                                                                  int y) {
    const auto memory = free_memory();
    if (memory->segment() == XCB_NONE) {
        m_is_shared = false;
        return read_sent(drawable, x, y);
    }
    xcb_connection_t* const connection = m_server.connection();
    const XcbReply<xcb_shm_get_image_reply_t> reply(xcb_shm_get_image_reply(
        connection,
        xcb_shm_get_image(connection, drawable, static_cast<std::int16_t>(x),
                          static_cast<std::int16_t>(y), static_cast<std::uint16_t>(m_extent.width),
                          static_cast<std::uint16_t>(m_extent.height), ~0U,
                          XCB_IMAGE_FORMAT_Z_PIXMAP, memory->segment(), 0),
        nullptr));
    const auto is_read = checked(reply ? reply->size : 0);
    if (!is_read)
        return fail(is_read.error());
    return *is_read ? std::shared_ptr<std::uint8_t>(memory, memory->bytes()) : nullptr;
}

Result<std::shared_ptr<std::uint8_t>> DrawableReader::read_sent(xcb_drawable_t drawable, int x,
                                                                int y) {
    xcb_connection_t* const connection = m_server.connection();
    const std::shared_ptr<xcb_get_image_reply_t> reply(
        xcb_get_image_reply(
            connection,
            xcb_get_image(connection, XCB_IMAGE_FORMAT_Z_PIXMAP, drawable,
                          static_cast<std::int16_t>(x), static_cast<std::int16_t>(y),
                          static_cast<std::uint16_t>(m_extent.width),
                          static_cast<std::uint16_t>(m_extent.height), ~0U),
            nullptr),
        XcbFree());
    const auto is_read =
        checked(reply ? static_cast<std::uint32_t>(xcb_get_image_data_length(reply.get())) : 0);
    if (!is_read)
        return fail(is_read.error());
    return *is_read ? std::shared_ptr<std::uint8_t>(reply, xcb_get_image_data(reply.get()))
                    : nullptr;
}

Result<bool> DrawableReader::read(xcb_drawable_t drawable, int x, int y,
                                  std::span<const ScreenArea> kept) {
    auto fresh = m_is_shared ? read_shared(drawable, x, y) : read_sent(drawable, x, y);
    if (!fresh)
        return fail(fresh.error());
    if (!*fresh)
        return false;
    keep(kept, fresh->get());
    m_bytes = std::move(*fresh);
    return true;
}

// Black, if nothing was read before.
void DrawableReader::keep(std::span<const ScreenArea> kept, std::uint8_t* fresh) const {
    for (const ScreenArea& area : kept)
        for (int row = area.y; row < area.y + area.extent.height; ++row) {
            const std::size_t first =
                (static_cast<std::size_t>(row) * static_cast<std::size_t>(m_extent.width) +
                 static_cast<std::size_t>(area.x)) *
                pixel_bytes;
            const std::size_t size = static_cast<std::size_t>(area.extent.width) * pixel_bytes;
            if (m_bytes)
                std::memcpy(fresh + first, m_bytes.get() + first, size);
            else
                std::memset(fresh + first, 0, size);
        }
}
