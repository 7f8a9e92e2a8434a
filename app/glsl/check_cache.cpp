#include "glsl/check_cache.h"

#include "glsl/packed_answers.h"

#include <fmt/format.h>

namespace {
constexpr std::size_t most_programs = 512;

// Places are part of the answer, so they are part of the question.
std::string places_of(const LineMap& lines) {
    std::string places;
    for (const LineMap::Stretch& stretch : lines.stretches())
        places += fmt::format("{}\n{} {}\n", stretch.first.file.string(), stretch.first.line,
                              stretch.end);
    return places;
}

std::string digest_of_stage(const Stage& stage) {
    const std::uint64_t places = digest_of(stage.file.string() + '\0' + places_of(stage.lines));
    return fmt::format("{:x} {:x} {}", digest_of(stage.text), places, stage.text.size());
}

/// What is asked about two stages, and the form of its answer as bytes.
template <class Answer>
struct QuestionKind {
    std::string_view name;
    Result<Answer> (*ask)(const Stage& vertex, const Stage& fragment);
    std::optional<Answer> (*unpack)(std::string_view bytes);
};
}  // namespace

template <class Answer, class Kind>
Answer CheckCache::remembered(std::map<std::uint64_t, Answer>& known, const Stage& vertex,
                              const Stage& fragment, const Kind& kind) {
    const std::string question =
        fmt::format("{} {} {}", kind.name, digest_of_stage(vertex), digest_of_stage(fragment));
    const std::uint64_t key = digest_of(question);
    {
        const std::scoped_lock lock(m_mutex);
        if (const auto found = known.find(key); found != known.end())
            return found->second;
    }
    const auto kept = m_kept ? m_kept->find(question) : std::nullopt;
    auto unpacked = kept ? kind.unpack(*kept) : std::nullopt;
    Answer answer = unpacked ? Answer(std::move(*unpacked)) : kind.ask(vertex, fragment);
    if (!unpacked)
        ++m_compilations;
    if (!unpacked && answer && m_kept && m_keeps)
        m_kept->keep(question, packed(*answer));
    const std::scoped_lock lock(m_mutex);
    if (known.size() >= most_programs)
        known.clear();
    known.insert_or_assign(key, answer);
    return answer;
}

Result<Reflection> CheckCache::check(const Stage& vertex, const Stage& fragment) {
    return remembered(m_known, vertex, fragment,
                      QuestionKind<Reflection>{"check", check_program, unpacked_reflection});
}

Result<Translation> CheckCache::translate(const Stage& vertex, const Stage& fragment) {
    return remembered(
        m_translated, vertex, fragment,
        QuestionKind<Translation>{"translate", translate_from_vulkan, unpacked_translation});
}
