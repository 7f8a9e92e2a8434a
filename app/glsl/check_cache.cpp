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
}  // namespace

Result<Reflection> CheckCache::check(const Stage& vertex, const Stage& fragment) {
    const std::uint64_t key =
        digest_of(fmt::format("{:x} {:x}", digest_of_stage(vertex), digest_of_stage(fragment)));
    {
        const std::scoped_lock lock(m_mutex);
        if (const auto found = m_known.find(key); found != m_known.end())
            return found->second;
    }
    Result<Reflection> result = check_program(vertex, fragment);
    const std::scoped_lock lock(m_mutex);
    if (m_known.size() >= most_programs)
        m_known.clear();
    m_known.insert_or_assign(key, result);
    return result;
}
