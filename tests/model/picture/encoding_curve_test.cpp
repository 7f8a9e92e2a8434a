#include "model/picture/encoding_curve.h"

#include "model/look/color.h"

#include <doctest/doctest.h>

TEST_CASE("recoding converts the colours of a picture, but not its alpha") {
    Picture picture{
        {1, 2}, 4, Encoding::display, {0.2f, 0.5f, 1.0f, 0.3f, 0.0f, -0.5f, 2.0f, 0.7f}};
    recode(picture, Encoding::linear);
    CHECK(picture.encoding == Encoding::linear);
    const std::vector<double> light{srgb_decode(0.2),  srgb_decode(0.5), 1.0, 0.3, 0.0,
                                    -srgb_decode(0.5), srgb_decode(2.0), 0.7};
    for (std::size_t i = 0; i < light.size(); ++i)
        CHECK(picture.pixels[i] == doctest::Approx(light[i]).epsilon(1e-6));
}

TEST_CASE("grey is recoded; a picture that already has the encoding is unchanged") {
    Picture grey{{2, 1}, 1, Encoding::linear, {0.25f, 0.75f}};
    const Picture before = grey;
    recode(grey, Encoding::linear);
    CHECK(grey == before);
    recode(grey, Encoding::display);
    CHECK(grey.encoding == Encoding::display);
    CHECK(grey.pixels[0] == doctest::Approx(srgb_encode(0.25)).epsilon(1e-6));
    CHECK(grey.pixels[1] == doctest::Approx(srgb_encode(0.75)).epsilon(1e-6));
}
