#include "cli/common.h"

#include "base/text.h"
#include "cli/progress.h"
#include "io/system/machine_memory.h"
#include "lab/messages/source_lines.h"
#include "lab/rendering/named_size.h"
#include "model/tuning/tempo.h"

#include <fmt/format.h>

#include <iostream>

int report(const Diagnostics& reasons) {
    std::cerr << with_source_lines(reasons);
    return exit_failure;
}

void warn(const Diagnostics& warnings) {
    std::cerr << with_source_lines(warnings);
}

Extent parse_size(const std::string& text) {
    if (const auto extent = parse_extent(text))
        return *extent;
    std::vector<std::string> names;
    for (const NamedSize& size : named_sizes())
        names.push_back(size.name);
    throw UsageError(
        fmt::format("--size: expected WIDTHxHEIGHT with 1 to 16384 px per side, got '{}'. Named "
                    "sizes: {}.",
                    text, fmt::join(names, ", ")));
}

void check_ending(const std::string& option, const std::string& file,
                  const std::vector<std::string>& extensions) {
    const std::string ending = to_lower(std::filesystem::path(file).extension().string());
    if (std::find(extensions.begin(), extensions.end(), ending) == extensions.end())
        throw UsageError(fmt::format("{}: the file name must end in {}, got '{}'", option,
                                     or_list(extensions), file));
}

void LookOptions::add_to(Options& options, Take take) {
    options
        .add("LOOK", m_request.look,
             "Look (name or folder), stack (phosphor+crt), shader of another program, or preset "
             "(file, PNG or line of text)")
        .required();
    options.add("--preset PRESET", m_request.preset,
                "Apply a preset of the look (name, file or line of text)");
    options
        .add("--set NAME=VALUE", m_set,
             "Set a parameter, such as decay=0.9 or, in a stack, crt/exposure=2")
        .repeated();
    m_takes_several = take == Take::several;
    m_has_rate = take != Take::values;
    options
        .add("--signal SIGNAL", m_signals,
             "Signal of a scope look, such as lissajous:x=3,y=2 or audio:song.wav,mode=xy "
             "('afterglow list signals' prints all)")
        .repeated();
    options.add("--source SOURCE", m_request.source,
                "Picture of a CRT look: an image file, frame_%04d.png, a video, pattern:NAME, "
                "window:TITLE, screen:, camera:DEVICE or pipe: (the manual describes all), with "
                "optional settings ,fit= ,shape= ,aspect= ,prescaled= ,rate= ,loop=");
    options
        .add("--tempo BPM", m_request.bpm,
             "Tempo of modulations in beats (default: the preset's, else 120)")
        .between(min_bpm, max_bpm);
    Option size = options.add("--size WxH", m_size,
                              "Render size in pixels, or 720p, 1080p, 1440p, 2160p, square "
                              "(1080x1080) or portrait (1080x1920)");
    if (!m_size.empty())
        size.show_default();
    if (m_has_rate)
        options.add("--fps N", m_request.fps, "Frames per second of the fixed clock")
            .show_default()
            .between(1.0, 1000.0);
}

RenderRequest LookOptions::request() const {
    RenderRequest request = m_request;
    request.size = m_size.empty() ? Extent{} : parse_size(m_size);
    if (m_signals.size() > 1 && !m_takes_several)
        throw UsageError("--signal: only 'render' takes several sounds");
    if (!m_signals.empty())
        request.signal = m_signals.front();
    for (const std::string& assignment : m_set) {
        const std::size_t equals = assignment.find('=');
        if (equals == std::string::npos || equals == 0)
            throw UsageError(fmt::format("--set: expected NAME=VALUE, got '{}'", assignment));
        request.values.emplace_back(assignment.substr(0, equals), assignment.substr(equals + 1));
    }
    return request;
}

std::vector<std::string> LookOptions::arguments() const {
    std::vector<std::string> arguments{m_request.look};
    add_argument(arguments, "--preset", m_request.preset);
    for (const std::string& assignment : m_set)
        add_argument(arguments, "--set", assignment);
    for (const std::string& signal : m_signals)
        add_argument(arguments, "--signal", signal);
    add_argument(arguments, "--source", m_request.source);
    if (m_request.bpm > 0.0)
        add_argument(arguments, "--tempo", fmt::format("{}", m_request.bpm));
    add_argument(arguments, "--size", m_size);
    if (m_has_rate)
        add_argument(arguments, "--fps", fmt::format("{}", m_request.fps));
    return arguments;
}

Result<std::vector<SweepAxis>> sweep_axes(const std::vector<std::string>& texts, const Look& look) {
    if (texts.size() > 2)
        throw UsageError("--vary can be given at most twice: one parameter across and one down");
    std::vector<SweepAxis> axes;
    Diagnostics problems;
    for (const std::string& text : texts) {
        auto axis = parse_sweep_axis(text, look);
        if (axis)
            axes.push_back(std::move(*axis));
        else
            problems.insert(problems.end(), axis.error().begin(), axis.error().end());
    }
    if (!problems.empty())
        return fail(std::move(problems));
    if (axes.size() == 2 && axes[0].parameter == axes[1].parameter)
        return fail({{}, 0, fmt::format("'{}' is varied twice", axes[0].parameter)});
    return axes;
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

int run_prepared(
    const RenderRequest& request, const DataFolders& data,
    const std::function<int(const PreparedLook& prepared, const Library& library)>& work) {
    const auto library = open_library(data);
    if (!library)
        return report(library.error());
    const auto prepared = prepare(request, *library);
    if (!prepared)
        return report(prepared.error());
    warn(prepared->warnings);
    return work(*prepared, *library);
}

int run_drawing(RenderRequest request, const DataFolders& data, const DrawingSteps& steps) {
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
    const auto good = steps.check ? steps.check(*prepared) : Result<void>();
    if (!good)
        return report(good.error());
    if (steps.displayed)
        prepared->displayed = steps.displayed(*prepared);
    auto offline = Offline::create(std::move(*prepared), request.size, request.fps);
    line.clear();
    if (!offline)
        return report(offline.error());
    const BeamFeed* feed = offline->signal().feed();
    if (feed && feed->spec().kind == "socket")
        std::cerr << fmt::format("{}. Press Ctrl+C to stop.\n", feed->state());
    const auto done = steps.draw(*offline, *library);
    const Diagnostics problems = offline->take_problems();
    warn(problems);
    if (!done)
        return report(done.error());
    return has_errors(problems) ? exit_failure : exit_done;
}
