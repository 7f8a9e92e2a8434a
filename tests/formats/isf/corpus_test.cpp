#include "base/file.h"
#include "formats/isf/header.h"
#include "formats/isf/isf_format.h"
#include "problems_of.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <map>

namespace fs = std::filesystem;

namespace {
// Counts over all shaders of Vidvox's ISF-Files.
struct IsfCounts {
    int files = 0;
    int with_several_passes = 0;
    int with_persistent = 0;
    int with_float = 0;
    std::map<IsfHeader::Kind, int> kinds;
    std::map<IsfInput::Type, int> inputs;
    Diagnostics refused;
};

void count_file(const fs::path& file, IsfCounts& counts) {
    const auto text = read_text(file);
    REQUIRE(text.has_value());
    const auto header = read_isf_header(*text, file);
    REQUIRE_MESSAGE(header.has_value(), problems_of(header));
    ++counts.files;
    ++counts.kinds[header->kind()];
    counts.with_several_passes += header->passes.size() > 1 ? 1 : 0;
    const auto any = [&](auto has) { return std::ranges::any_of(header->passes, has) ? 1 : 0; };
    counts.with_persistent += any([](const IsfPass& pass) { return pass.is_persistent; });
    counts.with_float += any([](const IsfPass& pass) { return pass.is_float; });
    for (const IsfInput& input : header->inputs)
        ++counts.inputs[input.type];
    if (const LoadedLook loaded = load_isf_look(file, {}); !loaded.look)
        counts.refused.insert(counts.refused.end(), loaded.look.error().begin(),
                              loaded.look.error().end());
}
}  // namespace

TEST_CASE("the public corpus of ISF shaders is read as it was counted") {
    const char* folder = std::getenv("AFTERGLOW_ISF_DIR");
    if (!folder) {
        MESSAGE("skipped: AFTERGLOW_ISF_DIR does not name a copy of Vidvox's ISF-Files");
        return;
    }
    using Type = IsfInput::Type;
    using Kind = IsfHeader::Kind;
    IsfCounts counts;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".fs")
            count_file(entry.path(), counts);
    CHECK(counts.files == 321);
    CHECK(counts.kinds ==
          std::map<Kind, int>{{Kind::generator, 49}, {Kind::filter, 204}, {Kind::transition, 68}});
    CHECK(counts.inputs == std::map<Type, int>{{Type::floating, 841},
                                               {Type::boolean, 137},
                                               {Type::integer, 91},
                                               {Type::event, 21},
                                               {Type::point, 89},
                                               {Type::color, 143},
                                               {Type::image, 355},
                                               {Type::audio, 3},
                                               {Type::audio_fft, 5}});
    CHECK(counts.with_several_passes == 56);
    CHECK(counts.with_persistent == 49);
    CHECK(counts.with_float == 20);
    CHECK(to_string(counts.refused) == "");
}
