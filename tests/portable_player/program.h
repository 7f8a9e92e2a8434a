#pragma once

#include "portable_player/description.h"
#include "portable_player/gl.h"

#include <map>
#include <span>
#include <string>

/// The shaders of a pass.
class Program {
public:
    /// Fails with the file and the message of the driver.
    explicit Program(const Pass& pass);

    struct Uniform {
        GLint location = -1;
        GLenum type = 0;
        GLint count = 1;
    };
    const std::map<std::string, Uniform>& uniforms() const { return m_uniforms; }
    bool has(const std::string& uniform) const { return m_uniforms.contains(uniform); }

    void use() const { glUseProgram(m_name.get()); }
    /// Writes numbers, by columns for a matrix. The program must be in use.
    void write(const std::string& uniform, std::span<const double> numbers) const;
    void set_unit(const std::string& sampler, int unit) const;
    GLint attribute(const char* name) const { return glGetAttribLocation(m_name.get(), name); }

private:
    GlName<delete_program> m_name;
    std::map<std::string, Uniform> m_uniforms;
};
