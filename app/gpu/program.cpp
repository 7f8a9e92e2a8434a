#include "gpu/program.h"

#include "gpu/driver_log.h"
#include "gpu/program_binary.h"

#include <algorithm>
#include <numeric>

namespace gpu {

void delete_program(GLuint id) {
    glDeleteProgram(id);
}

namespace {
void delete_shader(GLuint id) {
    glDeleteShader(id);
}
using Shader = Name<delete_shader>;

std::string shader_log(GLuint shader) {
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    GLsizei written = 0;
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &written, log.data());
    log.resize(static_cast<std::size_t>(written));
    return log;
}

std::string program_log(GLuint program) {
    GLint length = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    GLsizei written = 0;
    glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), &written, log.data());
    log.resize(static_cast<std::size_t>(written));
    return log;
}

Result<Shader> compile(GLenum kind, const Stage& stage) {
    Shader shader(glCreateShader(kind));
    const GLchar* text = stage.text->data();
    const auto length = static_cast<GLint>(stage.text->size());
    glShaderSource(shader.get(), 1, &text, &length);
    glCompileShader(shader.get());
    GLint is_good = 0;
    glGetShaderiv(shader.get(), GL_COMPILE_STATUS, &is_good);
    if (!is_good)
        return fail(parse_driver_log(shader_log(shader.get()), stage));
    return shader;
}

std::vector<Uniform> active_uniforms(GLuint program) {
    GLint count = 0;
    GLint longest = 0;
    glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    glGetProgramiv(program, GL_ACTIVE_UNIFORM_MAX_LENGTH, &longest);
    std::vector<Uniform> uniforms;
    std::string name(static_cast<std::size_t>(std::max(longest, 1)), '\0');
    for (GLint i = 0; i < count; ++i) {
        GLsizei length = 0;
        GLint elements = 0;
        GLenum type = 0;
        glGetActiveUniform(program, static_cast<GLuint>(i), longest, &length, &elements, &type,
                           name.data());
        const GLint location = glGetUniformLocation(program, name.c_str());
        if (location >= 0)  // below 0: in a block, or built in
            uniforms.push_back(make_uniform(name.substr(0, static_cast<std::size_t>(length)),
                                            location, elements, type));
    }
    return uniforms;
}
}  // namespace

Program::Program(GLuint id) : m_name(id) {}

Result<Program> Program::build(const Stage& vertex, const Stage& fragment, ByteStore* store) {
    if (!store)
        return compiled(vertex, fragment);
    const std::string key = binary_key(vertex.text, fragment.text);
    if (const auto binary = store->find(key)) {
        Program program(glCreateProgram());
        if (load_binary(program.m_name.get(), *binary)) {
            program.list_uniforms();
            program.m_is_restored = true;
            return program;
        }
    }
    auto program = compiled(vertex, fragment);
    if (program)
        if (const std::string binary = binary_of(program->m_name.get()); !binary.empty())
            store->keep(key, binary);
    return program;
}

Result<Program> Program::compiled(const Stage& vertex, const Stage& fragment) {
    const auto vertex_shader = compile(GL_VERTEX_SHADER, vertex);
    const auto fragment_shader = compile(GL_FRAGMENT_SHADER, fragment);
    Diagnostics problems;
    for (const auto* shader : {&vertex_shader, &fragment_shader})
        if (!*shader)
            problems.insert(problems.end(), shader->error().begin(), shader->error().end());
    if (!problems.empty())
        return fail(std::move(problems));

    Program program(glCreateProgram());
    const GLuint id = program.m_name.get();
    for (const auto* shader : {&vertex_shader, &fragment_shader})
        glAttachShader(id, (*shader)->get());
    glProgramParameteri(id, GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
    glLinkProgram(id);
    for (const auto* shader : {&vertex_shader, &fragment_shader})
        glDetachShader(id, (*shader)->get());
    GLint is_good = 0;
    glGetProgramiv(id, GL_LINK_STATUS, &is_good);
    if (!is_good)  // link errors concern both stages; users write the fragment stage
        return fail(parse_driver_log(program_log(id), fragment));
    program.list_uniforms();
    return program;
}

void Program::list_uniforms() {
    m_uniforms = active_uniforms(m_name.get());
    m_by_name.resize(m_uniforms.size());
    std::iota(m_by_name.begin(), m_by_name.end(), std::size_t{0});
    std::ranges::sort(m_by_name, {}, [this](std::size_t index) -> std::string_view {
        return m_uniforms[index].name;
    });
}

const Uniform* Program::find_uniform(std::string_view name) const {
    const auto found = std::ranges::lower_bound(
        m_by_name, name, {},
        [this](std::size_t index) -> std::string_view { return m_uniforms[index].name; });
    return found == m_by_name.end() || m_uniforms[*found].name != name ? nullptr
                                                                       : &m_uniforms[*found];
}

int Program::attribute_location(const char* name) const {
    return glGetAttribLocation(m_name.get(), name);
}

void Program::write(std::string_view uniform, std::span<const double> numbers) const {
    if (const Uniform* found = find_uniform(uniform))
        write(*found, numbers);
}

void Program::write(const Uniform& uniform, std::span<const double> numbers) const {
    write_uniform(m_name.get(), uniform, numbers);
}

void Program::set_unit(const Uniform& sampler, int unit) const {
    for (int i = 0; i < sampler.count; ++i)
        glProgramUniform1i(m_name.get(), sampler.location + i, unit + i);
}

void Program::use() const {
    glUseProgram(m_name.get());
}

std::shared_ptr<const Program> destroyed_in(std::shared_ptr<Context> context, Program program) {
    auto owned = std::make_unique<const Program>(std::move(program));
    if (!context)
        return owned;
    return {owned.release(), [context = std::move(context)](const Program* ending) {
                context->destroy_later(std::unique_ptr<const Program>(ending));
            }};
}

}  // namespace gpu
