#pragma once

#include "portable_player/description.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// RGBA pixels, top row first. Colours are not multiplied by alpha. A cube or volume has its square
/// faces or slices below each other.
struct Picture {
    int width = 0;
    int height = 0;
    bool is_display = true;  // sRGB; otherwise linear light
    std::vector<float> pixels;

    float* pixel(int x, int y) {
        return &pixels[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                            static_cast<std::size_t>(x))];
    }
    const float* pixel(int x, int y) const { return const_cast<Picture*>(this)->pixel(x, y); }
};

Picture new_picture(int width, int height, bool is_display);

/// Reads any picture that OpenImageIO reads. Fails with the name of the file.
Picture load_picture(const std::filesystem::path& file);

/// Converts colours to display values or to linear light.
void recode(Picture& picture, bool to_display);

/// A picture, or six faces, as the faces of a cube or the slices of a volume.
Picture solid_of(const std::vector<Picture>& pictures, const std::string& shape);

/// The position of the lines or columns of a source: start, distance, number.
using Raster = std::array<double, 3>;

/// A source as a look reads it.
struct PlacedPicture {
    Picture picture;
    Raster lines{};
    Raster columns{};
    double aspect = 1.0;  // width / height of a pixel
};

/// The source of a look: one picture, or the pictures of a sequence.
class Source {
public:
    Source(const Description& description, const Size& size);

    /// The number of the picture at the end of a frame.
    int number_at(double seconds) const;
    PlacedPicture placed(int number) const;

private:
    void read_settings(const std::string& content);
    void find_sequence();
    std::string file(int number) const;

    std::string m_name;
    std::string m_fit = "stretch";
    double m_aspect = 1.0;
    std::array<double, 2> m_shape{};  // of the whole picture; 0: not given
    int m_prescaled = 1;              // 0: not detected yet
    double m_rate = 60.0;
    bool m_loops = true;
    bool m_is_sequence = false;
    int m_first = 0;  // lowest number of a sequence
    int m_count = 1;
    Size m_size;
};

/// Writes display values. Fails with the name of the file.
void save_png(const std::filesystem::path& file, int width, int height,
              const std::vector<std::uint8_t>& rgba);

double srgb_encoded(double linear);
