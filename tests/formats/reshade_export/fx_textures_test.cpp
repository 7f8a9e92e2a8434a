#include "formats/reshade_export/fx_textures.h"

#include <doctest/doctest.h>

namespace {
Look chain() {
    Look look;
    for (const char* const name : {"first", "second", "last"}) {
        Pass pass;
        pass.name = name;
        look.passes.push_back(pass);
    }
    look.passes[0].size.fill({Side::By::source, 2.0, {}});
    look.passes[1].size.fill({Side::By::viewport, 0.25, {}});
    return look;
}

Input read(const char* pass, int frames_ago, bool mipmap = false) {
    Input input{"image", Input::From::pass, pass, frames_ago, {}};
    input.sampler.mipmap = mipmap;
    return input;
}
}  // namespace

TEST_CASE("inputs with the same texture and filter share a sampler") {
    const Look look = chain();
    FxTextures textures(look, {}, "E_");
    const std::string first = textures.sampler(read("first", 0), 1);
    CHECK(textures.sampler(read("first", 0), 2) == first);
    Input nearest = read("first", 0);
    nearest.sampler.filter = Filter::nearest;
    CHECK(textures.sampler(nearest, 2) != first);
    CHECK(textures.sampler_count() == 2);
}

TEST_CASE("an earlier frame is copied unless its pass comes later") {
    const Look look = chain();
    FxTextures later(look, {}, "E_");
    later.sampler(read("second", 1), 0);
    CHECK(later.copies().empty());

    FxTextures itself(look, {}, "E_");
    itself.sampler(read("first", 2), 0);
    const auto copies = itself.copies();
    REQUIRE(copies.size() == 2);
    CHECK(copies[0].target == "E_first_before_2");  // the older picture first
    CHECK(copies[1].target == "E_first_before");
}

TEST_CASE("sizes and mip levels follow the screen and the source") {
    const Look look = chain();
    FxTextures textures(look, {}, "E_");
    textures.sampler(read("first", 0, true), 1);
    textures.sampler(read("second", 0, true), 2);
    const std::string text = textures.declarations();
    CHECK(text.find("E_first { Width = int(afterglow_columns * 2 + 0.5); Height = "
                    "int(afterglow_lines * 2 + 0.5); Format = RGBA16F; MipLevels = "
                    "(afterglow_source_levels +1); }") != std::string::npos);
    CHECK(text.find("E_second { Width = int(afterglow_width * 0.25 + 0.5); Height = "
                    "int(afterglow_height * 0.25 + 0.5); Format = RGBA16F; MipLevels = "
                    "(afterglow_levels -2); }") != std::string::npos);
}
