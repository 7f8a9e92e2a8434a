#pragma once

#include "base/text.h"
#include "gpu/headless_context.h"
#include "gpu/objects/readback.h"
#include "lab/offline/offline.h"
#include "problems_of.h"

#include <doctest/doctest.h>

#include <cmath>

/// Phosphor with a beam or a source picture supplied by the test, and its targets in 32-bit floats.
class Tube {
public:
    enum class By { signal, picture };

    explicit Tube(const Values& values, Extent extent = {128, 128}, By by = By::signal) {
        auto context = gpu::create_headless_context();
        REQUIRE(context.has_value());
        m_context = std::move(*context);
        LoadedLook loaded =
            load_look(std::filesystem::path(AFTERGLOW_SOURCE_DIR) / "shaders" / "phosphor",
                      std::filesystem::path(AFTERGLOW_SOURCE_DIR) / "shaders" / "include",
                      {.is_picture_driven = by == By::picture});
        REQUIRE_MESSAGE(loaded.look.has_value(), problems_of(loaded.look));
        for (Pass& pass : loaded.look->passes)
            if (pass.name != "persistence")  // which must keep its own format
                pass.format = Format::rgba32f;
        auto programs = build_programs(*loaded.look);
        REQUIRE(programs.has_value());
        m_executors =
            std::make_unique<Executors>(Executor(std::move(*loaded.look), std::move(*programs)));
        m_extent = extent;
        restart(values);
    }

    /// Restarts with the first frame and other values.
    void restart(const Values& values) {
        m_context->make_current();  // another tube's context may be current
        m_executors->picture().set_values(values);
        REQUIRE(m_executors->picture().resize(m_extent, m_extent).has_value());
        m_executors->picture().clear_history();
        m_number = 0;
    }

    /// From now on only the last pass is displayed.
    void look_at_the_last() {
        m_context->make_current();
        std::vector<bool> displayed(m_executors->picture().look().passes.size(), false);
        displayed.back() = true;
        REQUIRE(m_executors->picture().set_displayed(displayed, Redraws::possible).has_value());
    }
    bool is_drawn_onto(const char* pass) const {
        const Executor& executor = m_executors->picture();
        const auto index = static_cast<std::size_t>(*find_pass(executor.look(), pass));
        return executor.plan().targets[index].onto.has_value();
    }

    /// The source picture of the next frames.
    void show(const Picture& picture) {
        m_context->make_current();
        REQUIRE(m_executors->picture().set_source(picture).has_value());
    }

    /// Draws one frame of 1/fps with these points.
    void draw(const Beam& beam, double fps = 60.0) {
        m_context->make_current();
        ++m_number;
        m_executors->draw({m_number, frame_span(m_number, fps)}, beam);
    }
    void rest(int count, double fps = 60.0) {
        for (int i = 0; i < count; ++i)
            draw({}, fps);
    }

    const Look& look() const { return m_executors->picture().look(); }
    Picture target(const char* pass) const {
        m_context->make_current();
        const Executor& executor = m_executors->picture();
        return gpu::read_picture(executor.target(*find_pass(executor.look(), pass)));
    }
    /// The sum of a channel over all pixels.
    double sum(const char* pass, std::size_t channel = 1) const {
        const Picture picture = target(pass);
        double sum = 0.0;
        const auto channels = static_cast<std::size_t>(picture.channels);
        for (std::size_t i = channel; i < picture.pixels.size(); i += channels)
            sum += static_cast<double>(picture.pixels[i]);
        return sum;
    }
    double at(const char* pass, int x, int y, std::size_t channel = 1) const {
        const Picture picture = target(pass);
        return static_cast<double>(picture.pixels[picture.index(x, y) + channel]);
    }

    /// Enough beam everywhere to bring the phosphor to its ceiling.
    Beam flood() const {
        Beam beam;
        for (float y = -1.0f; y <= 1.0f; y += 0.04f)
            for (float x = -1.0f; x <= 1.0f; x += 0.04f)
                beam.push_back({x, y, 1e4f, 0.0f});
        return beam;
    }

    Tube(const Tube&) = delete;
    Tube& operator=(const Tube&) = delete;
    ~Tube() { m_context->make_current(); }

private:
    std::unique_ptr<gpu::Context> m_context;
    std::unique_ptr<Executors> m_executors;
    Extent m_extent;
    std::int64_t m_number = 0;
};

/// Settings without anything that would change a flat field in the composite. The beam is so wide
/// that flood() makes a flat field.
inline Values plain_glass() {
    return {{"beam_width", Value(16.0)},
            {"bloom_intensity", Value(0.0)},
            {"scanline_strength", Value(0.0)},
            {"graticule", Value(0.0)},
            {"vignette", Value(0.0)},
            {"curvature", Value(0.0)},
            {"aberration", Value(0.0)},
            {"corner_radius", Value(0.0)},
            {"ambient_glass", Value(std::vector<double>{0, 0, 0})},
            {"dither", Value(0.0)},
            {"display_encode", Value(0.0)},
            {"beam_color", Value(std::vector<double>{1, 1, 1})}};
}

inline Values with(Values values, const Values& more) {
    for (const auto& [name, value] : more)
        values[name] = value;
    return values;
}
