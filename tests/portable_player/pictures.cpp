#include "portable_player/pictures.h"

#include "portable_player/error.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <png.h>

namespace fs = std::filesystem;

namespace {
double srgb_decoded(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

// Grey, grey with alpha, RGB or RGBA.
void put_pixel(const float* from, int channels, float* to) {
    const int step = channels < 3 ? 0 : 1;
    for (int i = 0; i < 3; ++i)
        to[i] = from[i * step];
    to[3] = channels % 2 == 0 ? from[channels - 1] : 1.0F;
}

// Colours that the file stores multiplied by alpha.
void divide_by_alpha(Picture& picture) {
    for (std::size_t i = 0; i < picture.pixels.size(); i += 4)
        if (const float alpha = picture.pixels[i + 3]; alpha > 0.0F && alpha < 1.0F)
            for (std::size_t channel = 0; channel < 3; ++channel)
                picture.pixels[i + channel] /= alpha;
}

// A square of one picture as a part of a solid, in squares from the top left.
struct Square {
    int column = 0;
    int row = 0;
    bool is_turned = false;  // by 180 degrees
};

Picture joined(const Picture& flat, int side, const std::vector<Square>& squares) {
    Picture solid = new_picture(side, side * static_cast<int>(squares.size()), flat.is_display);
    int row = 0;
    for (const Square& square : squares)
        for (int y = 0; y < side; ++y, ++row)
            for (int x = 0; x < side; ++x)
                std::copy_n(flat.pixel(square.column * side + (square.is_turned ? side - 1 - x : x),
                                       square.row * side + (square.is_turned ? side - 1 - y : y)),
                            4, solid.pixel(x, row));
    return solid;
}

std::vector<Square> row_or_column(int count, bool is_row) {
    std::vector<Square> squares;
    for (int i = 0; i < count; ++i)
        squares.push_back(is_row ? Square{i, 0} : Square{0, i});
    return squares;
}

// The direction of a texel of a cube: OpenGL 4.1, table 3.19.
std::array<double, 3> cube_direction(int face, double u, double v) {
    const std::array<std::array<double, 3>, 6> directions{
        {{1, -v, -u}, {-1, -v, u}, {u, 1, v}, {u, -1, -v}, {u, -v, 1}, {-u, -v, -1}}};
    return directions[static_cast<std::size_t>(face)];
}

// Bilinear, at a position in pixels. The picture repeats from left to right.
void sample(const Picture& flat, double x, double y, float* to) {
    const double left = std::floor(x - 0.5);
    const double top = std::floor(y - 0.5);
    const auto at = [&](double column, double row) {
        const int wrapped = static_cast<int>(column) % flat.width;
        return flat.pixel((wrapped + flat.width) % flat.width,
                          std::clamp(static_cast<int>(row), 0, flat.height - 1));
    };
    const double across = x - 0.5 - left;
    const double down = y - 0.5 - top;
    for (int i = 0; i < 4; ++i)
        to[i] = static_cast<float>(
            std::lerp(std::lerp(at(left, top)[i], at(left + 1, top)[i], across),
                      std::lerp(at(left, top + 1)[i], at(left + 1, top + 1)[i], across), down));
}

Picture cube_of_panorama(const Picture& flat) {
    const int side = flat.height / 2;
    Picture cube = new_picture(side, 6 * side, flat.is_display);
    for (int y = 0; y < 6 * side; ++y)
        for (int x = 0; x < side; ++x) {
            const auto [right, up, ahead] = cube_direction(y / side, 2.0 * (x + 0.5) / side - 1.0,
                                                           2.0 * (y % side + 0.5) / side - 1.0);
            const double longitude = std::atan2(right, ahead);
            const double latitude = std::atan2(up, std::hypot(right, ahead));
            sample(flat, (0.5 + longitude / (2.0 * std::numbers::pi)) * flat.width,
                   (0.5 - latitude / std::numbers::pi) * flat.height, cube.pixel(x, y));
        }
    return cube;
}

Picture cube_of(const Picture& flat) {
    const int width = flat.width;
    const int height = flat.height;
    if (height == 6 * width)
        return flat;
    if (width == 1 && height == 1)
        return joined(flat, 1, std::vector<Square>(6));
    if (width == 6 * height)
        return joined(flat, height, row_or_column(6, true));
    if (3 * width == 4 * height)
        return joined(flat, width / 4, {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}});
    if (4 * width == 3 * height)
        return joined(flat, width / 3, {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {1, 3, true}});
    if (width == 2 * height)
        return cube_of_panorama(flat);
    throw Error("can't be a cube map");
}
}  // namespace

Picture new_picture(int width, int height, bool is_display) {
    Picture picture{width, height, is_display, {}};
    picture.pixels.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    return picture;
}

Picture load_picture(const fs::path& file) {
    OIIO::ImageSpec wishes;
    wishes.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(file.string(), &wishes);
    if (!input)
        throw Error(file.string() + ": can't read the picture: " + OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    OIIO::ImageSpec as_floats = spec;
    as_floats.set_format(OIIO::TypeDesc::FLOAT);
    OIIO::ImageBuf stored(as_floats);
    std::vector<float> numbers(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, numbers.data()))
        throw Error(file.string() + ": the picture is damaged: " + input->geterror());
    stored.set_pixels(spec.roi(), OIIO::TypeDesc::FLOAT, numbers.data());
    const OIIO::ImageBuf upright = OIIO::ImageBufAlgo::reorient(stored);
    const OIIO::ROI window = upright.roi_full();
    Picture picture =
        new_picture(window.width(), window.height(), !spec.format.is_floating_point());
    const int channels = std::min(upright.nchannels(), 4);
    std::array<float, 4> pixel{};
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            upright.getpixel(x + window.xbegin, y + window.ybegin, pixel.data(), channels);
            put_pixel(pixel.data(), channels, picture.pixel(x, y));
        }
    if (spec.alpha_channel >= 0 && spec.get_int_attribute("oiio:UnassociatedAlpha") == 0 &&
        spec.get_int_attribute("afterglowAsStored") == 0)
        divide_by_alpha(picture);
    return picture;
}

double srgb_encoded(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

void recode(Picture& picture, bool to_display) {
    if (picture.is_display == to_display)
        return;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        if (i % 4 != 3) {
            const double number = picture.pixels[i];
            picture.pixels[i] =
                static_cast<float>(to_display ? srgb_encoded(number) : srgb_decoded(number));
        }
    picture.is_display = to_display;
}

Picture solid_of(const std::vector<Picture>& pictures, const std::string& shape) {
    const Picture& first = pictures.front();
    if (pictures.size() > 1) {
        Picture solid{first.width, 0, first.is_display, {}};
        for (const Picture& face : pictures) {
            if (face.width != first.width || face.height != first.width)
                throw Error("the faces of a cube must be squares of one size");
            solid.height += face.height;
            solid.pixels.insert(solid.pixels.end(), face.pixels.begin(), face.pixels.end());
        }
        return solid;
    }
    if (shape == "cube")
        return cube_of(first);
    if (shape != "volume" || first.height == first.width * first.width)
        return first;
    if (first.width != first.height * first.height)
        throw Error("can't be a volume");
    return joined(first, first.height, row_or_column(first.height, true));
}

void save_png(const fs::path& file, int width, int height, const std::vector<std::uint8_t>& rgba) {
    png_image image;
    std::memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(width);
    image.height = static_cast<png_uint_32>(height);
    image.format = PNG_FORMAT_RGBA;
    image.flags = PNG_IMAGE_FLAG_FAST;
    if (png_image_write_to_file(&image, file.c_str(), 0, rgba.data(), 0, nullptr) == 0)
        throw Error(file.string() + ": " + image.message);
}
