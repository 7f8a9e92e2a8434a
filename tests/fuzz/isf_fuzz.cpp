// ISF shaders, up to the text for the compiler.

#include "formats/isf/body.h"
#include "formats/isf/controls.h"
#include "formats/isf/stages.h"
#include "fuzz/fuzz_files.h"

#include <algorithm>

void fuzz_one(std::string_view input) {
    const std::filesystem::path file = "shader.fs";
    const std::size_t cut = std::min(input.find('\f'), input.size());
    IsfSource source{file, std::string(input.substr(0, cut)), {}, {}};
    if (cut < input.size()) {
        source.vertex_file = "shader.vs";
        source.vertex_text = input.substr(cut + 1);
    }
    const auto header = read_isf_header(source.text, file);
    if (!header)
        return require_reasons(header.error());
    for (const IsfInput& given : header->inputs) {
        const Parameter made = isf_control(given);
        require(made.range.low <= made.range.high, "a range has its low end first");
    }
    const std::size_t shown = std::min<std::size_t>(header->passes.size(), 2);
    for (std::size_t pass = 0; pass < shown; ++pass) {
        require_locations(isf_fragment_stage(source, *header, pass));
        require_locations(isf_vertex_stage(source, *header, pass));
    }
}
