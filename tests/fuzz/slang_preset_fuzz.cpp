// libretro presets: a file with #reference and #include to three others, and to itself.

#include "formats/slang/preset.h"
#include "formats/slang_export/simple_slang_preset.h"
#include "fuzz/fuzz_files.h"

void fuzz_one(std::string_view input) {
    static FuzzFolder folder({"a/0.slangp", "a/1.slangp", "2.slangp", "a/b/3.params"});
    folder.fill(input);
    SlangFiles files;
    const auto preset = read_slang_preset(folder.file(0), files);
    if (!preset)
        return require_reasons(preset.error());
    require(!preset->passes.empty() && preset->passes.size() <= 64, "a preset has 1 to 64 passes");
    require(preset->textures.size() <= 64, "a preset has at most 64 textures");
    for (const SlangPass& pass : preset->passes)
        require(!pass.shader.empty(), "every pass has a shader");
    std::map<std::string, double> values;
    for (const auto& [name, value] : preset->values)
        values[name] = value.number;
    simple_slang_preset(folder.file(0), values, folder.file(3));
}
