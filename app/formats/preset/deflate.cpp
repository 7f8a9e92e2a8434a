#include "formats/preset/deflate.h"

#include <algorithm>
#include <limits>
#include <zlib.h>

namespace {
unsigned char* bytes_of(std::string_view text) {
    return reinterpret_cast<unsigned char*>(const_cast<char*>(text.data()));  // zlib's next_in
}
}  // namespace

std::string deflate_bytes(std::string_view bytes) {
    uLongf size = ::compressBound(static_cast<uLong>(bytes.size()));
    std::string stream(size, '\0');
    // compress2 fails only without memory, because the buffer has the bound's size. Then the stream
    // is empty.
    if (::compress2(bytes_of(stream), &size, bytes_of(bytes), static_cast<uLong>(bytes.size()),
                    Z_BEST_COMPRESSION) != Z_OK)
        size = 0;
    stream.resize(size);
    return stream;
}

std::optional<std::string> inflate_bytes(std::string_view stream, std::size_t max_bytes) {
    if (stream.size() > std::numeric_limits<uInt>::max())
        return std::nullopt;
    z_stream inflater = {};
    inflater.next_in = bytes_of(stream);
    inflater.avail_in = static_cast<uInt>(stream.size());
    if (::inflateInit(&inflater) != Z_OK)
        return std::nullopt;
    std::string bytes;
    int state = Z_OK;
    while (state == Z_OK && bytes.size() <= max_bytes) {
        constexpr std::size_t step = 65536;
        const std::size_t before = bytes.size();
        bytes.resize(before + step);
        inflater.next_out = bytes_of(bytes) + before;
        inflater.avail_out = step;
        state = ::inflate(&inflater, Z_NO_FLUSH);
        bytes.resize(before + step - inflater.avail_out);
    }
    ::inflateEnd(&inflater);
    if (state != Z_STREAM_END || bytes.size() > max_bytes)
        return std::nullopt;
    return bytes;
}
