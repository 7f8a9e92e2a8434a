#include "formats/glsl/reserved_words.h"

#include <algorithm>
#include <array>

namespace {
using Kind = ReservedWord::Kind;
constexpr int never = ReservedWord::never;

constexpr auto all_reserved_words = std::to_array<ReservedWord>({
    {"active", never, Kind::keyword},    {"asm", never, Kind::keyword},
    {"buffer", 430, Kind::keyword},      {"case", 130, Kind::keyword},
    {"cast", never, Kind::keyword},      {"centroid", 120, Kind::keyword},
    {"class", never, Kind::keyword},     {"coherent", 420, Kind::keyword},
    {"common", never, Kind::keyword},    {"default", 130, Kind::keyword},
    {"dmat2", 400, Kind::keyword},       {"dmat3", 400, Kind::keyword},
    {"dmat4", 400, Kind::keyword},       {"double", 400, Kind::keyword},
    {"dvec2", 400, Kind::keyword},       {"dvec3", 400, Kind::keyword},
    {"dvec4", 400, Kind::keyword},       {"enum", never, Kind::keyword},
    {"extern", never, Kind::keyword},    {"external", never, Kind::keyword},
    {"filter", never, Kind::keyword},    {"fixed", never, Kind::keyword},
    {"flat", 130, Kind::keyword},        {"fma", 400, Kind::function},
    {"frexp", 400, Kind::function},      {"goto", never, Kind::keyword},
    {"half", never, Kind::keyword},      {"image2D", 420, Kind::type},
    {"inline", never, Kind::keyword},    {"input", never, Kind::keyword},
    {"interface", never, Kind::keyword}, {"layout", 140, Kind::keyword},
    {"ldexp", 400, Kind::function},      {"long", never, Kind::keyword},
    {"max3", never, Kind::keyword},      {"mid3", never, Kind::keyword},
    {"min3", never, Kind::keyword},      {"namespace", never, Kind::keyword},
    {"noinline", never, Kind::keyword},  {"noise1", never, Kind::function},
    {"noise2", never, Kind::function},   {"noise3", never, Kind::function},
    {"noise4", never, Kind::function},   {"noperspective", 130, Kind::keyword},
    {"output", never, Kind::keyword},    {"partition", never, Kind::keyword},
    {"patch", 400, Kind::keyword},       {"precise", 400, Kind::keyword},
    {"public", never, Kind::keyword},    {"readonly", 420, Kind::keyword},
    {"resource", never, Kind::keyword},  {"restrict", 420, Kind::keyword},
    {"sample", 400, Kind::keyword},      {"sampler2DRect", 140, Kind::type},
    {"shared", 430, Kind::keyword},      {"short", never, Kind::keyword},
    {"sizeof", never, Kind::keyword},    {"smooth", 130, Kind::keyword},
    {"static", never, Kind::keyword},    {"subroutine", 400, Kind::keyword},
    {"superp", never, Kind::keyword},    {"switch", 130, Kind::keyword},
    {"template", never, Kind::keyword},  {"this", never, Kind::keyword},
    {"typedef", never, Kind::keyword},   {"uint", 130, Kind::type},
    {"union", never, Kind::keyword},     {"unsigned", never, Kind::keyword},
    {"using", never, Kind::keyword},     {"uvec2", 130, Kind::type},
    {"uvec3", 130, Kind::type},          {"uvec4", 130, Kind::type},
    {"volatile", 420, Kind::keyword},    {"writeonly", 420, Kind::keyword},
});
}  // namespace

std::span<const ReservedWord> reserved_words() {
    return all_reserved_words;
}

const ReservedWord* find_reserved_word(std::string_view word) {
    const auto* const found =
        std::ranges::lower_bound(all_reserved_words, word, {}, &ReservedWord::word);
    return found != all_reserved_words.end() && found->word == word ? found : nullptr;
}
