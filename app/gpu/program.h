#pragma once

#include "base/byte_store.h"
#include "base/diagnostic.h"
#include "gpu/context.h"
#include "gpu/objects/name.h"
#include "gpu/uniform.h"
#include "model/look/look.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace gpu {

void delete_program(GLuint id);

/// A linked program of a vertex and a fragment stage.
class Program {
public:
    /// Errors are the driver's messages at the original files and lines. A store caches program
    /// binaries. An entry is valid only for the same driver facts.
    static Result<Program> build(const Stage& vertex, const Stage& fragment,
                                 ByteStore* store = nullptr);
    /// Whether it was restored from the store.
    bool is_restored() const { return m_is_restored; }
    GLuint id() const { return m_name.get(); }

    /// The active uniforms.
    const std::vector<Uniform>& uniforms() const { return m_uniforms; }
    const Uniform* find_uniform(std::string_view name) const;
    /// Negative if not found.
    int attribute_location(const char* name) const;

    /// As write_uniform; ignores names that are not in the program.
    void write(std::string_view uniform, std::span<const double> numbers) const;
    void write(const Uniform& uniform, std::span<const double> numbers) const;
    /// Sets the texture unit of a sampler; array elements use consecutive units.
    void set_unit(const Uniform& sampler, int unit) const;
    void use() const;

    /// Records who writes the uniforms, by a number from 1. True if it was another one before.
    bool set_uniform_owner(std::uint64_t writer) const {
        return std::exchange(m_writer, writer) != writer;
    }

private:
    explicit Program(GLuint id);

    static Result<Program> compiled(const Stage& vertex, const Stage& fragment);

    Name<delete_program> m_name;
    void list_uniforms();

    std::vector<Uniform> m_uniforms;
    std::vector<std::size_t> m_by_name;  // indices into m_uniforms
    bool m_is_restored = false;
    mutable std::uint64_t m_writer = 0;
};

/// The last owner, on any thread, leaves the destruction to `context`: some drivers unbind a
/// context's program when another context deletes it. Null: the context that is current at that
/// time destroys it.
std::shared_ptr<const Program> destroyed_in(std::shared_ptr<Context> context, Program program);

}  // namespace gpu
