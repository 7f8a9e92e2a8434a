// Each built-in look gives identical pictures with and without shared pictures.
#include "gpu/headless_context.h"
#include "looks/drawn_look.h"

#include <cmath>

namespace {
constexpr Extent size{96, 54};

Picture colors() {
    Picture picture;
    picture.extent = size;
    picture.pixels.resize(static_cast<std::size_t>(size.width) * size.height * 4);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        picture.pixels[i] = static_cast<float>((i * 2654435761U) % 1024U) / 1023.0f;
    return picture;
}

Beam figure(int frame) {
    Beam beam;
    for (int i = 0; i < 400; ++i) {
        const double turn = 0.0157 * i + 0.1 * frame;
        beam.push_back({static_cast<float>(0.8 * std::sin(3.0 * turn)),
                        static_cast<float>(0.8 * std::sin(2.0 * turn)), 1.0f,
                        static_cast<float>((399 - i) / 24000.0)});
    }
    return beam;
}

/// A look of which only the last pass is displayed.
class Seen {
public:
    Seen(const Look& look, const Programs& programs, const Values& values, Redraws frames)
        : m_executors(Executor(look, programs)) {
        m_executors.picture().set_values(values);
        REQUIRE(m_executors.picture().resize(size, size).has_value());
        REQUIRE(m_executors.set_source(colors(), 1.0).has_value());
        std::vector<bool> displayed(look.passes.size(), false);
        displayed.back() = true;
        REQUIRE(m_executors.picture().set_displayed(displayed, frames).has_value());
    }

    std::vector<float> picture_of(int frame) {
        m_executors.draw({frame, frame_span(frame, 60.0)}, figure(frame));
        const int last = static_cast<int>(m_executors.picture().look().passes.size()) - 1;
        return gpu::read_picture(m_executors.picture().target(last)).pixels;
    }
    std::size_t memory() const { return memory_of(m_executors.picture().plan()); }

private:
    Executors m_executors;
};

// Returns the ratio of target memory with and without shared pictures.
double check_bits(const std::string& name, const Values& values) {
    CAPTURE(name);
    const std::filesystem::path shaders = std::filesystem::path(AFTERGLOW_SOURCE_DIR) / "shaders";
    const LoadedLook loaded = load_look(shaders / name, shaders / "include");
    REQUIRE(loaded.look.has_value());
    const auto context = gpu::create_headless_context();
    REQUIRE(context.has_value());
    const auto programs = build_programs(*loaded.look);
    REQUIRE(programs.has_value());
    Seen apart(*loaded.look, *programs, values, Redraws::possible);
    Seen once(*loaded.look, *programs, values, Redraws::never);
    for (int frame = 1; frame <= 5; ++frame)
        CHECK(once.picture_of(frame) == apart.picture_of(frame));
    return static_cast<double>(once.memory()) / static_cast<double>(apart.memory());
}
}  // namespace

TEST_CASE("every look gives identical pictures with shared pictures") {
    for (const char* look : {"caffeine", "crt", "phosphor", "shadow-mask", "vector-beam"})
        CHECK(check_bits(look, {}) <= 1.0);
    for (const double bloom : {0.0, 1.0})
        for (const double kind : {0.0, 1.0})
            check_bits("phosphor", {{"bloom_kind", bloom}, {"beam_kind", kind}});
}

TEST_CASE("the charge and the light of a measured tube share a picture") {
    CHECK(check_bits("phosphor", {{"tube", 5.0}}) < 0.85);
}
