#include "gpu/objects/texels.h"
#include "graph/inspect/displayed_luminance.h"
#include "graph/looks.h"
#include "model/look/color.h"

#include <limits>

namespace {
struct Seeing : Headless {
    Result<Viewer> viewer = Viewer::make();
    Result<gpu::Canvas> view = gpu::Canvas::make({1, 1}, Format::rgba8);

    // The result of the viewer itself: display-encoded bytes.
    double viewed(const Rgba& rgba, const ViewOptions& options) {
        REQUIRE((viewer && view));
        auto texel = gpu::Texture::make({1, 1}, Format::rgba32f);
        REQUIRE(texel.has_value());
        texel->upload(rgba);
        viewer->draw(*texel, *view, options);
        const Rgba shown = gpu::read_pixel(view->texture(), 0, 0);
        return 0.2126 * srgb_decode(shown[0]) + 0.7152 * srgb_decode(shown[1]) +
               0.0722 * srgb_decode(shown[2]);
    }
};
}  // namespace

TEST_CASE_FIXTURE(Seeing, "the luminance of a texel matches the viewer's output") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<Rgba> texels{{0.2f, 0.5f, 0.8f, 1}, {0, 0, 0, 0},
                                   {2.5f, 0.1f, 0, 0.5f}, {-0.5f, 0.25f, 0.5f, 1},
                                   {nan, 0.5f, 0, 1},     {1, 1, 1, 1}};
    std::vector<ViewOptions> views;
    for (const Encoding encoding : {Encoding::linear, Encoding::display})
        for (ViewOptions one :
             {ViewOptions{}, ViewOptions{.levels = {-1, 3}, .exposure_stops = 1.5},
              ViewOptions{.channels = Channels::alpha},
              ViewOptions{.channels = Channels::luminance, .is_false_color = true},
              ViewOptions{.is_false_color = true}, ViewOptions{.marks_flaws = true},
              ViewOptions{.marks_clipping = true}}) {
            one.encoding = encoding;
            views.push_back(one);
        }
    for (const ViewOptions& options : views)
        for (const Rgba& texel : texels) {
            CAPTURE(texel[0]);
            CAPTURE(static_cast<int>(options.channels));
            CAPTURE(options.marks_flaws);
            CAPTURE(options.marks_clipping);
            CAPTURE(options.is_false_color);
            CAPTURE(static_cast<int>(options.encoding));
            CHECK(std::abs(displayed_luminance(texel, Format::rgba32f, options) -
                           viewed(texel, options)) <= 0.01);  // within a few 8-bit levels
        }
}
