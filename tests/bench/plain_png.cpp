#include "bench/plain_png.h"

#include <png.h>

namespace bench {

namespace {
void append_bytes(png_structp png, png_bytep data, std::size_t size) {
    auto& bytes = *static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(png));
    bytes.insert(bytes.end(), data, data + size);
}
}  // namespace

// Without an error handler libpng prints an error and aborts.
std::vector<std::uint8_t> plain_png(Extent extent, std::span<const std::uint8_t> rgba) {
    std::vector<std::uint8_t> bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(png, &bytes, append_bytes, nullptr);
    png_set_IHDR(png, info, static_cast<png_uint_32>(extent.width),
                 static_cast<png_uint_32>(extent.height), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_compression_level(png, 1);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
    png_write_info(png, info);
    png_set_filler(png, 0, PNG_FILLER_AFTER);
    const std::size_t row = static_cast<std::size_t>(extent.width) * 4;
    for (std::size_t end = rgba.size(); end != 0; end -= row)
        png_write_row(png, &rgba[end - row]);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return bytes;
}

}  // namespace bench
