#include "lab/commands/help_page.h"

#include "base/file.h"
#include "formats/markdown/html_page.h"
#include "io/files/atomic_file.h"
#include "io/system/process.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace fs = std::filesystem;

namespace {
constexpr std::array navigation{
    HtmlLink{"Manual", "manual.md"},
    HtmlLink{"Newcomer", "tutorials/newcomer.md"},
    HtmlLink{"CRT shader author", "tutorials/crt-shader-author.md"},
    HtmlLink{"Oscilloscope musician", "tutorials/oscilloscope-musician.md"},
    HtmlLink{"Writing a look", "tutorials/shader-developer.md"},
    HtmlLink{"VJ", "tutorials/vj.md"},
    HtmlLink{"Looks", "looks.md"},
    HtmlLink{"Presets", "presets.md"},
    HtmlLink{"Signals", "signals.md"},
    HtmlLink{"Scenes", "scenes.md"},
    HtmlLink{"Cues", "cues.md"},
    HtmlLink{"Look format", "look-format.md"},
    HtmlLink{"Annotations", "annotations.md"},
    HtmlLink{"Foreign formats", "formats.md"},
    HtmlLink{"Command line", "command-line.md"},
    HtmlLink{"Remote control", "remote.md"},
    HtmlLink{"What's new", "whats-new.md"},
};

std::vector<fs::path> markdown_files(const fs::path& docs) {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::recursive_directory_iterator entry(docs, error);
         !error && entry != fs::recursive_directory_iterator(); entry.increment(error))
        if (entry->path().extension() == ".md")
            files.push_back(entry->path());
    std::ranges::sort(files);
    return files;
}
}  // namespace

fs::path find_docs(const Roots& roots) {
    std::error_code error;
    std::vector<fs::path> folders = program_folders();
    folders.insert(folders.begin(), roots.program);
    for (const fs::path& folder : folders)
        if (fs::is_regular_file(folder / "docs/manual.md", error))
            return folder / "docs";
    return {};
}

Result<void> write_help_pages(const fs::path& docs, const fs::path& target) {
    for (const fs::path& file : markdown_files(docs)) {
        const auto text = read_text(file);
        if (!text)
            return fail(text.error());
        const fs::path name = file.lexically_relative(docs);
        const fs::path page = fs::path(target / name).replace_extension(".html");
        std::error_code error;
        fs::create_directories(page.parent_path(), error);
        const auto html = html_page(*text, {name, docs, navigation});
        if (!html)
            return fail({file, 0, html.error().front().message});
        if (const auto old = read_text(page); old && *old == *html)
            continue;
        if (auto written = write_atomically(page, *html); !written)
            return written;
    }
    return {};
}

void open_help_page(const Roots& roots, const std::string& page, ExternalPrograms& programs,
                    Messages& messages) {
    const fs::path docs = find_docs(roots);
    if (docs.empty())
        return messages.say("The manual is not installed. Copy the folder docs next to shaders.",
                            true);
    const fs::path target = roots.cache / "docs";
    if (messages.succeeded(write_help_pages(docs, target)))
        programs.open_page(fs::path(target / page).replace_extension(".html"));
}
