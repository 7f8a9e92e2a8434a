#pragma once

#include "gpu/program.h"
#include "model/look/format.h"

#include <array>
#include <functional>
#include <optional>
#include <string_view>

/// The prefix of "sampler2D" and "vec4" in GLSL for this kind of numbers.
std::string_view glsl_prefix(SampleKind kind);

/// Variants of a program, one for each kind of numbers that a texture can hold. They belong to the
/// context that they are built in. Only one thread at a time may request them.
class SamplePrograms {
public:
    using Build = std::function<Result<gpu::Program>(SampleKind)>;

    /// Builds the variant for floats, so that driver errors are reported. The others, which few
    /// looks need, are built on first use.
    static Result<SamplePrograms> make(Build build);

    /// Null if the driver refuses it.
    const gpu::Program* find(Format read) const;

private:
    explicit SamplePrograms(Build build) : m_build(std::move(build)) {}
    const Result<gpu::Program>& made(SampleKind kind) const;

    Build m_build;
    mutable std::array<std::optional<Result<gpu::Program>>, 3> m_made;
};
