#include "lab/commands/pass_commands.h"

#include "base/file.h"
#include "base/text.h"
#include "formats/look/look_manifest.h"
#include "formats/look/look_passes.h"
#include "formats/look/manifest_edit.h"
#include "formats/look_format.h"
#include "glsl/text/shader_files.h"
#include "io/system/file_status.h"
#include "lab/commands/duplicate_offer.h"
#include "lab/storage/display_name.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace fs = std::filesystem;

namespace {
// The shader of a new pass: it shows what it reads until its slider moves.
std::string shader_of(const NewPass& pass) {
    std::string variable = pass.name;
    std::ranges::replace(variable, '-', '_');
    constexpr std::string_view text = R"(#version 410 core
// {0}: changes what the pass "{1}" drew.
uniform sampler2D image;  // "{1}", see "inputs" in look.json
uniform float {2}_gain = 1.0;  // @range 0 4  @label "{3} gain"  @identity 1
                               // @help "Brightness of what this pass draws. 1 leaves it unchanged."

in vec2 uv;  // 0..1 from the bottom left
out vec4 color;

void main() {{
    vec4 before = texture(image, uv);
    color = vec4({2}_gain * before.rgb, before.a);
}}
)";
    return fmt::format(fmt::runtime(text), pass.name, pass.after, variable,
                       label_from_name(pass.name));
}

std::string rewired_text(const std::vector<std::string>& passes) {
    if (passes.empty())
        return {};
    return fmt::format(". New inputs: {}", fmt::join(passes, ", "));
}

// Whether another file of the look's folder includes this shader.
bool is_included(const fs::path& shader, const fs::path& folder) {
    ShaderFiles shaders;
    std::error_code error;
    for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end;
         it.increment(error)) {
        const std::string extension = it->path().extension().string();
        if (it->path() == shader ||
            (extension != ".glsl" && extension != ".frag" && extension != ".vert"))
            continue;
        if (const auto& text = shaders.read(it->path()))
            for (const ShaderText::Include& include : text->includes)
                if (include.file && fs::path(*include.file).filename() == shader.filename())
                    return true;
    }
    return false;
}

// The shaders of a removed pass to delete. A link, a shader of another folder, or one that others
// include stays.
void remove_shaders(const std::vector<std::string>& shaders, const fs::path& folder,
                    FileEdit& files) {
    for (const std::string& shader : shaders) {
        const fs::path file = folder / shader;
        std::error_code error;
        if (fs::is_symlink(file, error) || !is_inside(file, folder) || is_included(file, folder))
            continue;
        if (auto bytes = read_bytes(file))
            files.push_back({file, std::move(*bytes), std::nullopt});
    }
}
}  // namespace

std::optional<PassCommands::Located> PassCommands::locate(const std::string& pass) const {
    if (!m_work.document)
        return std::nullopt;
    const Stack& stack = m_work.document->look().stack;
    for (std::size_t i = 0; i < stack.size(); ++i)
        if (const std::string scope = name_prefix(stack, i); pass.starts_with(scope))
            return Located{manifest_of(stack[i].path), pass.substr(scope.size())};
    return std::nullopt;
}

std::optional<std::string> PassCommands::refusal(const std::string& pass) const {
    const auto located = locate(pass);
    if (!located)
        return "Open a look first";
    if (is_foreign_look(located->manifest))
        return "The passes of a foreign look can't be changed here. Edit its file instead.";
    if (m_work.library.is_shipped(located->manifest) || !is_writable(located->manifest))
        return fmt::format("\"{}\" is a shipped or read-only look. Change the passes of a copy.",
                           m_work.document->look().name);
    return std::nullopt;
}

bool PassCommands::refuse(const std::string& pass) {
    const auto reason = refusal(pass);
    if (!reason)
        return false;
    const auto located = locate(pass);
    if (located && !is_foreign_look(located->manifest) && m_work.document->look().stack.size() == 1)
        offer_duplicate(m_work, *reason);
    else
        m_work.messages.say(*reason, true);
    return true;
}

std::string PassCommands::proposed_name(const std::string& after) const {
    for (int n = 1;; ++n) {
        std::string name = n == 1 ? "effect" : fmt::format("effect-{}", n);
        if (problem_of_name(after, name).empty() || n > 999)
            return name;
    }
}

std::string PassCommands::problem_of_name(const std::string& after, const std::string& name) const {
    const auto located = locate(after);
    if (!located)
        return "Open a look first";
    if (!is_look_name(name) || name == "source")
        return std::string(look_name_rule());
    const Look& look = m_work.document->look();
    const std::string scope = after.substr(0, after.size() - located->name.size());
    const auto is_taken = [&](const auto& item) { return item.name == scope + name; };
    if (std::ranges::any_of(look.passes, is_taken) || std::ranges::any_of(look.images, is_taken))
        return fmt::format("\"{}\" is already used.", name);
    std::error_code error;
    if (fs::exists(located->manifest.parent_path() / (name + ".frag"), error))
        return fmt::format("{}.frag already exists.", name);
    return {};
}

// nullopt, after a message: the look can't be edited.
std::optional<PassCommands::Located> PassCommands::start(const std::string& pass) {
    if (refuse(pass))
        return std::nullopt;
    update();  // the files first follow an undo
    auto located = locate(pass);
    std::vector<fs::path> files;
    if (!m_work.messages.succeeded(load_manifest(located->manifest, files)))
        return std::nullopt;
    return located;
}

// Writes the files, and checks that the look is still valid.
void PassCommands::finish(std::string name, FileEdit files, std::string notice,
                          const Located& pass) {
    if (!m_work.messages.succeeded(apply(files)))
        return;
    std::vector<fs::path> named;
    if (const auto look = load_manifest(pass.manifest, named); !look) {
        if (m_work.messages.succeeded(apply(reversed(files))))
            m_work.messages.say(look.error().front());
        return;
    }
    Document& document = *m_work.document;
    const std::size_t edit = m_edits.empty() ? 1 : m_edits.rbegin()->first + 1;
    m_edits[edit] = {document.state().files, name, std::move(files)};
    m_applied = edit;
    DocumentState next = document.state();
    next.files = edit;
    document.finish();
    document.change(std::move(next), name, false, Document::StepKind::files);
    m_work.messages.offer(
        std::move(notice),
        {.name = "Undo", .commands = {[edit, name = std::move(name)](Document& changed) {
                             if (changed.state().files == edit &&
                                 changed.history().undo_name() == name)
                                 changed.undo();
                         }}});
}

void PassCommands::add(const std::string& after, const std::string& name) {
    const auto located = start(after);
    if (!located)
        return;
    if (const std::string problem = problem_of_name(after, name); !problem.empty())
        return m_work.messages.say(problem, true);
    const NewPass pass{name, name + ".frag", located->name};
    const auto text = read_manifest(located->manifest);
    if (!m_work.messages.succeeded(text))
        return;
    const auto edit = with_pass_added(text->text, pass, located->manifest);
    if (!m_work.messages.succeeded(edit))
        return;
    const fs::path shader = located->manifest.parent_path() / pass.fragment;
    finish(fmt::format("Add pass {}", name),
           {{shader, std::nullopt, shader_of(pass)},
            {located->manifest, text->bytes(), text->mark + edit->text}},
           fmt::format("Added pass \"{}\" with {}{}", name, pass.fragment,
                       rewired_text(edit->rewired)),
           *located);
}

void PassCommands::remove(const std::string& pass) {
    const auto located = start(pass);
    if (!located)
        return;
    const auto text = read_manifest(located->manifest);
    if (!m_work.messages.succeeded(text))
        return;
    const auto edit = with_pass_removed(text->text, located->name, located->manifest);
    if (!m_work.messages.succeeded(edit))
        return;
    FileEdit files{{located->manifest, text->bytes(), text->mark + edit->text}};
    remove_shaders(edit->unused_shaders, located->manifest.parent_path(), files);
    finish(fmt::format("Remove pass {}", located->name), std::move(files),
           fmt::format("Removed pass \"{}\"{}", located->name, rewired_text(edit->rewired)),
           *located);
}

void PassCommands::move(const std::string& pass, PassMove move) {
    const auto located = start(pass);
    if (!located)
        return;
    const auto text = read_manifest(located->manifest);
    if (!m_work.messages.succeeded(text))
        return;
    const auto edit = with_pass_moved(text->text, located->name, move, located->manifest);
    if (!m_work.messages.succeeded(edit))
        return;
    const char* where = move == PassMove::earlier ? "earlier" : "later";
    finish(fmt::format("Move pass {}", located->name),
           {{located->manifest, text->bytes(), text->mark + edit->text}},
           fmt::format("Moved pass \"{}\" {}{}", located->name, where, rewired_text(edit->rewired)),
           *located);
}

void PassCommands::forget() {
    m_edits.clear();
    m_applied = 0;
}

void PassCommands::update() {
    if (m_work.document && m_work.document->state().files != m_applied)
        restore(m_work.document->state().files);
}

// Undoes edits up to one that `wanted` is based on, then redoes those up to `wanted`.
void PassCommands::restore(std::size_t wanted) {
    std::vector<std::size_t> line{wanted};
    while (m_edits.contains(line.back()))
        line.push_back(m_edits.at(line.back()).from);
    bool is_done = true;
    while (is_done && m_edits.contains(m_applied) &&
           std::ranges::find(line, m_applied) == line.end()) {
        const Made& made = m_edits.at(m_applied);
        is_done = write(reversed(made.files), made.name);
        m_applied = made.from;
    }
    for (auto at = std::ranges::find(line, m_applied); is_done && at != line.begin();) {
        const Made& made = m_edits.at(*--at);
        is_done = write(made.files, made.name);
    }
    m_applied = wanted;
}

// False, after a message: the files stay as they are.
bool PassCommands::write(const FileEdit& files, const std::string& name) {
    const auto written = apply(files);
    if (written)
        return true;
    const Diagnostic& problem = written.error().front();
    m_work.messages.say(fmt::format("Can't undo or redo \"{}\": {} {}", name,
                                    display_name(problem.file), problem.message),
                        true);
    return false;
}
