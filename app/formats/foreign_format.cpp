#include "formats/foreign_format.h"

#include "base/text.h"
#include "formats/fragment/fragment_format.h"
#include "formats/isf/isf_format.h"
#include "formats/shadertoy/shadertoy_format.h"
#include "formats/slang/slang_format.h"

#include <algorithm>
#include <array>

namespace fs = std::filesystem;

namespace {
constexpr std::array<std::string_view, 2> slang_extensions{".slangp", ".slang"};
constexpr std::array<std::string_view, 1> isf_extensions{".fs"};
constexpr std::array<std::string_view, 5> shader_extensions{".json", ".glsl", ".frag", ".fsh",
                                                            ".txt"};

LoadedLook load_slang(const fs::path& file, const IncludeFolders&, const LoadOptions& help) {
    return load_slang_look(file, help);
}

LoadedLook load_isf(const fs::path& file, const IncludeFolders&, const LoadOptions& help) {
    return load_isf_look(file, help);
}

// Without a valid header, loading reports what is wrong with it.
bool has_isf_extension(const fs::path& file) {
    return to_lower(file.extension().string()) == isf_extensions[0];
}

constexpr std::array formats{
    ForeignFormat{"RetroArch .slangp and .slang", slang_extensions, is_slang_file, load_slang},
    ForeignFormat{"ISF", isf_extensions, is_isf_file, load_isf},
    ForeignFormat{"Shadertoy", shader_extensions, is_shadertoy_file, load_shadertoy_look},
    ForeignFormat{"plain fragment shaders", shader_extensions, is_fragment_file,
                  load_fragment_look},
    ForeignFormat{"", isf_extensions, has_isf_extension, load_isf},
};
}  // namespace

const ForeignFormat* find_foreign_format(const fs::path& file) {
    const auto found = std::ranges::find_if(
        formats, [&file](const ForeignFormat& format) { return format.is_file(file); });
    return found == formats.end() ? nullptr : &*found;
}

std::vector<std::string> foreign_extensions() {
    std::vector<std::string> all;
    for (const ForeignFormat& format : formats)
        for (const std::string_view extension : format.extensions)
            if (std::ranges::find(all, extension) == all.end())
                all.emplace_back(extension);
    return all;
}

std::string foreign_labels() {
    std::string labels;
    for (const ForeignFormat& format : formats)
        if (!format.label.empty())
            labels += (labels.empty() ? "" : ", ") + std::string(format.label);
    return labels;
}
