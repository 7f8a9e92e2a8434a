#include "io/picture_file.h"

#include "base/file.h"
#include "base/text.h"
#include "io/atomic_file.h"
#include "io/picture_kind.h"
#include "io/png_chunks.h"
#include "model/color.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace fs = std::filesystem;

namespace {
constexpr int largest_side = 16384;
constexpr std::int64_t most_pixels = std::int64_t{64} << 20;
// Marks a file of ours whose alpha is data that the colours were never multiplied by.
constexpr const char* as_stored = "afterglowAsStored";

// The library's message without its own names, control characters and repeated lines.
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
    return text.empty() ? "its content is not understood" : text;
}

// What can be told before the library sees the file. libpng would print a damaged PNG's mistakes on
// stderr, so its check sums are looked at first.
Result<void> check_file(const fs::path& file) {
    const auto start = read_start(file, png_signature().size());
    if (!start)
        return fail(start.error());
    if (start->empty())
        return fail({file, 0, "is empty"});
    if (!is_png(*start))
        return {};
    const auto bytes = read_bytes(file);
    if (!bytes)
        return fail(bytes.error());
    const auto chunks = parse_png_chunks(*bytes);
    if (!chunks)
        return fail({file, 0, chunks.error().front().message});
    return {};
}

Result<void> check_spec(const OIIO::ImageSpec& spec, const fs::path& file) {
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1)
        return fail({file, 0, "holds no flat picture"});
    if (spec.width > largest_side || spec.height > largest_side ||
        std::int64_t{spec.width} * spec.height > most_pixels)
        return fail(
            {file, 0,
             fmt::format("is too large: {} x {} px; at most {} px a side and {} pixels are read",
                         spec.width, spec.height, largest_side, most_pixels)});
    const bool has_grey_alpha = spec.nchannels == 2 && spec.alpha_channel == 1;
    if (spec.nchannels != 1 && spec.nchannels != 3 && spec.nchannels != 4 && !has_grey_alpha)
        return fail(
            {file, 0,
             fmt::format("has {} channels; pictures of 1 (grey), 3 (RGB) and 4 (RGBA) are read",
                         spec.nchannels)});
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

// Cameras store a turned picture and say so.
void turn_upright(Picture& picture, const OIIO::ImageSpec& spec) {
    const int orientation = spec.get_int_attribute("Orientation", 1);
    if (orientation == 1)
        return;
    OIIO::ImageSpec turned(picture.extent.width, picture.extent.height, picture.channels,
                           OIIO::TypeDesc::FLOAT);
    turned.attribute("Orientation", orientation);
    const OIIO::ImageBuf upright =
        OIIO::ImageBufAlgo::reorient(OIIO::ImageBuf(turned, picture.pixels.data()));
    const OIIO::ImageSpec& now = upright.spec();
    std::vector<float> pixels(picture.pixels.size());
    if (now.image_pixels() != turned.image_pixels() ||
        !upright.get_pixels(now.roi(), OIIO::TypeDesc::FLOAT, pixels.data()))
        return;
    picture.extent = {now.width, now.height};
    picture.pixels = std::move(pixels);
}

Result<Picture> read_picture(const fs::path& file) {
    OIIO::ImageSpec wishes;
    wishes.attribute("oiio:UnassociatedAlpha", 1);
    const auto start = read_start(file, picture_start);
    if (!start)
        return fail(start.error());
    const std::string kind = picture_kind(*start, file);
    if (kind.empty())
        return fail({file, 0,
                     "cannot be read as a picture: it is no PNG, JPEG, EXR, TIFF, HDR, GIF, WebP, "
                     "HEIF, PSD, DDS, JPEG 2000, BMP, PNM or TGA"});
    const auto input = OIIO::ImageInput::create(kind);
    OIIO::ImageSpec spec;
    if (!input || !input->open(file.string(), spec, wishes))
        return fail({file, 0,
                     "cannot be read as a picture: " +
                         cleaned(input ? input->geterror() : OIIO::geterror())});
    if (const auto good = check_spec(spec, file); !good)
        return fail(good.error());

    Picture picture{{spec.width, spec.height}, spec.nchannels, Encoding::display, {}};
    if (spec.format.is_floating_point())
        picture.encoding = Encoding::linear;
    picture.pixels.resize(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, picture.pixels.data()))
        return fail({file, 0, "is damaged: " + cleaned(input->geterror())});
    if (spec.nchannels == 2) {
        picture.pixels = rgba_from_grey_alpha(picture.pixels);
        picture.channels = 4;
    }
    const bool is_associated = spec.get_int_attribute("oiio:UnassociatedAlpha") == 0 &&
                               spec.get_int_attribute(as_stored) == 0;
    if (picture.channels == 4 && spec.alpha_channel >= 0 && is_associated)
        unassociate(picture);
    turn_upright(picture, spec);
    return picture;
}

std::uint8_t display_byte(float value, Encoding encoding) {
    if (!(value > 0.0f))  // NaN too
        return 0;
    double display = std::min(static_cast<double>(value), 1.0);
    if (encoding == Encoding::linear)
        display = srgb_encode(display);
    return static_cast<std::uint8_t>(std::lround(display * 255.0));
}

std::vector<std::uint8_t> display_bytes(const Picture& picture) {
    std::vector<std::uint8_t> bytes;
    const auto channels = static_cast<std::size_t>(picture.channels);
    bytes.reserve(picture.pixels.size() / channels * 3);
    for (std::size_t i = 0; i < picture.pixels.size(); i += channels)
        for (std::size_t channel = 0; channel < 3; ++channel)
            bytes.push_back(
                display_byte(picture.pixels[i + (channels < 3 ? 0 : channel)], picture.encoding));
    return bytes;
}

Result<std::string> encode(const char* name, const OIIO::ImageSpec& spec,
                           const OIIO::TypeDesc& type, const void* pixels) {
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create(name, &memory);
    if (!output)
        return fail({{}, 0, "cannot be encoded: " + cleaned(OIIO::geterror())});
    if (!output->open(name, spec) || !output->write_image(type, pixels) || !output->close())
        return fail({{}, 0, "cannot be encoded: " + cleaned(output->geterror())});
    return std::string(bytes.begin(), bytes.end());
}

Result<std::string> encode_exr(const Picture& picture, const SaveOptions& options) {
    OIIO::ImageSpec spec(picture.extent.width, picture.extent.height, picture.channels,
                         options.half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
    spec.attribute("compression", "zip");
    spec.attribute(as_stored, 1);
    spec.attribute("DateTime", "");  // else the library writes the time of day
    return encode("picture.exr", spec, OIIO::TypeDesc::FLOAT, picture.pixels.data());
}

// The file of the diagnostics, and the library's exceptions turned into one.
template <class T, class Function>
Result<T> guarded(const fs::path& file, const Function& function) {
    try {
        Result<T> result = function();
        if (!result)
            for (Diagnostic& diagnostic : result.error())
                diagnostic.file = file;
        return result;
    } catch (const std::exception& exception) {
        return fail({file, 0, "cannot be used: " + cleaned(exception.what())});
    }
}

[[maybe_unused]] bool is_whole(const Picture& picture) {
    return !picture.extent.is_empty() &&
           picture.pixels.size() == static_cast<std::size_t>(picture.extent.width) *
                                        static_cast<std::size_t>(picture.extent.height) *
                                        static_cast<std::size_t>(picture.channels);
}
}  // namespace

Result<Picture> load_picture(const fs::path& file) {
    if (const auto good = check_file(file); !good)
        return fail(good.error());
    return guarded<Picture>(file, [&] { return read_picture(file); });
}

Result<std::string> encode_png(const Picture& picture) {
    assert(is_whole(picture));
    OIIO::ImageSpec spec(picture.extent.width, picture.extent.height, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("png:compressionLevel", 3);
    const std::vector<std::uint8_t> bytes = display_bytes(picture);
    return guarded<std::string>(
        {}, [&] { return encode("picture.png", spec, OIIO::TypeDesc::UINT8, bytes.data()); });
}

Result<void> save_picture(const Picture& picture, const fs::path& file,
                          const SaveOptions& options) {
    assert(is_whole(picture));
    const std::string extension = to_lower(file.extension().string());
    if (extension != ".png" && extension != ".exr")
        return fail({file, 0, "a picture is saved as .png or .exr"});
    const auto bytes = guarded<std::string>(file, [&] {
        return extension == ".png" ? encode_png(picture) : encode_exr(picture, options);
    });
    if (!bytes)
        return fail(bytes.error());
    return write_atomically(file, *bytes);
}
