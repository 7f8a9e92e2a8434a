#pragma once

#include "gpu/headless_context.h"
#include "gpu/objects/readback.h"
#include "lab/offline/offline.h"
#include "problems_of.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <memory>

/// A look from a folder of the source tree, with every target in 32-bit floats. Tests supply its
/// beam.
class DrawnLook {
public:
    /// `source`: the size of its source; empty: that of the picture.
    DrawnLook(const std::filesystem::path& folder, Extent extent, const Values& values = {},
              Extent source = {}) {
        const std::filesystem::path tree(AFTERGLOW_SOURCE_DIR);
        auto context = gpu::create_headless_context();
        REQUIRE(context.has_value());
        m_context = std::move(*context);
        LoadedLook loaded = load_look(tree / folder, tree / "shaders" / "include");
        REQUIRE_MESSAGE(loaded.look.has_value(), problems_of(loaded.look));
        for (Pass& pass : loaded.look->passes)
            pass.format = Format::rgba32f;
        auto programs = build_programs(*loaded.look);
        REQUIRE_MESSAGE(programs.has_value(), problems_of(programs));
        m_executors =
            std::make_unique<Executors>(Executor(std::move(*loaded.look), std::move(*programs)));
        m_executors->picture().set_values(values);  // first, because sizes can depend on them
        REQUIRE(
            m_executors->picture().resize(extent, source.is_empty() ? extent : source).has_value());
    }
    ~DrawnLook() { m_context->make_current(); }
    DrawnLook(const DrawnLook&) = delete;
    DrawnLook& operator=(const DrawnLook&) = delete;

    void set_values(const Values& values) {
        m_context->make_current();
        m_executors->picture().set_values(values);
    }
    /// The next frame is the first one: no light is left, and the beam has no previous point.
    void restart() {
        m_transport.restart();
        m_executors->picture().clear_history();
    }

    Executors& executors() {
        m_context->make_current();
        return *m_executors;
    }
    /// Of the source frames that begin from now on.
    void set_subframes(int count) { m_transport.set_subframes(count); }
    /// Draws a frame of 1/fps with these beam points.
    void draw(const Beam& beam = {}, double fps = 60.0) {
        m_context->make_current();  // another look's context may be current
        m_executors->draw(m_transport.advance_fixed(fps), beam);
    }

    Picture target(const char* pass) const {
        m_context->make_current();
        const Executor& executor = m_executors->picture();
        return gpu::read_picture(executor.target(*find_pass(executor.look(), pass)));
    }

private:
    std::unique_ptr<gpu::Context> m_context;
    std::unique_ptr<Executors> m_executors;
    Transport m_transport;
};

/// The sum of a channel over all pixels.
inline double sum_of(const Picture& picture, std::size_t channel = 0) {
    double sum = 0.0;
    for (std::size_t i = channel; i < picture.pixels.size(); i += 4)
        sum += static_cast<double>(picture.pixels[i]);
    return sum;
}

inline double value_at(const Picture& picture, int x, int y, std::size_t channel = 0) {
    return static_cast<double>(picture.pixels[picture.index(x, y) + channel]);
}
