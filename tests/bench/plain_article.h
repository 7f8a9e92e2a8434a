#pragma once

#include "model/look/picture.h"
#include "model/plan/beam.h"
#include "parity/plain_chain.h"

#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace bench {

/// How the article's frame is drawn: literally, or the same picture in fewer steps.
enum class Way { literal, best_colour, best_one_colour };

struct ArticleSettings {
    Way way = Way::literal;
    Extent extent;
    GLenum format = GL_RGBA16F;  // of light
    double bloom_intensity = 0.6;
};

/// The article's frame in plain GL, without lookups, checks or timers.
class PlainArticle {
public:
    static Result<PlainArticle> make(const ArticleSettings& settings);

    void draw(std::span<const BeamPoint> points);
    /// The top row first.
    Picture picture() const { return read(m_surfaces.back()->read(), m_settings.extent); }
    Picture bloom() const { return read(m_bloom->read(), m_bloom->extent()); }
    Picture phosphor() const { return read((*m_glowing)[0]->read(), m_settings.extent); }

private:
    enum class Reading { exact, linear, cut };  // cut: black beyond the edge
    struct Read {
        const char* uniform;
        plain::Surface* const* surface;
        Reading reading = Reading::linear;
    };
    struct Step {
        plain::Surface* const* target;
        std::vector<Read> reads = {};
        bool clears = false;
        bool is_beam = false;
    };
    struct Made {
        Step step;
        gpu::Program program;
    };
    using Numbers = std::map<std::string, std::vector<double>>;

    explicit PlainArticle(const ArticleSettings& settings) : m_settings(settings) {}
    static Picture read(const std::vector<float>& texels, Extent extent);
    plain::Surface* const* add_surface(Extent extent, GLenum format);
    Result<void> add(const std::string& fragment, Step step, const Numbers& numbers = {});
    Result<void> add_beam(plain::Surface* const* target, bool clears);
    Result<void> add_literal();
    Result<void> add_best();
    Result<plain::Surface* const*> add_pyramid();
    Result<void> add_composite(plain::Surface* const* bloom, const char* rest, bool clears);
    void make_vertices();
    void draw_step(const Made& made, std::size_t points) const;

    ArticleSettings m_settings;
    std::vector<std::unique_ptr<plain::Surface>> m_surfaces;  // the last one is the screen
    std::vector<std::unique_ptr<plain::Surface*>> m_places;
    std::array<std::unique_ptr<plain::Surface>, 2> m_phosphor;  // this frame, previous frame
    std::unique_ptr<std::array<plain::Surface*, 2>> m_glowing;
    plain::Surface* m_bloom = nullptr;
    std::vector<Made> m_steps;
    std::vector<gpu::Name<plain::delete_buffer_name>> m_buffer;
    std::vector<gpu::Name<plain::delete_vertex_array_name>> m_vertices;
    std::vector<gpu::Name<plain::delete_sampler_name>> m_samplers;  // by Reading
};

}  // namespace bench
