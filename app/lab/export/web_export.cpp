#include "lab/export/web_export.h"

#include "formats/web/es_shaders.h"
#include "formats/web/web_page.h"
#include "io/files/atomic_file.h"
#include "lab/export/described_look.h"

#include <fmt/format.h>

namespace fs = std::filesystem;

namespace {
constexpr std::uintmax_t max_embedded = 10'000'000;  // bytes
}

Result<ExportedLook> export_web(const ExportRequest& request) {
    const auto described = described_files(request);
    if (!described)
        return fail(described.error());
    const Look look = request.prepared.document.drawn_look();
    const auto shaders = es_shaders(look);
    if (!shaders)
        return fail(shaders.error());
    const std::string folder = request.path.stem().string() + "_media";
    const auto page = web_page(*described, *shaders, folder, max_embedded);
    if (!page)
        return fail(page.error());
    ExportedLook made{request.path, 0, 0};
    const auto write = [&](const fs::path& path, const std::string& text) {
        ++made.files;
        made.bytes += text.size();
        return write_atomically(path, text);
    };
    for (const auto& [path, text] : page->scripts)
        if (auto written = write(request.path.parent_path() / path, text); !written)
            return fail(written.error());
    if (auto written = write(request.path, page->html); !written)
        return fail(written.error());
    return made;
}

std::vector<std::string> web_losses(const PreparedLook&) {
    return {};
}
