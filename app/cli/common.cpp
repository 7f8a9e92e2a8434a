#include "cli/common.h"

#include "base/machine_memory.h"
#include "base/text.h"
#include "cli/progress.h"

#include <fmt/format.h>

#include <iostream>

int report(const Diagnostics& reasons) {
    std::cerr << to_string(reasons);
    return exit_not_good;
}

void warn(const Diagnostics& warnings) {
    std::cerr << to_string(warnings);
}

Extent parse_size(const std::string& text) {
    const std::size_t cross = text.find('x');
    const auto width = parse_integer(std::string_view(text).substr(0, cross));
    const auto height = cross == std::string::npos
                            ? std::nullopt
                            : parse_integer(std::string_view(text).substr(cross + 1));
    constexpr int largest = 16384;
    if (!width || !height || *width < 1 || *height < 1 || *width > largest || *height > largest)
        throw UsageError("--size: '" + text +
                         "' is not of the form 1280x720, 1 to 16384 px a side");
    return {*width, *height};
}

void check_ending(const std::string& option, const std::string& file,
                  const std::vector<std::string>& endings) {
    const std::string ending = to_lower(std::filesystem::path(file).extension().string());
    if (std::find(endings.begin(), endings.end(), ending) == endings.end())
        throw UsageError(
            fmt::format("{}: '{}' does not end in {}", option, file, fmt::join(endings, " or ")));
}

void LookOptions::add_to(Options& options, Take take) {
    options
        .add("LOOK", m_request.look,
             "A look's folder or name, a stack a+b, another program's shader, or a preset: file, "
             "PNG or line")
        .required();
    options.add("--preset", m_request.preset, "A preset of the look: file, name or line");
    options
        .add("--set", m_set,
             "name=value, in a stack also crt/name=value; may be given again and again")
        .repeated();
    options.add("--signal", m_request.signal,
                "What drives a scope, as in lissajous:x=3,y=2 or audio:song.wav,mode=xy");
    options.add(
        "--source", m_request.source,
        "The picture that a CRT look works on: a file, frame_%04d.png, a video or pattern:NAME; "
        "behind it ,fit= ,shape= ,aspect= ,prescaled= ,rate= ,loop=");
    options.add("--size", m_size, "Of the picture, in pixels").show_default();
    if (take == Take::drawing)
        options.add("--fps", m_request.fps, "Frames a second of the fixed clock")
            .show_default()
            .between(1.0, 1000.0);
}

RenderRequest LookOptions::request() const {
    RenderRequest request = m_request;
    request.size = parse_size(m_size);
    for (const std::string& assignment : m_set) {
        const std::size_t equals = assignment.find('=');
        if (equals == std::string::npos || equals == 0)
            throw UsageError("--set: '" + assignment + "' is not of the form name=value");
        request.values.emplace_back(assignment.substr(0, equals), assignment.substr(equals + 1));
    }
    return request;
}

Result<Library> open_library(const DataFolders& data) {
    auto roots = find_roots(
        data.data.empty() ? std::nullopt : std::optional<std::filesystem::path>(data.data),
        data.includes);
    if (!roots)
        return fail(roots.error());
    roots->shader_limits = data.limits;
    return Library(std::move(*roots));
}

int run_drawing(RenderRequest request, const DataFolders& data, const Drawing& drawing) {
    const auto library = open_library(data);
    if (!library)
        return report(library.error());
    OpeningLine line;
    request.progress = &line.progress();
    auto prepared = prepare(request, *library);
    line.clear();
    if (!prepared)
        return report(prepared.error());
    warn(prepared->warnings);
    if (const auto fits = check_memory(*prepared, request.size, machine_memory()); !fits)
        return report(fits.error());
    const auto good = drawing.check ? drawing.check(*prepared) : Result<void>();
    if (!good)
        return report(good.error());
    if (drawing.seen)
        prepared->seen = drawing.seen(*prepared);
    auto offline = Offline::create(std::move(*prepared), request.size, request.fps);
    line.clear();
    if (!offline)
        return report(offline.error());
    if (offline->document().state().signal.kind == "socket")
        std::cerr << offline->sender_state() << ". Ctrl+C ends it.\n";
    const auto done = drawing.draw(*offline, *library);
    const Diagnostics problems = offline->take_problems();
    warn(problems);
    if (!done)
        return report(done.error());
    return has_errors(problems) ? exit_not_good : exit_done;
}
