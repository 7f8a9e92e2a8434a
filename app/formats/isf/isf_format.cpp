#include "formats/isf/isf_format.h"

#include "base/file.h"
#include "base/text.h"
#include "formats/isf/isf_look.h"

namespace fs = std::filesystem;

namespace {
Result<std::string> read_code(const fs::path& file) {
    constexpr std::size_t max_bytes = std::size_t{4} << 20;
    auto text = read_text(file);
    if (text && text->size() > max_bytes)
        return fail({file, 0, "the shader is larger than the limit of 4 MiB"});
    return text;
}

// Reads the vertex shader in the same folder. `files` receives its possible names even if it is
// missing, so that a watcher detects a new file.
Result<void> read_vertex_code(IsfSource& source, std::vector<fs::path>& files) {
    for (const char* extension : {".vs", ".vert"}) {
        fs::path sibling = source.file;
        sibling.replace_extension(extension);
        files.push_back(sibling);
        std::error_code error;
        if (!source.vertex_file.empty() || !fs::is_regular_file(sibling, error))
            continue;
        auto text = read_code(sibling);
        if (!text)
            return fail(text.error());
        source.vertex_file = sibling;
        source.vertex_text = std::move(*text);
    }
    return {};
}

Result<Look> read_isf_look(const fs::path& file, const LoadOptions& help, LoadedLook& loaded) {
    IsfSource source{file, {}, {}, {}};
    auto text = read_code(file);
    if (!text)
        return fail(text.error());
    source.text = std::move(*text);
    const auto header = read_isf_header(source.text, file);
    if (!header)
        return fail(header.error());
    if (auto read = read_vertex_code(source, loaded.files); !read)
        return fail(read.error());
    loaded.is_parsed = true;
    auto look = look_of_isf(source, *header, help, loaded.files, loaded.warnings);
    if (!look)
        return look;
    look->id = foreign_look_id(file);
    look->name = file.stem().string();
    look->manifest = file;
    return look;
}
}  // namespace

bool is_isf_file(const fs::path& file) {
    if (to_lower(file.extension().string()) != ".fs")
        return false;
    const auto text = read_text(file);
    return text && has_isf_header(*text);
}

LoadedLook load_isf_look(const fs::path& file, const LoadOptions& help) {
    LoadedLook loaded;
    loaded.look = read_isf_look(file, help, loaded);
    return loaded;
}
