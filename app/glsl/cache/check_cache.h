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

/// Remembers what check_program, translate_from_vulkan and find_notes said about texts, by digest,
/// so that a reload looks only into what changed. Thread-safe.
class CheckCache {
public:
    /// What is good is also kept in `kept`, where a former run of the program may have kept it
    /// already; null: nowhere.
    explicit CheckCache(ByteStore* kept = nullptr, const ShaderLimits& limits = {})
        : m_kept(kept), m_limits(limits) {}

    const ShaderLimits& limits() const { return m_limits; }
    /// Whether what is found out from now on is kept for other runs; at first it is.
    void set_keeping(bool keeps) { m_keeps = keeps; }
    /// As check_program.
    Result<Reflection> check(const Stage& vertex, const Stage& fragment);
    /// As translate_from_vulkan.
    Result<Translation> translate(const Stage& vertex, const Stage& fragment);
    /// As find_notes.
    std::shared_ptr<const StageNotes> notes(const Stage& stage);
    /// How many programs were compiled, and not remembered.
    int compilations() const { return m_compilations; }

private:
    // Digests of the text and of its places, and the text's length.
    using StageKey = std::array<std::size_t, 3>;
    using ProgramKey = std::array<StageKey, 2>;

    static StageKey key_of(const Stage& stage);
    template <class Answer, class Kind>
    Answer remembered(std::map<ProgramKey, Answer>& known, const Stage& vertex,
                      const Stage& fragment, const Kind& kind);

    ByteStore* m_kept;
    ShaderLimits m_limits;
    std::atomic<bool> m_keeps = true;
    std::atomic<int> m_compilations = 0;
    std::mutex m_mutex;
    std::map<ProgramKey, Result<Reflection>> m_known;
    std::map<ProgramKey, Result<Translation>> m_translated;
    std::map<StageKey, std::shared_ptr<const StageNotes>> m_notes;
};

/// As find_notes; `cache` may be null.
std::shared_ptr<const StageNotes> notes_of(const Stage& stage, CheckCache* cache);
