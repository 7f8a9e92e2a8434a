#include "model/picture/solid_picture.h"

#include "about.h"

namespace {
/// One channel; each pixel holds its position: 100 * row + column.
Picture places(int width, int height) {
    Picture picture{{width, height}, 1, Encoding::display, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture.pixels.push_back(static_cast<float>(100 * y + x));
    return picture;
}

std::vector<float> column(const Result<Picture>& solid) {
    if (!solid)
        return {};
    return solid->pixels;
}
}  // namespace

TEST_CASE("the centres of cube faces point along the axes") {
    const auto is = [](const Direction& direction, double x, double y, double z) {
        return direction.x == x && direction.y == y && direction.z == z;
    };
    CHECK(is(cube_direction(0, 0.5, 0.5), 1, 0, 0));
    CHECK(is(cube_direction(1, 0.5, 0.5), -1, 0, 0));
    CHECK(is(cube_direction(2, 0.5, 0.5), 0, 1, 0));
    CHECK(is(cube_direction(3, 0.5, 0.5), 0, -1, 0));
    CHECK(is(cube_direction(4, 0.5, 0.5), 0, 0, 1));
    CHECK(is(cube_direction(5, 0.5, 0.5), 0, 0, -1));
}

TEST_CASE("six squares in a row or column are the faces of a cube in GL order") {
    const auto low = solid_of(places(1, 6), PictureShape::cube);
    CHECK(column(low) == std::vector<float>{0, 100, 200, 300, 400, 500});
    const auto wide = solid_of(places(12, 2), PictureShape::cube);
    REQUIRE(wide.has_value());
    CHECK(wide->shape == PictureShape::cube);
    CHECK(wide->extent == Extent{2, 12});
    CHECK(std::vector(wide->pixels.begin(), wide->pixels.begin() + 8) ==
          std::vector<float>{0, 1, 100, 101, 2, 3, 102, 103});
}

TEST_CASE("a cross has +z in its middle, +x to the right and +y above") {
    // Faces of one pixel, in the order +x, -x, +y, -y, +z, -z.
    CHECK(column(solid_of(places(4, 3), PictureShape::cube)) ==
          std::vector<float>{102, 100, 1, 201, 101, 103});
    CHECK(column(solid_of(places(3, 4), PictureShape::cube)) ==
          std::vector<float>{102, 100, 1, 201, 101, 301});
    // The last square of a vertical cross is rotated by 180 degrees.
    const auto high = solid_of(places(6, 8), PictureShape::cube);
    REQUIRE(high.has_value());
    CHECK(std::vector(high->pixels.end() - 4, high->pixels.end()) ==
          std::vector<float>{703, 702, 603, 602});
}

TEST_CASE("a panorama has +z at its centre and +y at its top") {
    // Longitude in columns of 1/8 turn from -z over -x, +z, +x; the same in all rows.
    Picture turn{{8, 4}, 1, Encoding::linear, {}};
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x)
            turn.pixels.push_back(static_cast<float>(x) + 0.5f);
    const auto cube = solid_of(turn, PictureShape::cube);
    REQUIRE(cube.has_value());
    REQUIRE(cube->extent == Extent{2, 12});
    const auto at = [&](int face, int x, int y) {
        return cube->pixels[cube->index(x, 2 * face + y)];
    };
    // The texels of a 2 x 2 face lie atan(1/2) from the face's centre; a full turn is 8 columns.
    const double aside = std::atan(0.5) / (2.0 * std::numbers::pi) * 8.0;
    CHECK(at(4, 0, 0) == about(4.0 - aside, 1e-5));  // +z
    CHECK(at(4, 1, 1) == about(4.0 + aside, 1e-5));
    CHECK(at(0, 0, 0) == about(6.0 - aside, 1e-5));  // +x
    CHECK(at(1, 1, 0) == about(2.0 + aside, 1e-5));  // -x
    // Latitude likewise: the top face is above all others.
    Picture rise{{8, 4}, 1, Encoding::linear, {}};
    for (int y = 0; y < 4; ++y)
        rise.pixels.insert(rise.pixels.end(), 8, static_cast<float>(y) + 0.5f);
    const auto risen = solid_of(rise, PictureShape::cube);
    REQUIRE(risen.has_value());
    // Elevation atan(sqrt(2)) on +y, whose texels lie at (+-1/2, 1, +-1/2); half a turn is 4 rows.
    const double up = std::atan(std::sqrt(2.0)) / std::numbers::pi * 4.0;
    CHECK(risen->pixels[risen->index(0, 4)] == about(2.0 - up, 1e-5));
    CHECK(risen->pixels[risen->index(1, 6)] == about(2.0 + up, 1e-5));
}

TEST_CASE("n square slices of n x n are a volume") {
    CHECK(column(solid_of(places(2, 4), PictureShape::volume)) == places(2, 4).pixels);
    const auto wide = solid_of(places(4, 2), PictureShape::volume);
    REQUIRE(wide.has_value());
    CHECK(wide->shape == PictureShape::volume);
    CHECK(wide->extent == Extent{2, 4});
    CHECK(wide->pixels == std::vector<float>{0, 1, 100, 101, 2, 3, 102, 103});
}

TEST_CASE("a single pixel fills a cube or volume") {
    const Picture red{{1, 1}, 3, Encoding::linear, {1, 0, 0}};
    const auto cube = solid_of(red, PictureShape::cube);
    REQUIRE(cube.has_value());
    CHECK(cube->extent == Extent{1, 6});
    CHECK(cube->pixels == std::vector<float>{1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0});
    CHECK(solid_of(red, PictureShape::volume)->pixels == red.pixels);
}

TEST_CASE("a picture with an unsuitable shape gives an error with its size") {
    const auto no_cube = solid_of(places(5, 3), PictureShape::cube);
    REQUIRE_FALSE(no_cube.has_value());
    CHECK(no_cube.error().front().message.starts_with("can't be a cube map at 5 x 3 px."));
    const auto no_volume = solid_of(places(3, 3), PictureShape::volume);
    REQUIRE_FALSE(no_volume.has_value());
    CHECK(no_volume.error().front().message.starts_with("can't be a volume at 3 x 3 px."));
    CHECK(solid_of(places(3, 3), PictureShape::flat)->pixels == places(3, 3).pixels);
}
