#pragma once

#include "base/byte_store.h"
#include "glsl/check.h"
#include "glsl/translate.h"

#include <atomic>
#include <cstdint>
#include <map>
#include <mutex>

/// Remembers what check_program and translate_from_vulkan said about texts, by digest, so that a
/// reload compiles only what changed. Thread-safe.
class CheckCache {
public:
    /// What is good is also kept in `kept`, where a former run of the program may have kept it
    /// already; null: nowhere.
    explicit CheckCache(ByteStore* kept = nullptr) : m_kept(kept) {}

    /// Whether what is found out from now on is kept for other runs; at first it is.
    void set_keeping(bool keeps) { m_keeps = keeps; }
    /// As check_program.
    Result<Reflection> check(const Stage& vertex, const Stage& fragment);
    /// As translate_from_vulkan.
    Result<Translation> translate(const Stage& vertex, const Stage& fragment);
    /// How many programs were compiled, and not remembered.
    int compilations() const { return m_compilations; }

private:
    template <class Answer, class Kind>
    Answer remembered(std::map<std::uint64_t, Answer>& known, const Stage& vertex,
                      const Stage& fragment, const Kind& kind);

    ByteStore* m_kept;
    std::atomic<bool> m_keeps = true;
    std::atomic<int> m_compilations = 0;
    std::mutex m_mutex;
    std::map<std::uint64_t, Result<Reflection>> m_known;
    std::map<std::uint64_t, Result<Translation>> m_translated;
};
