#include "glsl/check_cache.h"

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

std::uint64_t digest_of_stage(const Stage& stage) {
    return digest_of(stage.file.string() + '\0' + places_of(stage.lines) + '\0' + stage.text);
}

std::uint64_t digest_of_pair(const Stage& vertex, const Stage& fragment) {
    return digest_of(fmt::format("{:x} {:x}", digest_of_stage(vertex), digest_of_stage(fragment)));
}

template <class Answer, class Question>
Answer remembered(std::mutex& mutex, std::map<std::uint64_t, Answer>& known, const Stage& vertex,
                  const Stage& fragment, Question&& question) {
    const std::uint64_t key = digest_of_pair(vertex, fragment);
    {
        const std::scoped_lock lock(mutex);
        if (const auto found = known.find(key); found != known.end())
            return found->second;
    }
    Answer answer = question(vertex, fragment);
    const std::scoped_lock lock(mutex);
    if (known.size() >= most_programs)
        known.clear();
    known.insert_or_assign(key, answer);
    return answer;
}
}  // namespace

Result<Reflection> CheckCache::check(const Stage& vertex, const Stage& fragment) {
    return remembered(m_mutex, m_known, vertex, fragment, check_program);
}

Result<Translation> CheckCache::translate(const Stage& vertex, const Stage& fragment) {
    return remembered(m_mutex, m_translated, vertex, fragment, translate_from_vulkan);
}
