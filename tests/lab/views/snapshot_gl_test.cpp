#include "io/pictures/picture_file.h"
#include "lab/small_lab.h"
#include "lab/views/snapshot.h"

#include <cmath>

namespace {
PassView view_of(const char* pass) {
    PassView view;
    view.pass = pass;
    return view;
}

void save(SmallLab& small, const PassView& view, const char* name) {
    save_target(*small.lab().renderer(), view, small.folder() / name, small.lab().messages());
}

Picture saved(SmallLab& small, const PassView& view, const char* name) {
    save(small, view, name);
    const auto picture = load_picture(small.folder() / name);
    REQUIRE(picture.has_value());
    return *picture;
}
}  // namespace

TEST_CASE("a pass is saved with its values as EXR, and as displayed as PNG") {
    SmallLab small;
    small.lab().player().pause();
    small.update(2);
    const float frames = gpu::read_pixel(small.lab().renderer()->executor().target(0), 0, 0)[0];
    PassView view = view_of("sum");
    CHECK(saved(small, view, "sum.exr").pixels == std::vector<float>(8 * 8 * 4, frames));
    CHECK(small.lab().messages().notice()->text == "Saved \"sum\" to \"sum.exr\"");

    // In linear light, the sRGB value 0.5 is 0.214041.
    view.levels = {frames - 0.214041, frames + 1 - 0.214041};
    const Picture saved_picture = saved(small, view, "sum.png");
    CHECK(saved_picture.extent == Extent{8, 8});
    CHECK(std::abs(saved_picture.pixels[0] - 0.5f) <= 0.6f / 255.0f);
    view.levels = {frames + 1.0, frames + 2.0};
    view.marks_clipping = true;
    CHECK(saved(small, view, "dark.png").pixels[0] == 0.0f);
    CHECK(std::abs(saved(small, view, "dark.png").pixels[1] - 0.25f) <= 0.6f / 255.0f);
}

TEST_CASE("a failed save is reported, and a name without an extension becomes an EXR") {
    SmallLab small;
    save(small, view_of("show"), "show.bmp");
    CHECK(small.lab().messages().notice()->is_problem);
    save(small, view_of("show"), "show");
    CHECK(std::filesystem::exists(small.folder() / "show.exr"));
}
