// Includes in native looks, Shadertoy folders and single fragment shaders.

#include "fuzz/fuzz_files.h"
#include "glsl/text/include.h"

void fuzz_one(std::string_view input) {
    static FuzzFolder folder({"look/0.glsl", "look/1.glsl", "include/2.glsl", "shared/3.glsl"});
    folder.fill(input);
    const auto parent = [](const std::filesystem::path& file) { return file.parent_path(); };
    std::vector<std::filesystem::path> files;
    const auto stage =
        load_stage(folder.file(0), {parent(folder.file(0)), parent(folder.file(3))}, files);
    if (!stage)
        return require_reasons(stage.error());
    require_locations(*stage);
}
