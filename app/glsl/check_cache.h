#pragma once

#include "glsl/check.h"

#include <cstdint>
#include <map>
#include <mutex>

/// Remembers what check_program said about texts, by digest, so that a reload checks only what
/// changed. Thread-safe.
class CheckCache {
public:
    /// As check_program.
    Result<Reflection> check(const Stage& vertex, const Stage& fragment);

private:
    std::mutex m_mutex;
    std::map<std::uint64_t, Result<Reflection>> m_known;
};
