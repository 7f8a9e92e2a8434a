#include "formats/look_format.h"

#include "base/file.h"
#include "base/text.h"
#include "formats/foreign_format.h"
#include "formats/json/json_document.h"
#include "formats/look/look_manifest.h"
#include "glsl/parameters/constant_parameters.h"
#include "glsl/parameters/parameters.h"
#include "glsl/text/declarations.h"
#include "glsl/text/include.h"
#include "glsl/text/shader_files.h"
#include "model/plan/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

namespace fs = std::filesystem;

namespace {
// Loads each file once, even if several passes use it, and reports its errors once.
class StageLoader {
public:
    StageLoader(IncludeRoots roots, std::vector<fs::path>& files, ShaderFiles* disk)
        : m_roots(std::move(roots)), m_files(files), m_disk(disk ? *disk : m_own) {}

    Stage load(const fs::path& file) {
        const auto known = m_stages.find(file);
        if (known != m_stages.end())
            return known->second;
        auto stage = load_stage(file, m_roots, m_files, &m_disk);
        if (!stage)
            problems.insert(problems.end(), stage.error().begin(), stage.error().end());
        return m_stages[file] = stage ? std::move(*stage) : Stage{};
    }

    Diagnostics problems;

private:
    IncludeRoots m_roots;
    std::vector<fs::path>& m_files;
    ShaderFiles m_own;
    ShaderFiles& m_disk;
    std::map<fs::path, Stage> m_stages;
};

Diagnostics load_stages(Look& look, const IncludeFolders& includes, ShaderFiles* disk,
                        std::vector<fs::path>& files) {
    const fs::path folder = look.manifest.has_parent_path() ? look.manifest.parent_path() : ".";
    StageLoader loader({folder, includes, {}, folder}, files, disk);
    const bool has_macro = look.has_other_driver && look.driven_by == Driver::picture;
    const auto load = [&](const fs::path& file) {
        Stage stage = loader.load(file);
        return has_macro ? with_line_after_version(stage, "#define DRIVEN_BY_PICTURE") : stage;
    };
    for (Pass& pass : look.passes) {
        pass.fragment = load(pass.fragment.file);
        pass.vertex = pass.vertex.file.empty() ? fullscreen_vertex_stage() : load(pass.vertex.file);
    }
    return std::move(loader.problems);
}

// Checks the size expressions. They may use parameters, which are known last; any typical size
// reveals errors.
Diagnostics check_sizes(const Look& look) {
    constexpr Extent viewport{1280, 720};
    constexpr Extent source{640, 480};
    const auto plan = plan_targets(look, viewport, source, {});
    return plan ? Diagnostics{} : plan.error();
}

// Sorts parameters by the groups that the look lists. Parameters of other groups keep their order.
void order_by_groups(Look& look, Diagnostics& warnings) {
    const auto order_of = [&](const Parameter& parameter) {
        const auto found =
            std::ranges::find(look.groups, heading_of(look, parameter), &Heading::name);
        return found - look.groups.begin();
    };
    for (const Heading& group : look.groups) {
        const bool is_used = std::ranges::any_of(look.parameters, [&](const Parameter& parameter) {
            return heading_of(look, parameter) == group.name;
        });
        if (!is_used && !look.has_other_driver)  // the other driver may have them
            warnings.push_back({group.declared.file, group.declared.line,
                                fmt::format("the group '{}' has no parameters", group.name),
                                Severity::warning});
    }
    std::ranges::stable_sort(look.parameters, {}, order_of);
}

// The uniforms of the texts for the other driver, which its files name. Reading the look with that
// driver reports errors.
void find_other_parameters(Look& look, const IncludeFolders& includes, const LoadOptions& help,
                           std::vector<fs::path>& files) {
    auto other = load_manifest(look.manifest, files, help.disk, !help.is_picture_driven);
    if (!other)
        return;
    (void)load_stages(*other, includes, help.disk, files);
    std::set<fs::path> scanned;
    std::set<std::string> names;
    for (const Pass& pass : other->passes)
        for (const Stage* stage : {&pass.vertex, &pass.fragment})
            if (scanned.insert(stage->file).second)
                for (const Declaration& declaration : find_declarations(*stage->text))
                    if (!find_parameter(look, declaration.name))
                        names.insert(declaration.name);
    look.other_parameters.assign(names.begin(), names.end());
}

Result<Look> read_look(const fs::path& manifest, const IncludeFolders& includes,
                       const LoadOptions& help, LoadedLook& loaded) {
    auto look = load_manifest(manifest, loaded.files, help.disk, help.is_picture_driven);
    if (!look)
        return look;
    Diagnostics problems = load_stages(*look, includes, help.disk, loaded.files);
    if (!problems.empty())
        return fail(std::move(problems));
    loaded.is_parsed = true;
    problems = write_constants(*look, help.values, help.cache);
    if (!problems.empty())
        return fail(std::move(problems));
    auto parameters = find_parameters(*look, help.cache, loaded.warnings);
    if (!parameters)
        return fail(std::move(parameters.error()));
    look->parameters.insert(look->parameters.begin(), parameters->begin(), parameters->end());
    order_by_groups(*look, loaded.warnings);
    if (look->has_other_driver)
        find_other_parameters(*look, includes, help, loaded.files);
    problems = check_sizes(*look);
    if (!problems.empty())
        return fail(std::move(problems));
    return look;
}

LoadedLook load_any(const fs::path& manifest, const IncludeFolders& includes,
                    const LoadOptions& help) {
    if (const ForeignFormat* format = find_foreign_format(manifest))
        return format->load(manifest, includes, help);
    LoadedLook loaded;
    loaded.look = read_look(manifest, includes, help, loaded);
    return loaded;
}
}  // namespace

fs::path manifest_of(const fs::path& folder_or_manifest) {
    std::error_code error;
    return fs::is_directory(folder_or_manifest, error) ? folder_or_manifest / "look.json"
                                                       : folder_or_manifest;
}

LoadedLook load_look(const fs::path& folder_or_manifest, const IncludeFolders& includes,
                     const LoadOptions& help) {
    const fs::path manifest = manifest_of(folder_or_manifest);
    LoadedLook loaded = load_any(manifest, includes, help);
    if (std::ranges::find(loaded.files, manifest) == loaded.files.end())
        loaded.files.push_back(manifest);
    if (loaded.look)
        loaded.look->files = loaded.files;
    return loaded;
}

bool is_foreign_look(const fs::path& file) {
    return find_foreign_format(file) != nullptr;
}

std::string look_id_at(const fs::path& path) {
    return is_foreign_look(path) ? foreign_look_id(path) : look_id_of(manifest_of(path));
}

Stack with_driver(Stack stack, bool is_picture_driven) {
    const auto has_other_driver = [](const StackPart& part) {
        const fs::path manifest = manifest_of(part.path);
        if (is_foreign_look(manifest))
            return false;
        const auto text = read_text(manifest);
        const auto document = text ? parse_json(*text, manifest) : fail(text.error());
        const JsonValue* driver = document ? find_member(*document, "driven_by") : nullptr;
        return driver && driver->text == either_driver;
    };
    if (std::ranges::none_of(stack, has_other_driver))
        return stack;
    return with_picture_driven(std::move(stack), is_picture_driven);
}
