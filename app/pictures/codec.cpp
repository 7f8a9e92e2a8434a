#include "base/text.h"
#include "io/pictures/picture_codec.h"
#include "pictures/svg_paths.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cstdint>

namespace fs = std::filesystem;

namespace {
constexpr int largest_side = 16384;
// As floats in memory and RGBA floats on the GPU: 34 million pixels of RGB, 30 million of RGBA.
constexpr std::int64_t max_bytes = std::int64_t{920} << 20;

// Marks our files, whose colours are not multiplied by alpha.
constexpr const char* as_stored = "afterglowAsStored";

// The first line of the library's message, without control characters, cut to 200 bytes.
std::string cleaned(std::string_view message) {
    const auto lines = split_lines(message);
    std::string text(trim(lines.empty() ? message : lines.front()));
    for (char& letter : text)
        if (static_cast<unsigned char>(letter) < ' ')
            letter = ' ';
    constexpr std::size_t longest = 200;
    if (text.size() > longest)
        text.resize(longest);
    while (text.ends_with('.') || text.ends_with(' '))
        text.pop_back();
    return text.empty() ? "no reason given" : text;
}

std::int64_t max_pixels(int channels) {
    constexpr int gpu_channels = 4;
    return max_bytes / (std::int64_t{4} * (std::max(channels, 1) + gpu_channels));
}

Result<void> check_extent(int width, int height, int channels, const fs::path& file) {
    if (width < 1 || height < 1)
        return fail({file, 0, "the file contains no flat picture"});
    if (width > largest_side || height > largest_side ||
        std::int64_t{width} * height > max_pixels(channels))
        return fail(
            {file, 0,
             fmt::format("the picture is too large: {} x {} px; the limit is {} px per side and {} "
                         "megapixels. Make it smaller, or cut out a part",
                         width, height, largest_side, max_pixels(channels) / 1'000'000)});
    return {};
}

Result<void> check_spec(const OIIO::ImageSpec& spec, const fs::path& file) {
    if (spec.depth > 1)
        return fail({file, 0, "the file contains no flat picture"});
    if (auto good = check_extent(spec.width, spec.height, spec.nchannels, file); !good)
        return good;
    if (auto good = check_extent(spec.full_width, spec.full_height, spec.nchannels, file); !good)
        return good;
    const bool has_grey_alpha = spec.nchannels == 2 && spec.alpha_channel == 1;
    if (spec.nchannels != 1 && spec.nchannels != 3 && spec.nchannels != 4 && !has_grey_alpha)
        return fail(
            {file, 0,
             fmt::format("the picture must have 1 (grey), 3 (RGB) or 4 (RGBA) channels, got {}",
                         spec.nchannels)});
    // OpenImageIO allocates all rows of a TIFF's strip, also those below the picture.
    const std::int64_t rows = spec.get_int_attribute("tiff:RowsPerStrip", 1);
    if (rows > spec.height &&
        rows * static_cast<std::int64_t>(spec.scanline_bytes(true)) > max_bytes)
        return fail({file, 0,
                     fmt::format("the picture is damaged: its strips have {} rows, but it has {}",
                                 rows, spec.height)});
    return {};
}

void unassociate(Picture& picture) {
    for (std::size_t i = 0; i < picture.pixels.size(); i += 4) {
        const float alpha = picture.pixels[i + 3];
        if (alpha <= 0.0f || alpha >= 1.0f)
            continue;
        for (std::size_t channel = 0; channel < 3; ++channel)
            picture.pixels[i + channel] /= alpha;
    }
}

std::vector<float> rgba_from_grey_alpha(const std::vector<float>& grey_alpha) {
    std::vector<float> rgba;
    rgba.reserve(grey_alpha.size() * 2);
    for (std::size_t i = 0; i < grey_alpha.size(); i += 2)
        rgba.insert(rgba.end(), {grey_alpha[i], grey_alpha[i], grey_alpha[i], grey_alpha[i + 1]});
    return rgba;
}

// Cameras store rotated pictures with an orientation tag.
void apply_orientation(Picture& picture, const OIIO::ImageSpec& spec) {
    const int orientation = spec.get_int_attribute("Orientation", 1);
    if (orientation == 1)
        return;
    OIIO::ImageSpec rotated(picture.extent.width, picture.extent.height, picture.channels,
                            OIIO::TypeDesc::FLOAT);
    rotated.attribute("Orientation", orientation);
    const OIIO::ImageBuf upright =
        OIIO::ImageBufAlgo::reorient(OIIO::ImageBuf(rotated, picture.pixels.data()));
    const OIIO::ImageSpec& now = upright.spec();
    std::vector<float> pixels(picture.pixels.size());
    if (now.image_pixels() != rotated.image_pixels() ||
        !upright.get_pixels(now.roi(), OIIO::TypeDesc::FLOAT, pixels.data()))
        return;
    picture.extent = {now.width, now.height};
    picture.pixels = std::move(pixels);
}

// An EXR's pixels may cover only a part of the picture, or extend beyond it. The displayed part is
// its display window (OpenEXR, "Technical Introduction"), black where it has no pixels.
void show_window(Picture& picture, const OIIO::ImageSpec& spec) {
    Picture whole{{spec.full_width, spec.full_height}, picture.channels, picture.encoding, {}};
    const auto channels = static_cast<std::size_t>(whole.channels);
    whole.pixels.resize(static_cast<std::size_t>(whole.extent.width) *
                        static_cast<std::size_t>(whole.extent.height) * channels);
    const int left = std::max(spec.x, spec.full_x);
    const int right = std::min(spec.x + spec.width, spec.full_x + spec.full_width);
    const int bottom = std::min(spec.y + spec.height, spec.full_y + spec.full_height);
    for (int y = std::max(spec.y, spec.full_y); y < bottom && left < right; ++y)
        std::copy_n(picture.pixels.begin() +
                        static_cast<std::ptrdiff_t>(picture.index(left - spec.x, y - spec.y)),
                    static_cast<std::size_t>(right - left) * channels,
                    whole.pixels.begin() + static_cast<std::ptrdiff_t>(
                                               whole.index(left - spec.full_x, y - spec.full_y)));
    picture = std::move(whole);
}

bool has_other_window(const OIIO::ImageSpec& spec) {
    return spec.x != spec.full_x || spec.y != spec.full_y || spec.width != spec.full_width ||
           spec.height != spec.full_height;
}

// For errors after which a library continues.
std::string note_of(const std::string& error) {
    if (error.empty())
        return {};
    const std::string reason = cleaned(error);
    const bool is_cut = reason.find("remature end") != std::string::npos;
    return is_cut ? fmt::format("the file ends early, so the rest is filled in: {}", reason)
                  : fmt::format("the picture is damaged: {}", reason);
}

Result<Picture> read_picture(const fs::path& file, const std::string& kind) {
    OIIO::ImageSpec wishes;
    wishes.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::create(kind);
    OIIO::ImageSpec spec;
    if (!input || !input->open(file.string(), spec, wishes))
        return fail({file, 0,
                     fmt::format("can't read the picture: {}",
                                 cleaned(input ? input->geterror() : OIIO::geterror()))});
    if (const auto good = check_spec(spec, file); !good)
        return fail(good.error());

    Picture picture{{spec.width, spec.height}, spec.nchannels, Encoding::display, {}};
    if (spec.format.is_floating_point())
        picture.encoding = Encoding::linear;
    picture.pixels.resize(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, picture.pixels.data()))
        return fail(
            {file, 0, fmt::format("the picture is damaged: {}", cleaned(input->geterror()))});
    picture.note = note_of(input->geterror());
    if (spec.nchannels == 2) {
        picture.pixels = rgba_from_grey_alpha(picture.pixels);
        picture.channels = 4;
    }
    if (kind == "openexr" && has_other_window(spec))
        show_window(picture, spec);
    const bool is_associated = spec.get_int_attribute("oiio:UnassociatedAlpha") == 0 &&
                               spec.get_int_attribute(as_stored) == 0;
    if (picture.channels == 4 && spec.alpha_channel >= 0 && is_associated)
        unassociate(picture);
    apply_orientation(picture, spec);
    return picture;
}

/// Pixels for an EXR, starting with the top row.
struct ExrPixels {
    Extent extent;
    int channels = 4;
    const void* top = nullptr;
    OIIO::stride_t row_bytes = OIIO::AutoStride;  // to the row below
    OIIO::TypeDesc held_as = OIIO::TypeDesc::FLOAT;
    OIIO::TypeDesc stored_as = OIIO::TypeDesc::FLOAT;
};

Result<std::string> write_exr(const ExrPixels& pixels) {
    OIIO::ImageSpec spec(pixels.extent.width, pixels.extent.height, pixels.channels,
                         pixels.stored_as);
    spec.attribute("compression", "zip");
    spec.attribute(as_stored, 1);
    spec.attribute("DateTime", "");  // otherwise the library writes the current time
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const char* const name = "picture.exr";
    const auto output = OIIO::ImageOutput::create(name, &memory);
    if (!output)
        return fail({{}, 0, fmt::format("can't encode the EXR: {}", cleaned(OIIO::geterror()))});
    if (!output->open(name, spec) ||
        !output->write_image(pixels.held_as, pixels.top, OIIO::AutoStride, pixels.row_bytes) ||
        !output->close())
        return fail({{}, 0, fmt::format("can't encode the EXR: {}", cleaned(output->geterror()))});
    return std::string(bytes.begin(), bytes.end());
}

Result<std::string> write_picture_exr(const Picture& picture, bool half) {
    assert(picture.pixels.size() == picture.index(0, picture.extent.height));
    ExrPixels pixels{picture.extent, picture.channels, picture.pixels.data()};
    if (half)
        pixels.stored_as = OIIO::TypeDesc::HALF;
    return write_exr(pixels);
}

// Starts at the last stored row, which is the top.
template <class Number>
Result<std::string> write_rows_exr(const RawPicture& picture, const std::vector<Number>& numbers,
                                   OIIO::TypeDesc type) {
    const auto rows = static_cast<std::size_t>(picture.extent.height);
    assert(numbers.size() == picture.row_length() * rows);
    const Number* const top = numbers.data() + picture.row_length() * (rows - 1);
    const auto row_bytes = static_cast<OIIO::stride_t>(picture.row_length() * sizeof(Number));
    return write_exr({picture.extent, picture.channels, top, -row_bytes, type, type});
}

Result<std::string> write_raw_exr(const RawPicture& picture) {
    if (const auto* halves = std::get_if<RawPicture::Halves>(&picture.pixels))
        return write_rows_exr(picture, *halves, OIIO::TypeDesc::HALF);
    return write_rows_exr(picture, std::get<RawPicture::Floats>(picture.pixels),
                          OIIO::TypeDesc::FLOAT);
}

// Converts the library's exceptions to errors.
template <class T, class Function>
Result<T> guarded(const fs::path& file, const Function& function) {
    try {
        return function();
    } catch (const std::exception& exception) {
        return fail(
            {file, 0, fmt::format("the picture library failed: {}", cleaned(exception.what()))});
    }
}

const PictureCodec codec{
    .read =
        [](const fs::path& file, const std::string& kind) {
            return guarded<Picture>(file, [&] { return read_picture(file, kind); });
        },
    .encode_exr =
        [](const Picture& picture, bool half) {
            return guarded<std::string>({}, [&] { return write_picture_exr(picture, half); });
        },
    .encode_raw_exr =
        [](const RawPicture& picture) {
            return guarded<std::string>({}, [&] { return write_raw_exr(picture); });
        },
    .svg_paths =
        [](std::string_view bytes, const fs::path& file) {
            return guarded<std::string>(file, [&] { return svg_paths(bytes, file); });
        },
};
}  // namespace

const PictureCodec* afterglow_picture_codec() {
    return &codec;
}
