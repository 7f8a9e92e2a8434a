#include "formats/shadertoy/shadertoy_format.h"

#include "base/file.h"
#include "base/text.h"
#include "formats/shadertoy/shadertoy_files.h"
#include "formats/shadertoy/shadertoy_json.h"
#include "formats/shadertoy/shadertoy_look.h"
#include "formats/shadertoy/shadertoy_stage.h"
#include "glsl/parameters/constant_parameters.h"
#include "glsl/parameters/parameters.h"

#include <algorithm>

namespace fs = std::filesystem;

namespace {
bool is_json(const fs::path& file) {
    return to_lower(file.extension().string()) == ".json";
}

Result<Shadertoy> read_shadertoy(const fs::path& file, const IncludeFolders& includes,
                                 LoadedLook& loaded) {
    if (!is_json(file))
        return load_shadertoy_files(file, includes, loaded.files, loaded.warnings);
    const auto text = read_text(file);
    if (!text)
        return fail(text.error());
    return parse_shadertoy_json(*text, file, loaded.warnings);
}

Result<Look> read_shadertoy_look(const fs::path& file, const IncludeFolders& includes,
                                 const LoadOptions& help, LoadedLook& loaded) {
    const auto shadertoy = read_shadertoy(file, includes, loaded);
    if (!shadertoy)
        return fail(shadertoy.error());
    auto look = look_of_shadertoy(*shadertoy, file.parent_path(), loaded.warnings);
    if (!look)
        return look;
    loaded.is_parsed = true;
    look->manifest = file;
    look->id = foreign_look_id(file);
    if (look->name.empty())
        look->name = file.stem().string();
    if (auto problems = write_constants(*look, help.values, help.cache); !problems.empty())
        return fail(std::move(problems));
    auto parameters = find_parameters(*look, help.cache, loaded.warnings);
    if (!parameters) {
        suggest_shadertoy_inputs(parameters.error());
        return fail(std::move(parameters.error()));
    }
    look->parameters.insert(look->parameters.end(), parameters->begin(), parameters->end());
    return look;
}
}  // namespace

bool is_shadertoy_file(const fs::path& file) {
    constexpr std::size_t max_text = std::size_t{4} << 20;
    const std::string extension = to_lower(file.extension().string());
    std::error_code error;
    if (is_json(file)) {
        if (file.filename() == "look.json")
            return false;
        const auto text = read_text(file);
        return text ? is_shadertoy_json(*text) : !fs::exists(file, error);
    }
    const bool is_text = extension == ".glsl" || extension == ".frag" || extension == ".fsh" ||
                         extension == ".fs" || extension == ".txt";
    if (!is_text)
        return false;
    const auto text = read_start(file, max_text);
    return text && is_shadertoy_text(*text);
}

LoadedLook load_shadertoy_look(const fs::path& file, const IncludeFolders& includes,
                               const LoadOptions& help) {
    LoadedLook loaded;
    loaded.look = read_shadertoy_look(file, includes, help, loaded);
    return loaded;
}
