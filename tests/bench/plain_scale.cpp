#include "bench/plain_scale.h"

#include <fmt/format.h>

namespace bench {

namespace {
constexpr const char* scale_vertex = R"(#version 410 core
out vec2 uv;
void main() {
    uv = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(2.0 * uv - 1.0, 0.0, 1.0);
}
)";

GLuint scale_vertices() {
    GLuint id = 0;
    glGenVertexArrays(1, &id);
    return id;
}

GLuint scale_sampler() {
    GLuint id = 0;
    glGenSamplers(1, &id);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glSamplerParameteri(id, filter, GL_NEAREST);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glSamplerParameteri(id, wrap, GL_CLAMP_TO_EDGE);
    return id;
}

std::string fragment_of(const ScaleSize& size, int pass) {
    std::string text =
        "#version 410 core\nuniform sampler2D before;\nuniform sampler2D former;\n"
        "uniform float u_time;\nin vec2 uv;\nout vec4 color;\n";
    std::string sum;
    for (int i = 0; i < size.parameters_per_pass; ++i) {
        const std::string name = scale_parameter(pass, i);
        text +=
            fmt::format("uniform float {} = {};  // @range 0 1\n", name, scale_initial(pass, i));
        sum += (i > 0 ? " + " : "") + name;
    }
    return text + fmt::format(
                      "void main() {{\n"
                      "    vec4 mean = 0.5 * (texture(before, uv) + texture(former, uv));\n"
                      "    color = fract(mean + 0.01 * u_time + vec4({}) + uv.xyxy);\n"
                      "}}\n",
                      sum);
}
}  // namespace

std::string scale_parameter(int pass, int parameter) {
    return fmt::format("knob_{}_{}", pass, parameter);
}

double scale_initial(int pass, int parameter) {
    return 0.25 + 0.125 * ((pass + parameter) % 4);
}

ScaleTexts scale_texts(const ScaleSize& size) {
    ScaleTexts texts;
    std::string passes;
    for (int i = 0; i < size.passes; ++i) {
        const std::string sampler = R"("filter": "nearest", "wrap": "edge")";
        passes += fmt::format(
            R"({}{{"name": "pass{}", "fragment": "pass{}.frag", "format": "{}", "size": [{}, {}],
 "inputs": {{"before": {{"from": "pass{}{}", {}}}, "former": {{"from": "pass{}@1", {}}}}}}})",
            i > 0 ? ",\n" : "", i, i, size.format, size.side, size.side, std::max(i - 1, 0),
            i > 0 ? "" : "@1", sampler, i, sampler);
        texts.fragments.push_back(fragment_of(size, i));
    }
    texts.manifest = fmt::format(
        R"({{"format": "afterglow-look", "version": 1, "name": "Scale", "driven_by": "nothing", "passes": [
{}
]}})",
        passes);
    return texts;
}

PlainScale::PlainScale(const ScaleSize& size)
    : m_vertices(scale_vertices()), m_sampler(scale_sampler()) {
    for (auto& targets : m_targets)
        for (int i = 0; i < size.passes; ++i)
            targets.emplace_back(Extent{size.side, size.side}, size.gl_format, false);
}

Result<PlainScale> PlainScale::make(const ScaleSize& size) {
    PlainScale made(size);
    Stage vertex;
    vertex.text = scale_vertex;
    for (int pass = 0; pass < size.passes; ++pass) {
        Stage fragment;
        fragment.text = fragment_of(size, pass);
        auto program = gpu::Program::build(vertex, fragment);
        if (!program)
            return fail(program.error());
        program->set_unit(*program->find_uniform("before"), 0);
        program->set_unit(*program->find_uniform("former"), 1);
        std::vector<GLint> parameters;
        for (int i = 0; i < size.parameters_per_pass; ++i)
            parameters.push_back(program->find_uniform(scale_parameter(pass, i))->location);
        const GLint time = program->find_uniform("u_time")->location;
        made.m_passes.push_back({std::move(*program), time, std::move(parameters)});
    }
    return made;
}

void PlainScale::set(int pass, int parameter, double value) const {
    const Pass& changed = m_passes[static_cast<std::size_t>(pass)];
    changed.program.use();
    glUniform1f(changed.parameters[static_cast<std::size_t>(parameter)], static_cast<float>(value));
}

void PlainScale::draw(double seconds) {
    m_now = 1 - m_now;
    const auto& targets = m_targets[m_now];
    const auto& previous = m_targets[1 - m_now];
    glBindVertexArray(m_vertices.get());
    for (const GLuint unit : {0U, 1U})
        glBindSampler(unit, m_sampler.get());
    for (std::size_t i = 0; i < m_passes.size(); ++i) {
        targets[i].aim();
        m_passes[i].program.use();
        glUniform1f(m_passes[i].time, static_cast<float>(seconds));
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, (i > 0 ? targets[i - 1] : previous[i]).texture());
        glActiveTexture(GL_TEXTURE1);
        glBindTexture(GL_TEXTURE_2D, previous[i].texture());
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    for (const GLuint unit : {0U, 1U})
        glBindSampler(unit, 0);
}

}  // namespace bench
