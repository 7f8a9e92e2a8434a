#include "lab/offline/preset_thumbnail_renderer.h"

#include "base/elapsed.h"
#include "base/file.h"
#include "base/text.h"
#include "formats/preset/preset_format.h"
#include "gpu/objects/readback.h"
#include "io/pictures/picture_file.h"
#include "lab/document/content_edits.h"
#include "lab/media/media_input.h"
#include "lab/offline/thumbnail.h"
#include "lab/storage/file_stamp.h"
#include "lab/storage/picture_cache.h"
#include "lab/storage/shader_cache.h"
#include "signals/signal_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>
#include <vector>

namespace fs = std::filesystem;

namespace {
constexpr Extent own_size{480, 270};
// Shaders of other programs are made for larger pictures. crt-royale is black in small ones.
constexpr Extent foreign_size{960, 540};
constexpr double painted_fps = 30.0;  // half the window's rate looks the same

Extent drawn_size(const Look& look) {
    return look.manifest.filename() == "look.json" || look.stack.size() > 1 ? own_size
                                                                            : foreign_size;
}

std::string text_of_all(const Look& look) {
    std::string all;
    for (const fs::path& file : look.files)
        all += read_text(file).value_or(std::string()) + '\n';
    return all;
}

bool is_lost(const std::string& file) {
    std::error_code error;
    return !file.empty() && !fs::exists(file, error);
}

// Live input cannot be reproduced, and missing files cannot be drawn. As in the window, the look's
// own signal or source replaces them.
void stand_in(Document& document) {
    const Look& look = document.look();
    if (look.driven_by == Driver::signal) {
        const SignalKind* kind = find_kind(document.state().signal.kind);
        const bool is_live = kind && (kind->is_live || kind->is_sent);
        if ((is_live || is_lost(driving_file(document))) && look.default_signal)
            set_signal(document, *look.default_signal);
    } else if (look.driven_by == Driver::picture) {
        const auto source = parse_source(document.state().source);
        const bool is_live = source && source->is_live();
        if (is_live || (source && source->is_file() && is_lost(source->picture)))
            set_source(document, look.default_source);
    }
}

// The settling time of the look, at most 0.8 s. Longer afterglow is hardly visible in small
// pictures.
int frames_of(const Look& look) {
    return std::clamp(look.settle_frames / 2, 12, 24);
}

// The files of its signal or source, and those of its parameters.
std::vector<fs::path> files_named_in(const Document& document) {
    std::vector<fs::path> files;
    const auto source = parse_source(document.state().source);
    const bool has_no_file =
        document.look().driven_by == Driver::picture && source && !source->is_file();
    if (const std::string file = driving_file(document); !file.empty() && !has_no_file)
        files.emplace_back(file);
    for (const auto& [name, value] : document.values())
        if (!value.path.empty())
            files.emplace_back(value.path);
    return files;
}

bool has_samples(const Executor& executor) {
    const auto samples = executor.drawer().samples();
    return !samples || samples->held >= samples->enough.value_or(0);
}
}  // namespace

PresetThumbnailRenderer::PresetThumbnailRenderer(Look look, Library library,
                                                 std::optional<Content> content, Pace pace)
    : m_plain(std::move(look)),
      m_library(std::move(library)),
      m_content(std::move(content)),
      m_pace(pace) {
    m_look_text = text_of_all(m_plain.look());
}

fs::path PresetThumbnailRenderer::kept_file(const fs::path& preset) const {
    const std::string drawn_from = preset.empty() ? "" : read_text(preset).value_or(std::string());
    const std::string content =
        m_content ? to_string(m_content->signal) + '\n' + m_content->source : std::string();
    const std::string all =
        fmt::format("2 {}x{}\n{}\n{}\n{}\n{}{}", drawn_size(m_plain.look()).width, m_lines,
                    m_plain.look().id, m_look_text, drawn_from, m_stamp, content);
    return m_library.roots().state / "preset-pictures" / fmt::format("{:016x}.png", digest_of(all));
}

// A preset for other bypassed looks of the stack, or another driver, needs another look.
Result<PreparedLook> PresetThumbnailRenderer::prepared(const fs::path& file) const {
    PreparedLook made{.document = m_plain, .shader_cache = shader_cache(m_library.roots())};
    if (file.empty())
        return made;
    auto preset = load_preset(file);
    if (!preset)
        return fail(preset.error());
    const Look& look = m_plain.look();
    const bool has_driver =
        !look.has_other_driver || preset->source.empty() != is_picture_driven(look.stack);
    if (preset->look == look.id && (preset->bypass != bypassed_keys(look.stack) || !has_driver))
        return prepare({.look = preset->look, .preset = file.string()}, m_library);
    if (auto opened = open_preset({.look = {}, .preset = std::move(*preset), .preset_file = file},
                                  m_library, made);
        !opened)
        return fail(opened.error());
    return made;
}

Result<void> PresetThumbnailRenderer::start(PreparedLook prepared) {
    if (m_offline && m_viewer &&
        m_offline->document().look().stack == prepared.document.look().stack)
        return m_offline->start_again(std::move(prepared.document));
    m_viewer.reset();  // belongs to the previous context
    m_offline.reset();
    const Extent size = drawn_size(prepared.document.look());
    auto offline = Offline::create(std::move(prepared), size, painted_fps);
    if (!offline)
        return fail(offline.error());
    m_offline.emplace(std::move(*offline));
    auto viewer = Viewer::make();
    if (!viewer)
        return fail(viewer.error());
    m_viewer.emplace(std::move(*viewer));
    return {};
}

Result<Picture> PresetThumbnailRenderer::draw(PreparedLook prepared, const JobProgress& work) {
    stand_in(prepared.document);
    if (auto started = start(std::move(prepared)); !started) {
        m_offline.reset();  // it may be only partly initialised
        return fail(started.error());
    }
    constexpr int timeout = 120;  // frames, for accumulating passes
    const int enough = frames_of(m_offline->document().look());
    for (int frame = 1;
         frame <= enough || (frame <= timeout && !has_samples(m_offline->executor())); ++frame) {
        if (work.is_cancelled)
            return fail({{}, 0, "cancelled"});
        const auto begun = std::chrono::steady_clock::now();
        frame < enough ? m_offline->advance_unseen() : m_offline->advance();
        if (m_pace == Pace::full)
            continue;
        const double longest_rest = 0.1;
        std::this_thread::sleep_for(
            std::chrono::duration<double>(std::min(seconds_since(begun), longest_rest)));
    }
    auto canvas = thumbnail(*m_viewer, m_offline->executor(), m_lines);
    if (!canvas)
        return fail(canvas.error());
    Picture picture = gpu::read_picture(canvas->texture());
    picture.encoding = Encoding::display;
    ++m_drawn;
    return picture;
}

// Also finds the files that the picture depends on.
Result<PreparedLook> PresetThumbnailRenderer::begin(const fs::path& preset) {
    m_named.clear();
    m_stamp.clear();
    auto made = prepared(preset);
    if (!made)
        return made;
    if (m_content)
        use_content(made->document, *m_content);
    if (const auto read = apply_constants(made->document); !read)
        return fail(read.error());
    m_named = files_named_in(made->document);
    m_stamp = stamp_text(m_named);
    return made;
}

Result<std::optional<Picture>> PresetThumbnailRenderer::find_cached(const fs::path& preset) {
    if (const auto made = begin(preset); !made)
        return fail(made.error());
    const fs::path file = kept_file(preset);
    std::error_code error;
    if (fs::exists(file, error))
        if (auto cached = load_picture(file))
            return std::optional(std::move(*cached));
    return std::optional<Picture>();
}

Result<Picture> PresetThumbnailRenderer::paint(const fs::path& preset, const JobProgress& work) {
    auto made = begin(preset);
    if (!made)
        return fail(made.error());
    const fs::path file = kept_file(preset);
    std::error_code error;
    if (fs::exists(file, error))
        if (auto cached = load_picture(file))
            return cached;
    auto picture = draw(std::move(*made), work);
    if (!picture)
        return picture;
    // Caching is optional: without it, the picture is drawn again the next time.
    if (save_picture(*picture, file))
        forget_old(file.parent_path());
    return picture;
}
