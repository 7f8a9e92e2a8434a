// Scenes with the files that they name, and wireframes. A form feed separates the files.

#include "formats/scene/obj_file.h"
#include "formats/scene/scene_file.h"
#include "fuzz/fuzz_files.h"

void fuzz_one(std::string_view input) {
    static FuzzFolder folder({"scene.json", "shape.obj", "shape.svg"});
    folder.fill(input);
    if (const auto scene = load_scene(folder.file(0)); !scene)
        require_reasons(scene.error());
    static_cast<void>(files_of_scene(folder.file(0)));
    if (!std::filesystem::exists(folder.file(1)))
        return;
    if (const auto shape = load_obj(folder.file(1)); !shape)
        require_reasons(shape.error());
}
