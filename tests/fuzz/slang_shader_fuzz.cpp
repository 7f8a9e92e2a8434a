// libretro shaders: includes, pragmas, parameters and their labels.

#include "formats/slang/controls.h"
#include "formats/slang/shader.h"
#include "fuzz/fuzz_files.h"

void fuzz_one(std::string_view input) {
    static FuzzFolder folder({"a/0.slang", "a/1.inc", "2.inc", "a/b/3.inc"});
    folder.fill(input);
    SlangFiles files;
    const auto shader = read_slang_shader(folder.file(0), files);
    if (!shader)
        return require_reasons(shader.error());
    require_locations(shader->vertex);
    require_locations(shader->fragment);
    const SlangControls controls = slang_controls(shader->parameters, {});
    for (const Parameter& parameter : controls.parameters) {
        require(parameter.range.low <= parameter.range.high, "a range has its low end first");
        require(!parameter.label.empty() || parameter.name.empty(), "a control has a label");
    }
}
