#include "graph/looks.h"

#include <algorithm>

namespace {
/// Column + 10 * row + 100 * time.
class CountedTexels : public SoundTexels {
public:
    void read(const SoundTexture& texture, double seconds, std::span<float> levels) const override {
        const auto columns = static_cast<std::size_t>(texture.columns);
        for (std::size_t i = 0; i < levels.size(); ++i) {
            const std::size_t row = i / columns;
            levels[i] = static_cast<float>(static_cast<double>(i % columns) +
                                           10.0 * static_cast<double>(row) + 100.0 * seconds);
        }
    }
};

constexpr SoundTexture eight{SoundTexture::Holds::wave, 8};

Look listening() {
    Input hears = reads("heard", "");
    hears.from = Input::From::sound;
    hears.sound = eight;
    return look_of({pass("ear",
                         "uniform sampler2D heard;\nvoid main() { color = vec4(texelFetch(heard, "
                         "ivec2(3, 1), 0).rg, textureSize(heard, 0)); }\n",
                         {hears})});
}
}  // namespace

TEST_CASE_FIXTURE(Headless, "a pass reads the sound at the end of the frame") {
    Executor executor = executor_of(listening());
    const CountedTexels texels;
    Frame heard = frame(30);
    heard.sound = &texels;
    executor.draw(heard);
    CHECK(pixel(executor, 0) == Rgba{63.0f, 63.0f, 8.0f, 2.0f});
    heard = frame(60);
    heard.sound = &texels;
    executor.draw(heard);
    CHECK(red(executor, 0) == 113.0f);
}

TEST_CASE_FIXTURE(Headless, "without a sound a pass reads silence") {
    Executor executor = executor_of(listening());
    executor.draw(frame(1));
    CHECK(red(executor, 0) == 0.5f);
}

TEST_CASE_FIXTURE(Headless, "the sound texture is one of the textures that can be inspected") {
    Executor executor = executor_of(listening());
    executor.draw(frame(1));
    const TextureChoice wanted{Input::From::sound, {}, 0, 0, eight};
    const auto all = executor.textures().list();
    REQUIRE(std::ranges::find(all, wanted) != all.end());
    CHECK(wanted.label() == "sound wave 8");
    REQUIRE(executor.texture(wanted));
    CHECK(executor.texture(wanted)->extent() == Extent{8, 2});
    CHECK(executor.drawer().report(0).samplers.front().reads == wanted);
}

TEST_CASE_FIXTURE(Headless, "an edited look that starts to use sound reads it at once") {
    Executor executor = executor_of(look_of({counter()}));
    executor.draw(frame(1));
    const Look edited = listening();
    REQUIRE(executor.replace(edited, programs_of(edited)));
    const CountedTexels texels;
    Frame heard = frame(60);
    heard.sound = &texels;
    executor.draw(heard);
    CHECK(red(executor, 0) == 113.0f);
}

TEST_CASE_FIXTURE(Headless, "a pass reads the start time of its frame, and the date") {
    Pass clock =
        pass("clock",
             "uniform float start; uniform float since; uniform vec4 date;\n"
             "void main() { color = vec4(start, since, uv.x < 0.5 ? date.xy : date.zw); }\n");
    clock.built_ins = {
        {"start", BuiltIn::time_before}, {"since", BuiltIn::delta_before}, {"date", BuiltIn::date}};
    Executor executor = executor_of(look_of({clock}));
    Frame first = frame(1);
    first.date = {2024, 3, 5, 7.5};
    executor.draw(first);
    CHECK(pixel(executor, 0) == Rgba{0.0f, 0.0f, 2024.0f, 3.0f});
    CHECK(pixel(executor, 0, 3) == Rgba{0.0f, 0.0f, 5.0f, 7.5f});
    executor.draw(frame(31));
    CHECK(pixel(executor, 0)[0] == doctest::Approx(0.5));
    CHECK(pixel(executor, 0)[1] == doctest::Approx(1.0 / 60.0));
}
