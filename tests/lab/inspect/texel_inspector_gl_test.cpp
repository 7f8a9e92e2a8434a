#include "gpu/objects/draw.h"
#include "graph/looks.h"
#include "lab/inspect/texel_inspector.h"

namespace {
// 20 x 10: red is the column from the left, green the row from the top, blue the frame.
struct TexelInspection : Headless {
    Executor executor =
        executor_of(look_of({pass("places",
                                  "uniform int u_frame;\nvoid main() { color = "
                                  "vec4(gl_FragCoord.x - 0.5, 9.5 - gl_FragCoord.y, u_frame, 1); "
                                  "}\n")}),
                    {20, 10});
    Result<TexelInspector> texels = TexelInspector::make();
    std::string name = "places";

    TexelValues::Subject cells(const PictureView& view, Extent size) const {
        const gpu::Texture& texture = executor.target(0);
        return {texture,
                name,
                texture.extent(),
                position_of(view, texture.extent(), size),
                size,
                {40, 30},
                executor.textures().number()};
    }
    void update(const PictureView& view, double seconds) {
        REQUIRE(texels.has_value());
        const TexelValues::Subject subject = cells(view, {200, 100});
        texels->update_picture(&subject, seconds);
        gpu::finish();
    }
    float blue() const {
        const auto* block = texels->picture().block();
        return block ? block->numbers[0][2] : -1.0f;
    }
    void update(const ScanLine& line, double seconds) {
        REQUIRE(texels.has_value());
        const Waveform::Subject subject{executor.target(0), name, line,
                                        executor.textures().number()};
        texels->update_waveform(&subject, seconds);
        gpu::finish();
    }
};

constexpr PictureView at_50{PictureView::Fit::free, 50.0};
}  // namespace

TEST_CASE_FIXTURE(TexelInspection, "texel values appear where there is room for them") {
    CHECK(visible_cells(cells({PictureView::Fit::free, 39.0}, {200, 100})).count.is_empty());
    // 50 px per texel around the centre (10, 5): columns 8 to 12 and rows 4 to 6 are visible.
    const TexelValues::Block block = visible_cells(cells(at_50, {200, 100}));
    CHECK(block.left == 8);
    CHECK(block.top == 4);
    CHECK(block.count == Extent{4, 2});
    // At a corner: only existing texels, some of them partly visible.
    const TexelValues::Block corner =
        visible_cells(cells({PictureView::Fit::free, 50.0, 0.0, 0.0}, {210, 110}));
    CHECK(corner.left == 0);
    CHECK(corner.top == 0);
    CHECK(corner.count == Extent{3, 2});
}

TEST_CASE_FIXTURE(TexelInspection,
                  "values follow a moving view at once, otherwise five times per second") {
    PictureView there = at_50;
    there.x = 0.25;
    executor.draw(frame(1));
    update(at_50, 1.0);
    update(at_50, 1.01);
    REQUIRE(texels->picture().block());
    CHECK(texels->picture().block()->numbers[0] == Rgba{8, 4, 1, 1});
    CHECK(texels->picture().block()->numbers[7] == Rgba{11, 5, 1, 1});
    CHECK(texels->picture().placement().texel_width == 50.0);
    CHECK(texels->picture().is_light(0));  // 8, 4, 1 is brighter than white
    CHECK_FALSE(texels->is_pending());
    executor.draw(frame(2));
    update(at_50, 1.1);
    update(at_50, 1.11);
    CHECK(blue() == 1.0f);
    CHECK(texels->is_pending());
    update(at_50, 1.21);
    update(at_50, 1.22);
    CHECK(blue() == 2.0f);
    update(there, 1.23);
    update(there, 1.24);
    CHECK(texels->picture().block()->left == 3);
    CHECK(texels->picture().block()->numbers[0][0] == 3.0f);
    name = "another";
    update(there, 1.25);
    CHECK(texels->picture().block() == nullptr);  // the values belonged to another target
    update(there, 1.26);
    REQUIRE(texels->picture().block());
    update({PictureView::Fit::free, 8.0}, 1.27);
    CHECK(texels->picture().block() == nullptr);
    CHECK_FALSE(texels->is_pending());
}

TEST_CASE("a line covers the texels from its start to its end, or those of a row") {
    const TexelRows level = texels_along(ScanLine::along_row(5, 10), {20, 10});
    CHECK(level.count == Extent{20, 1});
    CHECK(level.first == std::array{0.5, 5.5});
    CHECK(level.across == std::array{1.0, 0.0});
    CHECK(ScanLine::along_row(5, 10).row({20, 10}) == 5);
    CHECK(ScanLine{}.row({320, 240}) == 120);
    CHECK_FALSE(ScanLine{{0.0, 0.1}, {1.0, 0.9}}.row({20, 10}).has_value());
    CHECK(texels_along({{0.5, 0.5}, {0.5, 0.5}}, {20, 10}).count == Extent{1, 1});
    CHECK(texels_along({{0.0, 0.0}, {0.0, 1.0}}, {20, 10}).count == Extent{10, 1});
}

TEST_CASE_FIXTURE(TexelInspection, "the waveform of a line contains the values of its texels") {
    executor.draw(frame(3));
    // From (15, 2) to (7, 6): eight to the left, four down.
    const ScanLine line{{0.76, 0.25}, {0.36, 0.65}};
    update(line, 1.0);
    update(line, 1.01);
    const Waveform& waveform = texels->waveform();
    const auto& numbers = waveform.numbers();
    REQUIRE(numbers.size() == 9);
    for (int i = 0; i < 9; ++i) {
        const std::array place{15 - i, 2 + (i + 1) / 2};
        CHECK(waveform.texel(static_cast<std::size_t>(i)) == place);
        CHECK(numbers[static_cast<std::size_t>(i)] ==
              Rgba{static_cast<float>(place[0]), static_cast<float>(place[1]), 3, 1});
    }
    CHECK(waveform.range() == PlotRange{0.0, 15.0});
    CHECK(waveform.channels() == 4);
    texels->update_waveform(nullptr, 1.02);
    CHECK(waveform.numbers().empty());
    CHECK_FALSE(texels->is_pending());
}

TEST_CASE("luminance uses the ITU-R BT.709 weights") {
    CHECK(std::abs(luminance_of({1, 1, 1, 0}) - 1.0) <= 1e-12);
    CHECK(std::abs(luminance_of({0.5f, 0, 0, 9}) - 0.1063) <= 1e-12);
    CHECK(std::abs(luminance_of({0, 2, 1, 0}) - 1.5026) <= 1e-12);
}
