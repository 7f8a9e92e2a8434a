#pragma once

#include "base/byte_store.h"
#include "glsl/cache/stage_notes.h"
#include "glsl/compile/check.h"
#include "glsl/compile/translate.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>

/// Caches the results of check_program, translate_from_vulkan and find_notes by digest of the
/// texts. A reload therefore processes only changed texts. Thread-safe.
class CheckCache {
public:
    /// Successful results are also stored in `stored`, which may hold results of a previous run.
    /// Null: no store.
    explicit CheckCache(ByteStore* stored = nullptr, const ShaderLimits& limits = {})
        : m_store(stored), m_limits(limits) {}

    const ShaderLimits& limits() const { return m_limits; }
    /// Whether new results are stored for later runs; true by default.
    void set_keeping(bool keeps) { m_keeps = keeps; }
    /// Like check_program.
    Result<Reflection> check(const Stage& vertex, const Stage& fragment);
    /// Like translate_from_vulkan.
    Result<Translation> translate(const Stage& vertex, const Stage& fragment);
    /// Like find_notes.
    std::shared_ptr<const StageNotes> notes(const Stage& stage);
    /// Number of programs compiled because they were not cached.
    int compilations() const { return m_compilations; }

private:
    // Digests of the text and of its line map, and the text's length.
    using StageKey = std::array<std::size_t, 3>;
    using ProgramKey = std::array<StageKey, 2>;

    static StageKey key_of(const Stage& stage);
    template <class Answer, class Kind>
    Answer cached(std::map<ProgramKey, Answer>& known, const Stage& vertex, const Stage& fragment,
                  const Kind& kind);

    ByteStore* m_store;
    ShaderLimits m_limits;
    std::atomic<bool> m_keeps = true;
    std::atomic<int> m_compilations = 0;
    std::mutex m_mutex;
    std::map<ProgramKey, Result<Reflection>> m_known;
    std::map<ProgramKey, Result<Translation>> m_translated;
    std::map<StageKey, std::shared_ptr<const StageNotes>> m_notes;
};

/// Like find_notes; `cache` may be null.
std::shared_ptr<const StageNotes> notes_of(const Stage& stage, CheckCache* cache);
