#include "glsl/cache/check_cache.h"

#include "glsl/cache/packed_answers.h"

#include <fmt/format.h>

#include <functional>
#include <string_view>

namespace {
constexpr std::size_t max_programs = 512;

// One FNV-1 step. Multiplying first avoids that two equal numbers cancel.
std::size_t mixed(std::size_t digest, std::size_t next) {
    return (digest * 0x100000001b3u) ^ next;
}

// Makes room for one more entry.
template <class Known>
void evict(Known& known) {
    if (known.size() >= max_programs)
        known.clear();
}

// The result contains source locations, so they are part of the key.
std::string locations_of(const LineMap& lines) {
    std::string locations;
    for (const LineMap::Stretch& stretch : lines.stretches())
        locations += fmt::format("{}\n{} {}\n", stretch.first.file.string(), stretch.first.line,
                                 stretch.end);
    return locations;
}

std::string digest_of_stage(const Stage& stage) {
    const std::uint64_t locations =
        digest_of(stage.file.string() + '\0' + locations_of(stage.lines));
    return fmt::format("{:x} {:x} {}", digest_of(stage.text), locations, stage.text->size());
}

/// A query about two stages, and how to unpack its stored result.
template <class Answer>
struct QuestionKind {
    std::string_view name;
    Result<Answer> (*ask)(const Stage& vertex, const Stage& fragment, const ShaderLimits& limits);
    std::optional<Answer> (*unpack)(std::string_view bytes);
};
}  // namespace

CheckCache::StageKey CheckCache::key_of(const Stage& stage) {
    const std::hash<std::string_view> digest;
    std::size_t locations = digest(stage.file.native());
    for (const LineMap::Stretch& stretch : stage.lines.stretches()) {
        locations = mixed(locations, digest(stretch.first.file.native()));
        locations =
            mixed(mixed(locations, static_cast<std::size_t>(stretch.first.line)), stretch.end);
    }
    return {digest(stage.text), locations, stage.text->size()};
}

template <class Answer, class Kind>
Answer CheckCache::cached(std::map<ProgramKey, Answer>& known, const Stage& vertex,
                          const Stage& fragment, const Kind& kind) {
    const ProgramKey key{key_of(vertex), key_of(fragment)};
    {
        const std::scoped_lock lock(m_mutex);
        if (const auto found = known.find(key); found != known.end())
            return found->second;
    }
    const std::string stored_key = fmt::format("{} {}{} {}", kind.name, to_string(m_limits),
                                               digest_of_stage(vertex), digest_of_stage(fragment));
    const auto stored = m_store ? m_store->find(stored_key) : std::nullopt;
    auto unpacked = stored ? kind.unpack(*stored) : std::nullopt;
    Answer answer = unpacked ? Answer(std::move(*unpacked)) : kind.ask(vertex, fragment, m_limits);
    if (!unpacked)
        ++m_compilations;
    if (!unpacked && answer && m_store && m_keeps)
        m_store->keep(stored_key, packed(*answer));
    const std::scoped_lock lock(m_mutex);
    evict(known);
    known.insert_or_assign(key, answer);
    return answer;
}

Result<Reflection> CheckCache::check(const Stage& vertex, const Stage& fragment) {
    return cached(m_known, vertex, fragment,
                  QuestionKind<Reflection>{"check", check_program, unpacked_reflection});
}

Result<Translation> CheckCache::translate(const Stage& vertex, const Stage& fragment) {
    return cached(
        m_translated, vertex, fragment,
        QuestionKind<Translation>{"translate", translate_from_vulkan, unpacked_translation});
}

std::shared_ptr<const StageNotes> CheckCache::notes(const Stage& stage) {
    const StageKey key = key_of(stage);
    const std::scoped_lock lock(m_mutex);
    if (const auto found = m_notes.find(key); found != m_notes.end())
        return found->second;
    evict(m_notes);
    return m_notes[key] = std::make_shared<const StageNotes>(find_notes(stage));
}

std::shared_ptr<const StageNotes> notes_of(const Stage& stage, CheckCache* cache) {
    return cache ? cache->notes(stage) : std::make_shared<const StageNotes>(find_notes(stage));
}
