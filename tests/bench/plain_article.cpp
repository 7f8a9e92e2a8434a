#include "bench/plain_article.h"

#include "bench/article_texts.h"

#include <algorithm>
#include <cmath>

namespace bench {

using plain::Surface;

namespace {
// Variance in px^2 that the article's blur adds: its taps are 3 texels of half size apart.
double variance_of_article() {
    const std::array weights{0.19648255, 0.29690696, 0.21959561, 0.04393693,
                             0.01096343, 0.00183638, 0.00021493};
    double sum = weights[0];
    double moment = 0.0;
    for (int i = 1; i < 7; ++i) {
        const double apart = 6.0 * i;
        sum += 2.0 * weights[static_cast<std::size_t>(i)];
        moment += 2.0 * weights[static_cast<std::size_t>(i)] * apart * apart;
    }
    return moment / sum + 0.25;  // plus that of a texel of half size
}

// The variance in px^2 added by downsampling to 1 / 2^levels of the size and upsampling to half
// size. Each step adds 3/4 of a squared texel, but the first one 1/4.
double variance_of_levels(int levels) {
    const double ping_pong = 0.5 * (std::pow(4.0, levels) - 1.0);
    return ping_pong - 0.5 - 0.75;  // without the last upsampling
}

Extent halved(Extent extent) {
    return {(extent.width + 1) / 2, (extent.height + 1) / 2};
}

std::vector<double> size_of(Extent extent) {
    return {1.0 * extent.width, 1.0 * extent.height};
}

const std::vector<double> beam_color{0.2, 1.0, 0.3};
constexpr double ceiling = 2.5;

GLuint new_sampler(GLint filter, GLint wrap) {
    GLuint id = 0;
    glGenSamplers(1, &id);
    glSamplerParameteri(id, GL_TEXTURE_MIN_FILTER, filter);
    glSamplerParameteri(id, GL_TEXTURE_MAG_FILTER, filter);
    glSamplerParameteri(id, GL_TEXTURE_WRAP_S, wrap);
    glSamplerParameteri(id, GL_TEXTURE_WRAP_T, wrap);
    return id;
}

Stage stage_of(const std::string& text) {
    Stage stage;
    stage.text = text;
    return stage;
}
}  // namespace

Picture PlainArticle::read(const std::vector<float>& texels, Extent extent) {
    Picture picture{extent, 4, Encoding::linear, {}};
    const auto row = static_cast<std::ptrdiff_t>(extent.width) * 4;
    for (auto end = texels.end(); end != texels.begin(); end -= row)
        picture.pixels.insert(picture.pixels.end(), end - row, end);
    return picture;
}

Surface* const* PlainArticle::add_surface(Extent extent, GLenum format) {
    m_surfaces.push_back(std::make_unique<Surface>(extent, format, false));
    m_places.push_back(std::make_unique<Surface*>(m_surfaces.back().get()));
    return m_places.back().get();
}

Result<PlainArticle> PlainArticle::make(const ArticleSettings& settings) {
    PlainArticle article(settings);
    for (auto& phosphor : article.m_phosphor)
        phosphor = std::make_unique<Surface>(settings.extent, settings.format, false);
    article.m_glowing = std::make_unique<std::array<Surface*, 2>>(
        std::array{article.m_phosphor[0].get(), article.m_phosphor[1].get()});
    article.m_samplers.emplace_back(new_sampler(GL_NEAREST, GL_CLAMP_TO_EDGE));
    article.m_samplers.emplace_back(new_sampler(GL_LINEAR, GL_CLAMP_TO_EDGE));
    article.m_samplers.emplace_back(new_sampler(GL_LINEAR, GL_CLAMP_TO_BORDER));
    const bool is_literal = settings.way == Way::literal;
    if (auto added = is_literal ? article.add_literal() : article.add_best(); !added)
        return fail(added.error());
    article.make_vertices();
    return article;
}

Result<void> PlainArticle::add(const std::string& fragment, Step step, const Numbers& numbers) {
    const char* vertex = step.is_beam ? texts::beam_vertex : texts::cover_vertex;
    auto program = gpu::Program::build(stage_of(vertex), stage_of(fragment));
    if (!program)
        return fail(program.error());
    for (const auto& [name, components] : numbers)
        program->write(name, components);
    int unit = 0;
    std::erase_if(step.reads, [&](const Read& read) {
        const gpu::Uniform* uniform = program->find_uniform(read.uniform);
        if (uniform)
            program->set_unit(*uniform, unit++);
        return !uniform;
    });
    m_steps.push_back({std::move(step), std::move(*program)});
    return {};
}

Result<void> PlainArticle::add_beam(Surface* const* target, bool clears) {
    const double point_size = 2.0 * std::min(m_settings.extent.height / 512.0, 2.0);
    const bool has_colour = m_settings.way != Way::best_one_colour;
    return add(texts::beam_fragment, {target, {}, clears, true},
               {{"point_size", {point_size}},
                {"beam_color", has_colour ? beam_color : std::vector<double>{1.0, 1.0, 1.0}}});
}

Result<void> PlainArticle::add_composite(Surface* const* bloom, const char* rest, bool clears) {
    m_bloom = *bloom;
    const Extent extent = m_settings.extent;
    const Extent covered{2 * m_bloom->extent().width, 2 * m_bloom->extent().height};
    return add(
        std::string(texts::composite_head) + texts::glass + rest,
        {add_surface(extent, GL_RGBA8), {{"phosphor", &(*m_glowing)[0]}, {"bloom", bloom}}, clears},
        {{"size", size_of(extent)},
         {"half_size", {1.0 * extent.width / covered.width, 1.0 * extent.height / covered.height}},
         {"beam_color", beam_color},
         {"bloom_intensity", {m_settings.bloom_intensity}}});
}

Result<void> PlainArticle::add_literal() {
    const Extent extent = m_settings.extent;
    const Extent half{extent.width / 2, extent.height / 2};
    Surface* const* beam = add_surface(extent, m_settings.format);
    Surface* const* across = add_surface(half, m_settings.format);
    Surface* const* bloom = add_surface(half, m_settings.format);
    if (auto added = add_beam(beam, true); !added)
        return added;
    if (auto added =
            add(texts::phosphor_fragment,
                {&(*m_glowing)[0], {{"current", beam}, {"previous", &(*m_glowing)[1]}}, true},
                {{"size", size_of(extent)}});
        !added)
        return added;
    const auto blur = [&](Surface* const* from, Surface* const* to, double x, double y) {
        return add(texts::blur_fragment, {to, {{"image", from}}, true},
                   {{"size", size_of(half)}, {"direction", {x, y}}});
    };
    if (auto added = blur(&(*m_glowing)[0], across, 1.0, 0.0); !added)
        return added;
    if (auto added = blur(across, bloom, 0.0, 1.0); !added)
        return added;
    return add_composite(bloom, texts::composite_literal, true);
}

Result<void> PlainArticle::add_best() {
    // A single number for all channels grows until the weakest channel reaches its ceiling.
    const double max_kept = m_settings.way == Way::best_colour ? ceiling : ceiling / beam_color[0];
    if (auto added = add(texts::fading_fragment,
                         {&(*m_glowing)[0], {{"previous", &(*m_glowing)[1], Reading::exact}}},
                         {{"most", {max_kept}}});
        !added)
        return added;
    if (auto added = add_beam(&(*m_glowing)[0], false); !added)
        return added;
    const auto bloom = add_pyramid();
    if (!bloom)
        return fail(bloom.error());
    return add_composite(
        *bloom,
        m_settings.way == Way::best_colour ? texts::composite_best : texts::composite_one_colour,
        false);
}

// The levels below the article's width, and the share of the last one that gives this width.
Result<Surface* const*> PlainArticle::add_pyramid() {
    constexpr int levels = 4;
    const double share = (variance_of_article() - variance_of_levels(levels - 1)) /
                         (variance_of_levels(levels) - variance_of_levels(levels - 1));
    std::vector<Surface* const*> down;
    Extent extent = m_settings.extent;
    for (int level = 0; level < levels; ++level) {
        extent = halved(extent);
        Surface* const* from = level == 0 ? &(*m_glowing)[0] : down.back();
        down.push_back(add_surface(extent, m_settings.format));
        if (auto added = add(level == 0 ? texts::halve_fragment : texts::reduce_fragment,
                             {down.back(), {{"image", from, Reading::cut}}}, {{"most", {ceiling}}});
            !added)
            return fail(added.error());
    }
    Surface* const* wide = down.back();
    for (std::size_t level = down.size() - 1; level-- > 0;) {
        Surface* const* to = add_surface((*down[level])->extent(), m_settings.format);
        const double part = level + 2 == down.size() ? share : 1.0;
        if (auto added =
                add(texts::widen_fragment,
                    {to, {{"image", wide, Reading::cut}, {"own", down[level], Reading::exact}}},
                    {{"share", {part}}});
            !added)
            return fail(added.error());
        wide = to;
    }
    return wide;
}

void PlainArticle::make_vertices() {
    GLuint id = 0;
    glGenBuffers(1, &id);
    m_buffer.emplace_back(id);
    glGenVertexArrays(1, &id);
    m_vertices.emplace_back(id);
    glBindVertexArray(id);
    glBindBuffer(GL_ARRAY_BUFFER, m_buffer.front().get());
    for (const Made& made : m_steps)
        if (made.step.is_beam) {
            const auto at = [&](const char* name) {
                return static_cast<GLuint>(made.program.attribute_location(name));
            };
            const auto* intensity = reinterpret_cast<const void*>(offsetof(BeamPoint, intensity));
            glEnableVertexAttribArray(at("position"));
            glVertexAttribPointer(at("position"), 2, GL_FLOAT, GL_FALSE, sizeof(BeamPoint),
                                  nullptr);
            glEnableVertexAttribArray(at("intensity"));
            glVertexAttribPointer(at("intensity"), 1, GL_FLOAT, GL_FALSE, sizeof(BeamPoint),
                                  intensity);
        }
}

void PlainArticle::draw_step(const Made& made, std::size_t points) const {
    const Step& step = made.step;
    step.clears ? (*step.target)->begin() : (*step.target)->aim();
    made.program.use();
    for (std::size_t unit = 0; unit < step.reads.size(); ++unit) {
        const Read& read = step.reads[unit];
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        glBindTexture(GL_TEXTURE_2D, (*read.surface)->texture());
        glBindSampler(static_cast<GLuint>(unit),
                      m_samplers[static_cast<std::size_t>(read.reading)].get());
    }
    if (!step.is_beam) {
        glDrawArrays(GL_TRIANGLES, 0, 3);
        return;
    }
    glEnable(GL_BLEND);
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(points));
    glDisable(GL_BLEND);
}

void PlainArticle::draw(std::span<const BeamPoint> points) {
    std::swap((*m_glowing)[0], (*m_glowing)[1]);
    glEnable(GL_PROGRAM_POINT_SIZE);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE);
    glBindVertexArray(m_vertices.front().get());
    glBindBuffer(GL_ARRAY_BUFFER, m_buffer.front().get());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(points.size_bytes()), points.data(),
                 GL_STREAM_DRAW);
    for (const Made& made : m_steps)
        draw_step(made, points.size());
    for (GLuint unit = 0; unit < 2; ++unit)
        glBindSampler(unit, 0);
}

}  // namespace bench
