#include "lab/library/look_templates.h"

#include "base/file.h"
#include "formats/look/look_manifest.h"
#include "formats/look/pass_edit.h"
#include "io/files/atomic_file.h"

#include <algorithm>

namespace fs = std::filesystem;

std::vector<LookTemplate> look_templates(const fs::path& root) {
    std::vector<LookTemplate> templates;
    for (const char* id : {"filter", "beam", "generator"}) {
        const fs::path folder = root / "shaders" / "templates" / id;
        std::vector<fs::path> files;
        if (const auto look = load_manifest(folder / "look.json", files))
            templates.push_back({id, look->name, look->about, folder});
    }
    return templates;
}

Result<void> copy_template(const LookTemplate& look, const fs::path& folder,
                           const std::string& name) {
    std::error_code error;
    std::vector<fs::path> files;
    for (fs::directory_iterator it(look.folder, error), end; !error && it != end;
         it.increment(error))
        if (it->path().filename() != picture_name)
            files.push_back(it->path());
    if (error)
        return fail({look.folder, 0, error.message()});
    std::ranges::sort(files);
    for (const fs::path& file : files) {
        auto text = read_text(file);
        if (text && file.filename() == "look.json")
            text = with_look_named(*text, name, file);
        if (!text)
            return fail(text.error());
        if (auto written = write_atomically(folder / file.filename(), *text); !written)
            return written;
    }
    return {};
}
