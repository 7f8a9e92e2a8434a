#pragma once

#include "glsl/check.h"
#include "glsl/translate.h"

#include <cstdint>
#include <map>
#include <mutex>

/// Remembers what check_program and translate_from_vulkan said about texts, by digest, so that a
/// reload compiles only what changed. Thread-safe.
class CheckCache {
public:
    /// As check_program.
    Result<Reflection> check(const Stage& vertex, const Stage& fragment);
    /// As translate_from_vulkan.
    Result<Translation> translate(const Stage& vertex, const Stage& fragment);

private:
    std::mutex m_mutex;
    std::map<std::uint64_t, Result<Reflection>> m_known;
    std::map<std::uint64_t, Result<Translation>> m_translated;
};
