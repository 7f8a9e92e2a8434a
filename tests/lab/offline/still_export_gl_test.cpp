#include "formats/preset/preset_png.h"
#include "io/pictures/picture_file.h"
#include "lab/offline/still_export.h"
#include "lab/small_lab.h"

#include <cmath>
#include <fstream>
#include <iterator>

namespace {
constexpr const char* dithered = R"(#version 410 core
uniform sampler2D image;
uniform float gain = 1.71;
uniform bool dither = true;  // @identity 0
in vec2 uv;
out vec4 color;
void main() { color = texture(image, uv) * gain + (dither ? 0.1 : 0.0); }
)";

/// A look whose last pass has 8 bits. In frame 20 its first pass has the value 0.2, and its last
/// pass 0.342 without dithering, which is 87.21 of 255.
class EightBits : public SmallLab {
public:
    EightBits()
        : SmallLab(replaced(small_look::manifest, R"("show.frag", "format": "rgba32f")",
                            R"("show.frag", "format": "rgba8")")) {
        write_by_rename("sum.frag", replaced(small_look::sum, "= 1.0", "= 0.01"));
        write_by_rename("show.frag", dithered);
        REQUIRE(update_until([&] { return find_parameter(document().look(), "dither"); }));
    }

    Result<Picture> saved(const std::string& name, int png_bits,
                          const PassSwitches& switches = {}) {
        JobProgress work;
        const auto file = folder() / name;
        const auto made = export_still({document()},
                                       {.file = file,
                                        .png_bits = png_bits,
                                        .size = {8, 6},
                                        .seconds = 20.0 / 60.0,
                                        .switches = switches},
                                       roots(), work);
        return made ? load_picture(file) : fail(made.error());
    }
};

double red(const Result<Picture>& picture) {
    REQUIRE(picture.has_value());
    return picture->pixels[picture->index(3, 3)];
}
}  // namespace

TEST_CASE("files with more than 8 bits get them from a last pass of 8 bits, without dithering") {
    EightBits lab;
    constexpr double step = 1.0 / 65535.0;
    CHECK(std::abs(red(lab.saved("deep.png", 16)) - 0.342) < step);
    CHECK(std::abs(red(lab.saved("plain.png", 8)) - std::round(0.442 * 255.0) / 255.0) < 1e-6);
}

TEST_CASE("the preset in a picture keeps dithering and the formats of the look") {
    EightBits lab;
    REQUIRE(lab.saved("deep.png", 16).has_value());
    std::ifstream file(lab.folder() / "deep.png", std::ios::binary);
    const std::string png{std::istreambuf_iterator<char>(file), {}};
    const auto preset = preset_from_png(png, "deep.png");
    REQUIRE(preset.has_value());
    CHECK(preset->values.at("dither") == Value(1.0));
}

TEST_CASE("a picture of a later time shows that time") {
    EightBits lab;
    lab.write_by_rename(
        "show.frag",
        "#version 410 core\nuniform float u_time;\nuniform sampler2D image;\n"
        "in vec2 uv;\nout vec4 color;\n"
        "void main() { color = vec4(u_time / 10.0) + 0.0 * texture(image, uv); }\n");
    REQUIRE(lab.update_until([&] { return !find_parameter(lab.document().look(), "dither"); }));
    JobProgress work;
    const auto file = lab.folder() / "later.png";
    REQUIRE(export_still({lab.document()},
                         {.file = file, .png_bits = 8, .size = {8, 6}, .seconds = 5.0}, lab.roots(),
                         work)
                .has_value());
    CHECK(std::abs(red(load_picture(file)) - 0.5) <= 1.0 / 255.0);
}

TEST_CASE("a picture in another size has the displayed pass and the bypassed ones") {
    EightBits lab;
    constexpr double step = 1.0 / 65535.0;
    PassSwitches solo, bypassed, frozen;
    solo.solo = "sum";
    bypassed.bypassed = {"show"};
    frozen.frozen = {"show"};
    const double encoded = 1.055 * std::pow(0.2, 1.0 / 2.4) - 0.055;  // IEC 61966-2-1
    CHECK(std::abs(red(lab.saved("solo.png", 16, solo)) - encoded) < step);
    CHECK(std::abs(red(lab.saved("bypassed.png", 16, bypassed)) - 0.2) < step);
    CHECK(std::abs(red(lab.saved("frozen.png", 16, frozen)) - 0.342) < step);
}
