#include "lab/export/web_export.h"

#include "base/file.h"
#include "formats/web/es_shaders.h"
#include "formats/web/page_check.h"
#include "formats/web/web_page.h"
#include "io/files/atomic_file.h"
#include "lab/export/described_look.h"

#include <fmt/format.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace {
constexpr std::uintmax_t max_embedded = 10'000'000;  // bytes
constexpr std::size_t pictures_everywhere = 16;      // per pass, in WebGL 2

// A directory would be found only after the media were written.
Result<void> check_path(const fs::path& path) {
    std::error_code error;
    if (fs::is_directory(path, error))
        return fail({path, 0, "is a folder. Add a file name, such as page.html."});
    if (const std::string ending = path.extension().string(); ending != ".html" && ending != ".htm")
        return fail({path, 0, "a web page needs the ending .html"});
    return {};
}
}  // namespace

Result<ExportedLook> write_page(const Look& look, const PortableFiles& described,
                                const fs::path& path) {
    const auto shaders = es_shaders(look);
    if (!shaders)
        return fail(shaders.error());
    const std::string folder = path.stem().string() + "_media";
    const auto page = web_page(look, described, *shaders, folder, max_embedded);
    if (!page)
        return fail(page.error());
    ExportedLook made{path, 0, 0};
    const auto write = [&](const fs::path& file, const std::string& text) {
        ++made.files;
        made.bytes += text.size();
        return write_atomically(file, text);
    };
    for (const auto& [name, text] : page->scripts)
        if (auto written = write(path.parent_path() / name, text); !written)
            return fail(written.error());
    if (auto written = write(path, page->html); !written)
        return fail(written.error());
    return made;
}

Result<ExportedLook> export_web(const ExportRequest& request) {
    if (auto good = check_path(request.path); !good)
        return fail(good.error());
    const auto described = described_files(request);
    if (!described)
        return fail(described.error());
    return write_page(request.prepared.document.drawn_look(), *described, request.path);
}

Result<std::vector<std::string>> web_losses(const PreparedLook& prepared) {
    const Document& document = prepared.document;
    const Look look = document.drawn_look();
    const auto shaders = es_shaders(look);
    if (!shaders)
        return fail(shaders.error());
    std::vector<std::string> losses;
    for (const Parameter& parameter : look.parameters)
        if (parameter.is_constant &&
            std::ranges::find(shaders->constants, parameter.name, &EsConstant::name) ==
                shaders->constants.end())
            losses.push_back(fmt::format(
                "The control '{}'. The page keeps its value, which is fixed before the shaders are "
                "compiled.",
                parameter.label));
    for (std::size_t i = 0; i < look.passes.size(); ++i)
        if (const std::size_t read = pictures_read(*shaders, i); read > pictures_everywhere)
            losses.push_back(fmt::format("Devices that allow {} pictures. The pass '{}' reads {}.",
                                         pictures_everywhere, look.passes[i].name, read));
    const std::string& kind = document.state().signal.kind;
    if (look.driven_by == Driver::signal && (kind == "stdin" || kind == "socket"))
        losses.emplace_back(
            "The beam of another program. The page draws nothing until a signal is chosen.");
    return losses;
}

Result<void> check_web(const ExportRequest& request) {
    const auto html = read_bytes(request.path);
    if (!html)
        return fail(html.error());
    const auto described = described_files(request);
    if (!described)
        return fail(described.error());
    if (const std::string fault = page_fault(*html, *described); !fault.empty())
        return fail({request.path, 0, fault + " Export the look again."});
    return {};
}

Result<fs::path> page_of_web(const ExportRequest& request, const fs::path&) {
    return fs::absolute(request.path);
}
