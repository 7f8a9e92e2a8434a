#include "graph/looks.h"
#include "lab/inspect/inspected_texture.h"

namespace {
// The first pass writes the frame number. The second reads it two frames late, with an image and
// the source.
Look watched() {
    Look look = look_of(
        {pass("number", "uniform int u_frame;\nvoid main() { color = vec4(u_frame); }\n"),
         pass("late",
              "uniform sampler2D old, lut, scene;\n"
              "void main() { color = texture(old, uv) + texture(lut, uv) + texture(scene, uv); }\n",
              {reads("old", "number", 2),
               {"lut", Input::From::image, "lut", 0, {Filter::linear, Wrap::edge, true}},
               {"scene", Input::From::source, "", 0, {}}})});
    look.images = {{"lut", "lut.png", {}, true}};
    look.source_encoding = Encoding::linear;
    return look;
}

struct Watching : Headless {
    Executor executor = executor_of(watched(), {4, 4}, {1, 1});
    PassView view;

    Watching() {
        const std::vector<float> steps{0.25f, 0.75f};
        REQUIRE(executor.set_image("lut", {{2, 1}, 1, Encoding::linear, steps}).has_value());
        REQUIRE(executor.set_source({{1, 1}, 1, Encoding::linear, {0.75f}}).has_value());
        for (int n = 1; n <= 5; ++n)
            executor.draw(frame(n));
        view.inspect("late");
    }
    float seen() const {
        const auto inspected = inspected_texture(executor, view);
        REQUIRE(inspected.has_value());
        return gpu::read_pixel(*inspected->texture, 0, 0)[0];
    }
    std::string label() const { return inspected_texture(executor, view).value().choice.label(); }
};
}  // namespace

TEST_CASE_FIXTURE(Watching, "passes, previous frames, the source and images can be inspected") {
    std::vector<std::string> labels;
    for (const TextureChoice& choice : executor.textures().list())
        labels.push_back(choice.label());
    CHECK(labels == std::vector<std::string>{"number", "late", "source", "lut"});
    CHECK(frame_count(executor, {Input::From::pass, "number"}) == 3);
    CHECK(frame_count(executor, {Input::From::pass, "late"}) == 1);
    CHECK(frame_count(executor, {Input::From::image, "lut"}) == 1);
    CHECK(seen() == 3.0f + 0.25f + 0.75f);  // frame 5 - 2; the left texel of the image
    for (const int ago : {0, 1, 2}) {
        view.inspect({Input::From::pass, "number", ago});
        CHECK(seen() == static_cast<float>(5 - ago));
    }
    CHECK(label() == "number@2");
    view.inspect(TextureChoice{Input::From::source, {}});
    CHECK(view.pass == "number");
    CHECK(seen() == 0.75f);
    view.inspect({Input::From::image, "lut", 0, 1});
    CHECK(label() == "lut mip 1");
    CHECK(inspected_texture(executor, view)->extent() == Extent{1, 1});
    CHECK(inspected_texture(executor, view)->encoding == Encoding::display);  // unchanged data
    view.inspect("late");
    CHECK(label() == "late");
    CHECK(inspected_texture(executor, view)->encoding == Encoding::display);  // the last pass
}

TEST_CASE_FIXTURE(Watching, "a missing texture falls back to the pass that was chosen with it") {
    for (const TextureChoice& gone :
         {TextureChoice{Input::From::image, "gone"}, TextureChoice{Input::From::source, {}, 1},
          TextureChoice{Input::From::image, "lut", 0, 2},
          TextureChoice{Input::From::pass, "late", 9}}) {
        view.inspect(gone);
        CHECK(label() == "late");
        CHECK(inspected_texture(executor, view)->choice.is_present_pass());
    }
    view.pass = "gone";
    CHECK_FALSE(inspected_texture(executor, view).has_value());
}
