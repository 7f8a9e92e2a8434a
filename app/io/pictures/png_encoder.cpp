#include "io/pictures/png_encoder.h"

#include "model/picture/display_bytes.h"

#include <fmt/format.h>

#include <cassert>
#include <csetjmp>
#include <cstring>
#include <png.h>

namespace {
/// The data of libpng's callbacks.
struct PngTarget {
    std::string bytes;
    std::string error;
};

void append_png(png_structp png, png_bytep data, std::size_t size) {
    static_cast<PngTarget*>(png_get_io_ptr(png))
        ->bytes.append(reinterpret_cast<const char*>(data), size);
}

void flush_nothing(png_structp) {}

[[noreturn]] void leave_png(png_structp png, png_const_charp message) {
    static_cast<PngTarget*>(png_get_error_ptr(png))->error = message;
    png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

/// What the bytes of a row are.
struct PngPixels {
    int channels = 3;
    int bits = 8;

    std::size_t bytes() const { return static_cast<std::size_t>(channels * bits / 8); }
};

// libpng reports errors with longjmp, so nothing here may have a destructor.
bool write_png(png_structp png, png_infop info, Extent extent, const PngPixels& pixels,
               const std::uint8_t* bytes) {
    if (setjmp(png_jmpbuf(png)))
        return false;
    const auto width = static_cast<png_uint_32>(extent.width);
    png_set_IHDR(png, info, width, static_cast<png_uint_32>(extent.height), pixels.bits,
                 pixels.channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
    png_set_compression_level(png, 1);
    png_write_info(png, info);
    for (int y = 0; y < extent.height; ++y)
        png_write_row(png, bytes + static_cast<std::size_t>(y) * width * pixels.bytes());
    png_write_end(png, info);
    return true;
}

Result<std::string> encode_bytes(Extent extent, const PngPixels& pixels,
                                 std::span<const std::uint8_t> bytes) {
    assert(bytes.size() == static_cast<std::size_t>(extent.width) *
                               static_cast<std::size_t>(extent.height) * pixels.bytes());
    PngTarget target;
    png_structp png =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, &target, leave_png, ignore_warning);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    bool is_good = false;
    if (info) {
        png_set_write_fn(png, &target, append_png, flush_nothing);
        is_good = write_png(png, info, extent, pixels, bytes.data());
    }
    png_destroy_write_struct(&png, &info);
    if (!is_good)
        return fail({{}, 0, fmt::format("can't encode the PNG: {}", target.error)});
    return std::move(target.bytes);
}
}  // namespace

Result<std::string> encode_png(Extent extent, std::span<const std::uint8_t> rgb) {
    return encode_bytes(extent, {.channels = 3}, rgb);
}

Result<std::string> encode_png_with_alpha(Extent extent, std::span<const std::uint8_t> rgba) {
    return encode_bytes(extent, {.channels = 4}, rgba);
}

Result<std::string> encode_png_16(Extent extent, std::span<const std::uint16_t> rgba,
                                  bool has_alpha) {
    std::vector<std::uint8_t> bytes;  // the high byte first
    bytes.reserve(rgba.size() * 2);
    for (std::size_t i = 0; i < rgba.size(); ++i) {
        if (i % 4 == 3 && !has_alpha)
            continue;
        bytes.push_back(static_cast<std::uint8_t>(rgba[i] >> 8u));
        bytes.push_back(static_cast<std::uint8_t>(rgba[i] & 255u));
    }
    return encode_bytes(extent, {.channels = has_alpha ? 4 : 3, .bits = 16}, bytes);
}

Result<std::string> encode_png(const Picture& picture) {
    assert(picture.pixels.size() == picture.index(0, picture.extent.height));
    return encode_png(picture.extent, display_bytes(picture));
}
