#include "io/capture/drawable_reader.h"

#include <algorithm>
#include <array>
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

// Copies pixels from `begin` to `end` of a row, except those in `kept`, sorted by their start.
template <typename Copy>
void for_each_gap(int begin, int end, std::span<const std::pair<int, int>> kept, const Copy& copy) {
    for (const auto& [kept_begin, kept_end] : kept) {
        if (kept_begin > begin)
            copy(begin, std::min(kept_begin, end));
        begin = std::max(begin, kept_end);
    }
    if (begin < end)
        copy(begin, end);
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

DrawableReader::DrawableReader(const XServer& server, Extent extent)
    : m_server(server), m_extent(extent), m_pixels(bytes_of(extent)) {
    const int memory = ::shmget(IPC_PRIVATE, m_pixels.size(), IPC_CREAT | 0600);
    if (memory < 0)
        return;
    void* const shared = ::shmat(memory, nullptr, 0);
    const bool is_mapped = shared != reinterpret_cast<void*>(-1);
    if (is_mapped) {
        m_shared = static_cast<const std::uint8_t*>(shared);
        m_segment = xcb_generate_id(server.connection());
        const XcbReply<xcb_generic_error_t> refusal(xcb_request_check(
            server.connection(), xcb_shm_attach_checked(server.connection(), m_segment,
                                                        static_cast<std::uint32_t>(memory), 0)));
        if (refusal)  // the server runs on another machine
            m_segment = XCB_NONE;
    }
    ::shmctl(memory, IPC_RMID, nullptr);  // freed when both have detached it
}

DrawableReader::~DrawableReader() {
    if (m_segment != XCB_NONE)
        xcb_shm_detach(m_server.connection(), m_segment);
    if (m_shared)
        ::shmdt(m_shared);
}

Result<bool> DrawableReader::read(xcb_drawable_t drawable, int x, int y, const ScreenArea& part,
                                  std::span<const ScreenArea> kept) {
    const auto within = overlap_of(part, {x, y, m_extent});
    if (!within)
        return true;
    xcb_connection_t* const connection = m_server.connection();
    const auto left = static_cast<std::int16_t>(within->x);
    const auto top = static_cast<std::int16_t>(within->y);
    const auto width = static_cast<std::uint16_t>(within->extent.width);
    const auto height = static_cast<std::uint16_t>(within->extent.height);
    XcbReply<xcb_shm_get_image_reply_t> shared;
    XcbReply<xcb_get_image_reply_t> sent;
    xcb_generic_error_t* error = nullptr;
    if (m_segment != XCB_NONE)
        shared.reset(xcb_shm_get_image_reply(
            connection,
            xcb_shm_get_image(connection, drawable, left, top, width, height, ~0U,
                              XCB_IMAGE_FORMAT_Z_PIXMAP, m_segment, 0),
            &error));
    else
        sent.reset(xcb_get_image_reply(connection,
                                       xcb_get_image(connection, XCB_IMAGE_FORMAT_Z_PIXMAP,
                                                     drawable, left, top, width, height, ~0U),
                                       &error));
    const XcbReply<xcb_generic_error_t> freed(error);
    if (m_server.is_lost())
        return fail({{}, 0, "the X server has ended the connection"});
    if (!shared && !sent)
        return false;
    const std::size_t bytes =
        shared ? shared->size : static_cast<std::size_t>(xcb_get_image_data_length(sent.get()));
    if (bytes != bytes_of(within->extent))
        return fail({{}, 0, "the screen doesn't have 24 bits per pixel. Use another screen mode."});
    copy_rows({within->x - x, within->y - y, within->extent}, kept,
              shared ? m_shared : xcb_get_image_data(sent.get()));
    return true;
}

void DrawableReader::copy_rows(const ScreenArea& here, std::span<const ScreenArea> kept,
                               const std::uint8_t* rows) {
    const auto stride = static_cast<std::size_t>(here.extent.width) * pixel_bytes;
    std::vector<std::pair<int, int>> spans;
    for (int row = 0; row < here.extent.height; ++row) {
        spans.clear();
        for (const ScreenArea& area : kept)
            if (here.y + row >= area.y && here.y + row < area.y + area.extent.height)
                spans.emplace_back(area.x, area.x + area.extent.width);
        std::ranges::sort(spans);
        const std::uint8_t* const from = rows + static_cast<std::size_t>(row) * stride;
        std::uint8_t* const to = m_pixels.data() + static_cast<std::size_t>(here.y + row) *
                                                       static_cast<std::size_t>(m_extent.width) *
                                                       pixel_bytes;
        for_each_gap(here.x, here.x + here.extent.width, spans, [&](int begin, int end) {
            std::memcpy(to + static_cast<std::size_t>(begin) * pixel_bytes,
                        from + static_cast<std::size_t>(begin - here.x) * pixel_bytes,
                        static_cast<std::size_t>(end - begin) * pixel_bytes);
        });
    }
}

Picture picture_of(Extent extent, std::span<const std::uint8_t> pixels) {
    static const auto values = [] {
        std::array<float, 256> table{};
        for (std::size_t i = 0; i < table.size(); ++i)
            table[i] = static_cast<float>(i) / 255.0f;
        return table;
    }();
    Picture picture{extent, 3, Encoding::display, {}};
    const std::size_t count = pixels.size() / pixel_bytes;
    picture.pixels.resize(count * 3);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            picture.pixels[3 * i + c] = values[pixels[pixel_bytes * i + 2 - c]];
    return picture;
}
