#include "gpu/objects/texels.h"
#include "graph/inspect/point_reader.h"
#include "graph/looks.h"

namespace {
// Red is the column, green the row from the top.
Picture positions(Extent extent) {
    Picture picture{extent, 3, Encoding::linear, {}};
    for (int y = 0; y < extent.height; ++y)
        for (int x = 0; x < extent.width; ++x)
            picture.pixels.insert(picture.pixels.end(),
                                  {static_cast<float>(x), static_cast<float>(y), -1.0f});
    return picture;
}

gpu::Texture gathered_texture(const Picture& picture, Format format) {
    auto texture = gpu::Texture::make(picture.extent, format);
    REQUIRE(texture.has_value());
    std::vector<float> texels;
    gpu::fill_texels(picture, picture.encoding, texels);
    texture->upload(texels);
    return std::move(*texture);
}
}  // namespace

TEST_CASE_FIXTURE(Headless, "texels of several targets are read together, in the requested order") {
    auto gatherer = PointReader::make();
    REQUIRE(gatherer.has_value());
    const gpu::Texture large = gathered_texture(positions({7, 5}), Format::rgba32f);
    const gpu::Texture lone = gathered_texture(positions({2, 2}), Format::r32f);
    auto whole = gpu::Canvas::make({1, 1}, Format::r32ui);
    REQUIRE(whole.has_value());
    whole->clear({70000, 0, 0, 0});
    gatherer->start({{large, 6, 0}, {large, 2, 4}, {lone, 1, 1}, {whole->texture(), 0, 0}});
    CHECK(gatherer->is_busy());
    std::optional<std::vector<Rgba>> values;
    while (!values)
        values = gatherer->take();
    CHECK((*values)[0] == Rgba{6, 0, -1, 1});
    CHECK((*values)[1] == Rgba{2, 4, -1, 1});
    CHECK((*values)[2] == Rgba{1, 0, 0, 1});
    CHECK((*values)[3][0] == 70000.0f);
    CHECK_FALSE(gatherer->is_busy());
    gatherer->start({});
    CHECK_FALSE(gatherer->is_busy());
}
