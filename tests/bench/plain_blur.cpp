#include "bench/plain_blur.h"

#include "bench/article_texts.h"

#include <fmt/format.h>

#include <cmath>

namespace bench {

namespace {
std::string text_of(int taps, double sigma, const char* direction) {
    std::vector<double> weights;
    double sum = 0.0;
    for (int i = -(taps / 2); i <= taps / 2; ++i) {
        weights.push_back(std::exp(-0.5 * i * i / (sigma * sigma)));
        sum += weights.back();
    }
    std::string list;
    for (const double weight : weights)
        list += fmt::format("{}{:.9f}", list.empty() ? "" : ", ", weight / sum);
    return fmt::format(
        "#version 410 core\n"
        "uniform sampler2D image;\nout vec4 color;\n"
        "const float weights[{0}] = float[{0}]({1});\n"
        "void main() {{\n"
        "    vec3 sum = vec3(0.0);\n"
        "    vec2 size = vec2(textureSize(image, 0));\n"
        "    for (int i = 0; i < {0}; ++i)\n"
        "        sum += weights[i] * texture(image, (gl_FragCoord.xy + float(i - {2}) * {3}) / "
        "size).rgb;\n"
        "    color = vec4(sum, 1.0);\n}}\n",
        taps, list, taps / 2, direction);
}

GLuint made_vertices() {
    GLuint id = 0;
    glGenVertexArrays(1, &id);
    return id;
}

GLuint made_sampler() {
    GLuint id = 0;
    glGenSamplers(1, &id);
    glSamplerParameteri(id, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glSamplerParameteri(id, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glSamplerParameteri(id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glSamplerParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    return id;
}
}  // namespace

PlainBlur::PlainBlur(Extent extent)
    : m_lit(extent, GL_RGBA16F, false),
      m_across(std::make_unique<plain::Surface>(extent, GL_RGBA16F, false)),
      m_down(std::make_unique<plain::Surface>(extent, GL_RGBA16F, false)),
      m_vertices(made_vertices()),
      m_sampler(made_sampler()) {
    m_lit.begin();
    glEnable(GL_SCISSOR_TEST);
    glScissor(extent.width / 2, extent.height / 2, 1, 1);
    glClearColor(1.0f, 1.0f, 1.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glDisable(GL_SCISSOR_TEST);
}

Result<PlainBlur> PlainBlur::make(Extent extent, int taps, double sigma) {
    PlainBlur blur(extent);
    Stage vertex;
    vertex.text = texts::cover_vertex;
    for (const char* direction : {"vec2(1.0, 0.0)", "vec2(0.0, 1.0)"}) {
        Stage fragment;
        fragment.text = text_of(taps, sigma, direction);
        auto program = gpu::Program::build(vertex, fragment);
        if (!program)
            return fail(program.error());
        program->set_unit(*program->find_uniform("image"), 0);
        blur.m_programs.push_back(std::move(*program));
    }
    return blur;
}

void PlainBlur::draw() const {
    glBindVertexArray(m_vertices.get());
    glActiveTexture(GL_TEXTURE0);
    glBindSampler(0, m_sampler.get());
    const auto step = [&](const plain::Surface& to, const plain::Surface& from,
                          const gpu::Program& program) {
        to.aim();
        program.use();
        glBindTexture(GL_TEXTURE_2D, from.texture());
        glDrawArrays(GL_TRIANGLES, 0, 3);
    };
    step(*m_across, m_lit, m_programs[0]);
    step(*m_down, *m_across, m_programs[1]);
    glBindSampler(0, 0);
}

Picture PlainBlur::read(const plain::Surface& surface) {
    return {surface.extent(), 4, Encoding::linear, surface.read()};
}

}  // namespace bench
