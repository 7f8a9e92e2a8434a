#include "formats/slang/slang_format.h"

#include "base/pass_progress.h"
#include "base/text.h"
#include "formats/slang/chain_look.h"
#include "formats/slang/similar_file.h"
#include "glsl/cache/check_cache.h"
#include "glsl/parameters/constant_parameters.h"
#include "model/look/subframe.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace fs = std::filesystem;

namespace {
constexpr const char* pixel_art = "pattern:harbour";

/// Loads and translates shaders, each once, even if several passes use it.
class ChainLoader {
public:
    ChainLoader(SlangFiles& files, CheckCache* cache, ConstantParameters& constants)
        : m_files(files), m_cache(cache), m_constants(constants) {}

    void read(const SlangPass& pass, TranslatedChain& chain) {
        auto known = m_known.find(pass.shader);
        if (known == m_known.end())
            known = m_known.emplace(pass.shader, read_anew(pass)).first;
        if (!known->second)
            return;
        m_constants.bind(known->second->constants, chain.shaders.size());
        chain.shaders.push_back(known->second->shader);
        chain.translations.push_back(known->second->translation);
    }

    Diagnostics problems;
    bool is_parsed = true;

private:
    struct Read {
        SlangShader shader;
        Translation translation;
        std::vector<std::string> constants;
    };

    // Errors without a line in the shader file are reported at the preset's line.
    void refuse(const SlangPass& pass, const Diagnostics& why) {
        const std::string name = pass.alias.empty() ? pass.shader.stem().string() : pass.alias;
        for (Diagnostic problem : why) {
            if (problem.file == pass.shader && problem.line == 0) {
                problem.message = with_file_name(pass, problem.message);
                problem.file = pass.declared.file;
                problem.line = pass.declared.line;
            }
            problem.message = fmt::format("pass '{}': {}", name, problem.message);
            add_new(problems, std::move(problem));
        }
    }

    static std::string with_file_name(const SlangPass& pass, const std::string& message) {
        std::error_code error;
        if (fs::exists(pass.shader, error))
            return fmt::format("'{}': {}", pass.shader.filename().string(), message);
        return fmt::format("can't read '{}' ({}): {}{}", pass.shader.filename().string(),
                           pass.shader.string(), message,
                           similar_file(pass.shader, pass.declared.file));
    }

    std::optional<Read> read_anew(const SlangPass& pass) {
        auto shader = read_slang_shader(pass.shader, m_files);
        if (!shader) {
            refuse(pass, shader.error());
            is_parsed = false;
            return std::nullopt;
        }
        std::vector<std::string> constants = m_constants.write_into(shader->vertex);
        std::ranges::move(m_constants.write_into(shader->fragment), std::back_inserter(constants));
        auto translation = m_cache ? m_cache->translate(shader->vertex, shader->fragment)
                                   : translate_from_vulkan(shader->vertex, shader->fragment);
        if (!translation) {
            refuse(pass, translation.error());
            return std::nullopt;
        }
        return Read{std::move(*shader), std::move(*translation), std::move(constants)};
    }

    SlangFiles& m_files;
    CheckCache* m_cache;
    ConstantParameters& m_constants;
    std::map<fs::path, std::optional<Read>> m_known;
};

Result<TranslatedChain> read_chain(const fs::path& file, SlangFiles& files, const LoadOptions& help,
                                   ConstantParameters& constants, bool& is_parsed) {
    TranslatedChain chain;
    if (is_slang_shader(file)) {
        chain.preset = slang_preset_of(file);
    } else {
        auto preset = read_slang_preset(file, files);
        if (!preset)
            return fail(preset.error());
        chain.preset = std::move(*preset);
    }
    ChainLoader reader(files, help.cache, constants);
    if (help.progress)
        help.progress->begin(PassProgress::Step::reading, chain.preset.passes.size());
    for (const SlangPass& pass : chain.preset.passes) {
        if (help.progress && !help.progress->next(pass.shader.stem().string()))
            return fail({file, 0, "loading was cancelled"});
        reader.read(pass, chain);
    }
    is_parsed = reader.is_parsed;
    if (!reader.problems.empty())
        return fail(std::move(reader.problems));
    return chain;
}

bool reads_the_past(const Look& look) {
    return std::ranges::any_of(look.passes, [](const Pass& pass) {
        return std::ranges::any_of(pass.inputs,
                                   [](const Input& input) { return input.frames_ago > 0; });
    });
}

constexpr const char* filter_name = "unspecified_filter";

Filter other_than(Filter filter) {
    return filter == Filter::nearest ? Filter::linear : Filter::nearest;
}

// Adds a parameter for a choice that presets leave to the host, bound to all affected passes. Its
// value changes the look, like a constant in the texts.
void add_filter(const TranslatedChain& chain, Filter chosen, Look& look) {
    Diagnostics already_reported;
    const auto other = look_of_chain(chain, {other_than(chosen)}, already_reported);
    if (!other || find_parameter(look, filter_name))
        return;
    Parameter filter;
    for (std::size_t i = 0; i < look.passes.size(); ++i)
        if (look.passes[i] != other->passes[i])
            filter.bindings.push_back({static_cast<int>(i), filter_name});
    if (filter.bindings.empty())
        return;
    filter.name = filter_name;
    filter.label = "Default filter";
    filter.group = "Sampling";
    filter.help =
        "Texture filter of passes that don't set filter_linear in the preset. It corresponds to "
        "RetroArch's setting Bilinear Filtering.";
    filter.type = {Scalar::integer, 1, 1};
    filter.control = Control::list;
    filter.items = {{0.0, "Nearest"}, {1.0, "Linear"}};
    filter.range = {0.0, 1.0, 1.0};
    filter.initial = 0.0;
    filter.is_constant = true;
    filter.declared = look.passes.front().declared;
    look.constants[filter.name] = chosen == Filter::linear ? 1.0 : 0.0;
    look.parameters.push_back(std::move(filter));
}

bool reads_subframes(const Translation& shader) {
    return std::ranges::any_of(shader.members, [](const BlockMember& member) {
        return member.name == "TotalSubFrames" || member.name == "CurrentSubFrame";
    });
}

// With HDR, such a shader writes light in units of 80 cd/m2 (scRGB).
bool is_for_hdr(const TranslatedChain& chain) {
    return std::ranges::any_of(chain.translations.back().members,
                               [](const BlockMember& member) { return member.name == "HDRMode"; });
}

// Adds a parameter for the number of sub-frames, which presets leave to the host.
void add_subframes(const TranslatedChain& chain, Look& look) {
    constexpr const char* name = "subframes";
    if (std::ranges::none_of(chain.translations, reads_subframes) || find_parameter(look, name))
        return;
    Parameter count;
    count.name = name;
    count.label = "Sub-frames";
    count.group = "Sub-frames";
    count.help =
        "Frames per source picture. It corresponds to RetroArch's setting Shader Sub-frames. The "
        "window draws fewer if the display is too slow for them.";
    count.type = {Scalar::integer, 1, 1};
    count.range = {1.0, double{max_subframes}, 1.0};
    count.limit = Limit{1.0, double{max_subframes}};
    count.initial = 1.0;
    count.declared = look.passes.front().declared;
    look.subframes = count.name;
    look.parameters.push_back(std::move(count));
}

Filter chosen_filter(const LoadOptions& help) {
    if (!help.values)
        return Filter::nearest;
    const auto chosen = help.values->find(filter_name);
    return chosen != help.values->end() && chosen->second.number() > 0.0 ? Filter::linear
                                                                         : Filter::nearest;
}

Result<Look> read_look_of(const fs::path& file, SlangFiles& files, const LoadOptions& help,
                          LoadedLook& loaded) {
    constexpr int frames_of_a_past = 60;
    ConstantParameters constants(help.values, help.cache);
    const auto chain = read_chain(file, files, help, constants, loaded.is_parsed);
    if (!chain)
        return fail(chain.error());
    add_new(loaded.warnings, chain->preset.warnings);
    for (const SlangShader& shader : chain->shaders)
        add_new(loaded.warnings, shader.warnings);
    for (const Translation& translation : chain->translations)
        add_new(loaded.warnings, translation.warnings);
    const Filter filter = chosen_filter(help);
    auto look = look_of_chain(*chain, {filter}, loaded.warnings);
    if (!look)
        return look;
    if (auto problems = constants.add_to(*look); !problems.empty())
        return fail(std::move(problems));
    add_filter(*chain, filter, *look);
    add_subframes(*chain, *look);
    look->is_scrgb_in_hdr = is_for_hdr(*chain);
    look->id = foreign_look_id(file);
    look->name = file.stem().string();
    look->driven_by = Driver::picture;
    look->default_source = pixel_art;
    look->source_encoding = Encoding::display;
    look->source_rows = RowOrder::top_first;
    look->source_format = Format::rgba8;
    look->output = Encoding::display;
    look->settle_frames = reads_the_past(*look) ? frames_of_a_past : 1;
    look->manifest = file;
    return look;
}
}  // namespace

bool is_slang_file(const fs::path& file) {
    return is_slang_shader(file) || to_lower(file.extension().string()) == ".slangp";
}

LoadedLook load_slang_look(const fs::path& file, const LoadOptions& help) {
    SlangFiles files;
    LoadedLook loaded;
    loaded.look = read_look_of(file, files, help, loaded);
    loaded.files = files.seen();
    return loaded;
}
