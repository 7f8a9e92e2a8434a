#include "formats/effect/effect_files.h"

#include "base/text.h"
#include "formats/effect/effect_names.h"
#include "formats/look_format.h"
#include "glsl/text/include_paths.h"
#include "glsl/text/shader_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace fs = std::filesystem;

namespace {
constexpr const char* shared_folder = "include/";

// The folder of the look that a pass belongs to, and the prefix of its files in a stack.
struct LookFolder {
    fs::path folder;
    std::string prefix;
};

const StackPart* part_of(const Look& look, const Pass& pass) {
    for (std::size_t i = 0; i < look.stack.size(); ++i)
        if (name_prefix(look.stack, i) == pass.scope)
            return &look.stack[i];
    return nullptr;
}

LookFolder folder_of(const Look& look, const Pass& pass) {
    const StackPart* const part = part_of(look, pass);
    const fs::path manifest = part ? manifest_of(part->path) : look.manifest;
    const std::string prefix =
        pass.scope.empty() ? std::string() : identifier_from(pass.scope) + "/";
    return {manifest.parent_path(), prefix};
}

// Includes are relative to the folder of the including file.
std::string include_line(const std::string& from, const std::string& name) {
    const fs::path relative = fs::path(name).lexically_relative(
        fs::path(from).has_parent_path() ? fs::path(from).parent_path() : fs::path("."));
    return fmt::format("#include \"{}\"", relative.empty() ? name : relative.generic_string());
}

// The lines of a stage by their file. They differ from the file on disk in constants.
using StageLines = std::map<fs::path, std::map<int, std::string_view>>;

StageLines lines_by_file(const Stage& stage) {
    StageLines lines;
    const std::string_view text = stage.text;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < stage.lines.size(); ++i) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const Location at = stage.lines[i];
        lines[at.file].emplace(at.line, text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

// Lines that the program added to a stage, such as the macro of a driver. They have the location of
// the `#version` line above them.
std::string lines_added_to(const Stage& stage) {
    const auto texts = split(*stage.text, '\n');
    std::string added;
    std::optional<Location> version;
    for (std::size_t i = 0; i < stage.lines.size() && i < texts.size(); ++i) {
        if (version && stage.lines[i] == *version)
            added.append(texts[i]).push_back('\n');
        else if (!version && trim(texts[i]).starts_with("#version"))
            version = stage.lines[i];
    }
    return added;
}

std::string with_lines_after_version(const std::string& text, const std::string& added) {
    const std::size_t version = text.find("#version");
    const std::size_t end = version == text.npos ? text.npos : text.find('\n', version);
    return end == text.npos ? added + text : text.substr(0, end + 1) + added + text.substr(end + 1);
}

/// Reads the files of one shader.
class TreeReader {
public:
    TreeReader(const Look& look, const Pass& pass)
        : m_folder(folder_of(look, pass)),
          m_paths(pass.fragment.file, {m_folder.folder, look.includes}, m_disk),
          m_lines(lines_by_file(pass.fragment)),
          m_added(lines_added_to(pass.fragment)) {}

    Result<std::vector<EffectFile>> read(const fs::path& file) {
        if (auto added = add(file); !added)
            return fail(added.error());
        if (!m_added.empty())
            m_files.front().text = with_lines_after_version(m_files.front().text, m_added);
        return std::move(m_files);
    }

private:
    // The name of the file, which gets an entry with it.
    Result<std::string> add(const fs::path& file) {
        if (const auto known = m_names.find(file); known != m_names.end())
            return known->second;
        const Result<ShaderText>& read = m_disk.read(file);
        if (!read)
            return fail(read.error());
        const ShaderText text = *read;
        const std::string name = free_name(file);
        m_names[file] = name;
        const std::size_t index = m_files.size();
        m_files.push_back({name, {}, text.is_once});
        std::string changed;
        std::size_t done = 0;
        for (const ShaderText::Include& include : text.includes) {
            auto included = add_include(include, file);
            if (!included)
                return included;
            changed += text.text.substr(done, include.begin - done);
            changed += include_line(name, *included);
            m_files[index].includes.push_back(std::move(*included));
            done = include.end;
        }
        changed += text.text.substr(done);
        m_files[index].text = with_values(changed, file);
        return name;
    }

    Result<std::string> add_include(const ShaderText::Include& include, const fs::path& from) {
        const auto found =
            include.file ? m_paths.find(*include.file, from.parent_path()) : IncludePaths::Found{};
        if (!found.file)
            return fail({from, include.line, "can't find the included file"});
        return add(*found.file);
    }

    // The file's path below the look's folder, otherwise in a folder for shared files.
    std::string free_name(const fs::path& file) {
        const fs::path below = file.lexically_relative(m_folder.folder);
        const bool is_own = !below.empty() && *below.begin() != "..";
        std::string name = m_folder.prefix + (is_own ? below.generic_string()
                                                     : shared_folder + file.filename().string());
        const fs::path plain(name);
        for (int copy = 2; !m_taken.insert(name).second; ++copy)
            name = (plain.parent_path() /
                    fmt::format("{}-{}{}", plain.stem().string(), copy, plain.extension().string()))
                       .generic_string();
        return name;
    }

    // Takes the lines that the stage has instead. Lines with an include have none.
    std::string with_values(const std::string& text, const fs::path& file) const {
        const auto known = m_lines.find(file);
        if (known == m_lines.end())
            return text;
        std::string changed;
        int number = 0;
        for (std::size_t begin = 0; begin <= text.size();) {
            const std::size_t end = std::min(text.find('\n', begin), text.size());
            const auto line = known->second.find(++number);
            const std::string_view own = std::string_view(text).substr(begin, end - begin);
            const bool is_include = own.find("#include") != own.npos;
            changed += line != known->second.end() && !is_include ? line->second : own;
            if (end < text.size())
                changed += '\n';
            begin = end + 1;
        }
        return changed;
    }

    LookFolder m_folder;
    ShaderFiles m_disk;
    IncludePaths m_paths;
    StageLines m_lines;
    std::string m_added;
    std::vector<EffectFile> m_files;
    std::map<fs::path, std::string> m_names;
    std::set<std::string> m_taken;
};

bool is_own_format(const Look& look, const Pass& pass) {
    const StackPart* const part = part_of(look, pass);
    return !is_foreign_look(part ? part->path : look.manifest);
}

// Without characters that file systems or other programs do not allow.
std::string file_name_of(const Pass& pass) {
    std::string name = pass.name;
    std::ranges::replace_if(
        name,
        [](char c) {
            return !((c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                     c == '-' || c == '_' || c == '/');
        },
        '_');
    return name + ".frag";
}

class Joiner {
public:
    explicit Joiner(const std::vector<EffectFile>& files) : m_files(files) {}

    std::string joined(const EffectFile& file) {
        std::string text;
        std::size_t done = 0;
        std::size_t at = 0;
        for (const std::string& name : file.includes) {
            const std::string directive = include_line(file.name, name);
            at = file.text.find(directive, at);
            if (at == std::string::npos)
                break;
            text += file.text.substr(done, at - done) + included(name);
            done = at += directive.size();
        }
        return text + file.text.substr(done);
    }

private:
    std::string included(const std::string& name) {
        const auto file = std::ranges::find(m_files, name, &EffectFile::name);
        if (file == m_files.end() || (file->is_once && !m_once.insert(name).second))
            return {};
        return joined(*file);
    }

    const std::vector<EffectFile>& m_files;
    std::set<std::string> m_once;
};
}  // namespace

Result<std::vector<EffectFile>> effect_files(const Look& look, const Pass& pass) {
    if (!pass.fragment.file.empty() && is_own_format(look, pass))
        return TreeReader(look, pass).read(pass.fragment.file);
    return std::vector<EffectFile>{{file_name_of(pass), pass.fragment.text}};
}

std::string joined_text(const std::vector<EffectFile>& files) {
    return Joiner(files).joined(files.front());
}
