#include "model/picture/placing.h"

#include <doctest/doctest.h>

namespace {
// Each pixel holds its position: 1 + x + 10 y.
Picture numbered(int width, int height) {
    Picture picture{{width, height}, 1, Encoding::linear, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture.pixels.push_back(static_cast<float>(1 + x + 10 * y));
    return picture;
}

SourceSpec spec(Fit fit, double aspect = 1.0) {
    return {"a.png", fit, aspect};
}
}  // namespace

TEST_CASE("a stretched source is unchanged") {
    const Picture picture = numbered(3, 2);
    CHECK(placed(picture, spec(Fit::stretch, 2.0), {640, 480}) == picture);
}

TEST_CASE("a whole source is padded with black to the shape of the picture") {
    // 4 x 2 into a square: two more rows, one of them above.
    const Picture tall = placed(numbered(4, 2), spec(Fit::whole), {100, 100});
    REQUIRE(tall.extent == Extent{4, 4});
    CHECK(tall.pixels == std::vector<float>{0, 0, 0, 0, 1, 2, 3, 4, 11, 12, 13, 14, 0, 0, 0, 0});
    // Pixels twice as wide as high: 2 x 2 of them have the shape 2 : 1, in a picture of 4 : 1.
    const Picture wide = placed(numbered(2, 2), spec(Fit::whole, 2.0), {400, 100});
    REQUIRE(wide.extent == Extent{4, 2});
    CHECK(wide.pixels == std::vector<float>{0, 1, 2, 0, 0, 11, 12, 0});
}

TEST_CASE("a cropped source is cut to the shape of the picture") {
    const Picture square = placed(numbered(4, 2), spec(Fit::crop), {100, 100});
    REQUIRE(square.extent == Extent{2, 2});
    CHECK(square.pixels == std::vector<float>{2, 3, 12, 13});
    CHECK(placed_extent({320, 240}, spec(Fit::crop), {1280, 720}) == Extent{320, 180});
    CHECK(placed_extent({320, 240}, spec(Fit::whole), {1280, 720}) == Extent{427, 240});
}

TEST_CASE("integer scaling is the largest that fits, padded with black") {
    const Picture doubled = placed(numbered(2, 1), spec(Fit::integer), {5, 4});
    REQUIRE(doubled.extent == Extent{5, 4});
    CHECK(doubled.pixels ==
          std::vector<float>{0, 0, 0, 0, 0, 1, 1, 2, 2, 0, 1, 1, 2, 2, 0, 0, 0, 0, 0, 0});
    // Pixels twice as wide as high: scaled 2 x 1, as 4 x 2 would be too wide.
    const Picture wide = placed(numbered(2, 1), spec(Fit::integer, 2.0), {5, 4});
    CHECK(std::vector<float>(wide.pixels.begin() + 5, wide.pixels.begin() + 10) ==
          std::vector<float>{1, 1, 2, 2, 0});
    CHECK(wide.pixels[10] == 0.0f);
    // Too large even at scale 1: cropped to its middle.
    const Picture cut = placed(numbered(4, 1), spec(Fit::integer), {2, 1});
    CHECK(cut.pixels == std::vector<float>{2, 3});
}

TEST_CASE("the shape of the whole picture applies in every fit") {
    SourceSpec television = spec(Fit::whole);
    television.shape = ShapeRatio{4.0, 3.0};
    CHECK(placed_extent({256, 224}, television, {1280, 720}) == Extent{341, 224});  // of 16:9
    television.fit = Fit::integer;
    const SourceRaster raster = placed_raster({256, 240}, television, {1280, 720});
    CHECK(raster.rows.pitch * 720.0 == doctest::Approx(3.0));
    CHECK(raster.columns.pitch * 1280.0 == doctest::Approx(4.0));  // 3 * 5 / 4 is 3.75
}

TEST_CASE("the raster of a source follows its placement") {
    const auto rows = [](Fit fit, Extent viewport) {
        return placed_raster({320, 240}, spec(fit), viewport).rows;
    };
    CHECK(rows(Fit::stretch, {640, 960}) == RasterAxis{0.0, 1.0 / 240.0, 240});
    CHECK(rows(Fit::whole, {640, 480}) == RasterAxis{0.0, 1.0 / 240.0, 240});
    CHECK(rows(Fit::whole, {640, 960}) == RasterAxis{0.25, 1.0 / 480.0, 240});  // black bars
    CHECK(rows(Fit::crop, {1280, 720}) == RasterAxis{-30.0 / 180.0, 1.0 / 180.0, 240});
    CHECK(rows(Fit::integer, {700, 500}) == RasterAxis{10.0 / 500.0, 2.0 / 500.0, 240});
    const RasterAxis columns = placed_raster({320, 240}, spec(Fit::integer), {700, 500}).columns;
    CHECK(columns == RasterAxis{30.0 / 700.0, 2.0 / 700.0, 320});
}

TEST_CASE("padding of a source with alpha is opaque black") {
    const Picture picture{{1, 1}, 4, Encoding::display, {0.5f, 0.5f, 0.5f, 0.25f}};
    const Picture made = placed(picture, spec(Fit::whole), {30, 10});
    REQUIRE(made.extent == Extent{3, 1});
    CHECK(made.pixels == std::vector<float>{0, 0, 0, 1, 0.5f, 0.5f, 0.5f, 0.25f, 0, 0, 0, 1});
}

TEST_CASE(
    "a picture in a view has the shape of the view or source, or whole multiples of the source") {
    constexpr Extent view{1000, 700};
    CHECK(shaped(view, ViewShape::view, {320, 240}, 1.0) == view);
    CHECK(shaped(view, ViewShape::source, {320, 240}, 1.0) == Extent{933, 700});
    CHECK(shaped(view, ViewShape::whole_pixels, {320, 240}, 1.0) == Extent{640, 480});
    // 256 pixels with an aspect of 8:7 are as wide as 292.57 lines are high.
    CHECK(shaped(view, ViewShape::whole_pixels, {256, 224}, 8.0 / 7.0) == Extent{878, 672});
    CHECK(shaped({300, 300}, ViewShape::whole_pixels, {600, 400}, 1.0) == Extent{300, 200});
    CHECK(shaped(view, ViewShape::source, {}, 1.0) == view);
    for (const ViewShape shape : {ViewShape::view, ViewShape::source, ViewShape::whole_pixels})
        CHECK(find_shape(shape_name(shape)) == shape);
    CHECK_FALSE(find_shape("").has_value());
}

TEST_CASE("a picture whose padding would need gigabytes is downsampled before it is placed") {
    Picture strip{{16384, 1}, 1, Encoding::linear, std::vector<float>(16384, 0.25f)};
    const SourceSpec whole{.picture = "strip.png", .fit = Fit::whole};
    const Extent square{64, 64};
    const Picture made = placed(strip, whole, square);
    CHECK(made.extent == placed_extent(strip.extent, whole, square));
    CHECK(made.extent.width == made.extent.height);
    CHECK(static_cast<double>(made.extent.width) * made.extent.height <= 1 << 25);
    const int middle = (made.extent.height - 1) / 2;
    for (const int x : {0, made.extent.width - 1})
        CHECK(made.pixels[made.index(x, middle)] == 0.25f);
    CHECK(made.pixels[made.index(0, 0)] == 0.0f);
}
