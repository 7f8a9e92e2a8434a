#include "lab/export/described_look.h"

#include "base/file.h"
#include "formats/portable/stage_files.h"
#include "lab/playback/signal_file.h"
#include "signals/signal_table.h"

#include <algorithm>
#include <iterator>

namespace fs = std::filesystem;

namespace {
// The name of a source file: at most the last three parts of its path from the first look.
std::string notice_name(const fs::path& file, const Stack& stack) {
    constexpr std::ptrdiff_t most_parts = 3;
    std::vector<fs::path> parts;
    for (const fs::path& part : file.lexically_proximate(stack.front().path))
        if (part != ".." && part != "/")
            parts.push_back(part);
    fs::path name;
    for (auto part = parts.end() - std::min(most_parts, std::ssize(parts)); part != parts.end();
         ++part)
        name /= *part;
    return name == "." ? file.filename().string() : name.generic_string();
}

// Of a scene or drawing. A sound is copied, and not needed here.
Result<SignalMedia> media_of(const Spec& signal) {
    const std::string file = file_of(signal);
    if (file.empty() || (signal.kind != "scene" && signal.kind != "drawing"))
        return SignalMedia{};
    return load_signal_media(file);
}
}  // namespace

// Pictures have no comments.
Result<SourceNotices> notices_of(const Look& look) {
    SourceNotices notices;
    std::error_code error;
    for (const fs::path& file : look.files) {  // also places where an include was searched
        if (!fs::exists(file, error))
            continue;
        const auto bytes = read_bytes(file);
        if (!bytes)
            return fail(bytes.error());
        if (bytes->find('\0') == std::string::npos)
            notices.emplace_back(notice_name(file, look.stack), source_notice(*bytes));
    }
    return notices;
}

Result<PortableFiles> described_files(const ExportRequest& request) {
    const Document& document = request.prepared.document;
    const Look look = document.drawn_look();
    auto notices = notices_of(look);
    if (!notices)
        return fail(notices.error());
    Spec signal;
    SignalMedia media;
    if (look.driven_by == Driver::signal) {
        auto complete = completed(document.state().signal);
        if (!complete)
            return fail(complete.error());
        signal = std::move(*complete);
        auto read = media_of(signal);
        if (!read)
            return fail(read.error());
        media = std::move(*read);
    }
    const std::string source =
        look.driven_by == Driver::picture ? document.state().source : std::string();
    auto files = portable_files({.look = look,
                                 .values = document.values(),
                                 .modulations = document.state().modulations,
                                 .tempo = document.state().tempo,
                                 .signal = std::move(signal),
                                 .media = std::move(media),
                                 .source = source,
                                 .size = request.size},
                                *notices);
    if (files && request.has_stages)
        add_stages(look, *files);
    return files;
}
