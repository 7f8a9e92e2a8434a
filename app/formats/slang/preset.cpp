#include "formats/slang/preset.h"

#include "base/text.h"
#include "formats/slang/chain.h"
#include "formats/slang/slang_text.h"
#include "formats/slang/wildcards.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace fs = std::filesystem;

namespace {
constexpr int max_slang_passes = 64;
constexpr std::size_t max_slang_textures = 64;
constexpr double largest_count = 1 << 24;

// Keys of the form KEYn for pass n.
constexpr std::array<std::string_view, 18> pass_keys{"shader",
                                                     "filter_linear",
                                                     "wrap_mode",
                                                     "repeat_mode",
                                                     "frame_count_mod",
                                                     "alias",
                                                     "srgb_framebuffer",
                                                     "mipmap_input",
                                                     "float_framebuffer",
                                                     "scale_type",
                                                     "scale_type_x",
                                                     "scale_type_y",
                                                     "scale",
                                                     "scale_x",
                                                     "scale_y",
                                                     "feedback_pass",
                                                     "texture_wrap_mode",
                                                     "rgb32_framebuffer"};
constexpr std::array<std::string_view, 5> preset_keys{"shaders", "textures", "parameters",
                                                      "feedback_pass", "imports"};
constexpr std::array<std::string_view, 4> texture_endings{"_linear", "_mipmap", "_wrap_mode",
                                                          "_repeat_mode"};

bool is_key_of_preset(std::string_view key) {
    const std::size_t end = key.find_last_not_of("0123456789") + 1;
    if (std::ranges::find(preset_keys, key) != preset_keys.end())
        return true;
    return end < key.size() && std::ranges::find(pass_keys, key.substr(0, end)) != pass_keys.end();
}

std::vector<std::string> names_in(const SlangSetting* list) {
    std::vector<std::string> names;
    if (!list)
        return names;
    for (const std::string_view name : split(list->value, ';'))
        if (!trim(name).empty())
            names.emplace_back(trim(name));
    return names;
}

class PresetReader {
public:
    PresetReader(const fs::path& file, SlangFiles& files) : m_opened(file), m_files(files) {}

    Result<SlangPreset> read() {
        auto chain = read_slang_chain(m_opened, m_files, m_preset.warnings);
        if (!chain)
            return fail(chain.error());
        m_owner = &chain->owner;
        read_passes();
        read_textures();
        take_values(chain->owner);
        for (const SlangSettings& change : chain->changes) {
            take_texture_paths(change);
            take_values(change);
        }
        warn_of_missing_paths();
        if (!m_errors.empty())
            return fail(std::move(m_errors));
        return std::move(m_preset);
    }

private:
    void error(const SlangSetting& setting, std::string message) {
        m_errors.push_back({setting.declared.file, setting.declared.line, std::move(message)});
    }

    void warn(const Location& at, std::string message) {
        add_new(m_preset.warnings, {at.file, at.line, std::move(message), Severity::warning});
    }

    fs::path file_of(const SlangSetting& setting) {
        if (std::string fault = fault_of_slang_path(setting.value); !fault.empty()) {
            error(setting, std::move(fault));
            return {};
        }
        return find_slang_file(setting.value, setting.declared.file, m_opened, m_files);
    }

    std::optional<bool> boolean(const std::string& key) {
        const SlangSetting* setting = m_owner->find(key);
        return setting ? read_slang_boolean(*setting, m_preset.warnings) : std::nullopt;
    }

    void read_passes() {
        const SlangSetting& shaders = *m_owner->find("shaders");
        const double count = leading_number(shaders.value).value_or(0.0);
        if (count < 1.0 || count >= max_slang_passes + 1.0)
            return error(shaders,
                         fmt::format("'shaders' must be a number of passes from 1 to {}, got '{}'",
                                     max_slang_passes, shaders.value));
        for (int i = 0; i < static_cast<int>(count); ++i)
            read_pass(std::to_string(i), shaders);
    }

    void read_pass(const std::string& number, const SlangSetting& shaders) {
        SlangPass& pass = m_preset.passes.emplace_back();
        const SlangSetting* shader = m_owner->find("shader" + number);
        if (!shader || shader->value.empty()) {
            const SlangSetting& at = shader ? *shader : shaders;
            return error(at, fmt::format("pass {} of {} has no shader; 'shader{}' is missing",
                                         number, shaders.value, number));
        }
        pass.shader = file_of(*shader);
        pass.declared = shader->declared;
        pass.is_linear = boolean("filter_linear" + number);
        const SlangSetting* wrap = m_owner->find("wrap_mode" + number);
        pass.wrap = wrap_of(wrap ? wrap : m_owner->find("repeat_mode" + number));
        pass.is_srgb = boolean("srgb_framebuffer" + number).value_or(false);
        pass.is_float = boolean("float_framebuffer" + number).value_or(false);
        pass.reads_mipmaps = boolean("mipmap_input" + number).value_or(false);
        if (const SlangSetting* alias = m_owner->find("alias" + number))
            pass.alias = alias->value;
        if (const SlangSetting* modulo = m_owner->find("frame_count_mod" + number))
            pass.frame_count_mod = static_cast<int>(
                std::clamp(read_slang_number(*modulo, m_preset.warnings), 0.0, largest_count));
        pass.scale = scale_of(number);
    }

    Wrap wrap_of(const SlangSetting* setting) {
        if (!setting)
            return Wrap::border;
        const std::map<std::string, Wrap> words{{"clamp_to_border", Wrap::border},
                                                {"clamp_to_edge", Wrap::edge},
                                                {"repeat", Wrap::repeat},
                                                {"mirrored_repeat", Wrap::mirror}};
        const auto found = words.find(to_lower(setting->value));
        if (found != words.end())
            return found->second;
        warn(setting->declared,
             fmt::format(
                 "'{}' must be clamp_to_border, clamp_to_edge, repeat or mirrored_repeat, got "
                 "'{}'; clamp_to_border is used",
                 setting->key, setting->value));
        return Wrap::border;
    }

    // With any scale_type, both sides are scaled. A type for both sides takes precedence over one
    // for a side.
    std::optional<std::array<SlangScale, 2>> scale_of(const std::string& number) {
        std::array<SlangScale, 2> scale;
        bool is_said = false;
        const std::array<std::string, 2> sides{"_x", "_y"};
        for (std::size_t i = 0; i < 2; ++i) {
            const SlangSetting* type = either("scale_type", sides[i], number);
            const SlangSetting* factor = either("scale", sides[i], number);
            is_said = is_said || type;
            if (type)
                scale[i].by = base_of(*type);
            if (factor)
                scale[i].factor = read_slang_number(*factor, m_preset.warnings);
            if (scale[i].by == SlangScale::By::absolute)
                scale[i].factor = std::trunc(scale[i].factor);
        }
        return is_said ? std::optional(scale) : std::nullopt;
    }

    const SlangSetting* either(const std::string& key, const std::string& side,
                               const std::string& number) const {
        const SlangSetting* both = m_owner->find(key + number);
        return both ? both : m_owner->find(key + side + number);
    }

    SlangScale::By base_of(const SlangSetting& type) {
        const std::string word = to_lower(type.value);
        if (word == "viewport")
            return SlangScale::By::viewport;
        if (word == "absolute")
            return SlangScale::By::absolute;
        if (word == "original")
            return SlangScale::By::original;
        if (word != "source")
            error(type, fmt::format("'{}' must be source, viewport, absolute or original, got '{}'",
                                    type.key, type.value));
        return SlangScale::By::source;
    }

    void read_textures() {
        const SlangSetting* list = m_owner->find("textures");
        std::vector<std::string> names = names_in(list);
        std::erase_if(
            names, [&](const std::string& name) { return !m_texture_names.insert(name).second; });
        if (names.size() > max_slang_textures)
            return error(*list, fmt::format("the preset has {} textures; the limit is {}",
                                            names.size(), max_slang_textures));
        for (const std::string& name : names) {
            SlangTexture& texture = m_preset.textures.emplace_back();
            texture.name = name;
            texture.declared = list->declared;
            texture.is_linear = boolean(name + "_linear");
            texture.is_mipmapped = boolean(name + "_mipmap").value_or(false);
            const SlangSetting* wrap = m_owner->find(name + "_wrap_mode");
            texture.wrap = wrap_of(wrap ? wrap : m_owner->find(name + "_repeat_mode"));
        }
        take_texture_paths(*m_owner);
    }

    void take_texture_paths(const SlangSettings& settings) {
        for (SlangTexture& texture : m_preset.textures) {
            const SlangSetting* path = settings.find(texture.name);
            if (!path || path->value.empty())
                continue;
            texture.file = file_of(*path);
            texture.declared = path->declared;
        }
    }

    void take_values(const SlangSettings& settings) {
        // A file may refer to textures of another owner; a name with a path counts, too.
        std::set<std::string> names = m_texture_names;
        for (std::string& name : names_in(settings.find("textures")))
            names.insert(std::move(name));
        for (const SlangSetting& setting : settings.settings) {
            if (is_key_of_preset(setting.key) || is_of_texture(setting.key, names))
                continue;
            if (const auto number = leading_number(setting.value)) {
                m_preset.values[setting.key] = {*number, setting.declared};
                if (std::string note = decimal_comma_note(setting.key, setting.value);
                    !note.empty())
                    warn(setting.declared, std::move(note));
            } else if (setting.value.find_first_of("/\\") == std::string::npos)
                warn(setting.declared, fmt::format("'{}' must be a number, got '{}'; it is ignored",
                                                   setting.key, setting.value));
        }
    }

    static bool is_of_texture(const std::string& key, const std::set<std::string>& names) {
        if (names.contains(key))
            return true;
        return std::ranges::any_of(texture_endings, [&](std::string_view ending) {
            return key.ends_with(ending) &&
                   names.contains(key.substr(0, key.size() - ending.size()));
        });
    }

    void warn_of_missing_paths() {
        for (const SlangTexture& texture : m_preset.textures)
            if (texture.file.empty())
                warn(texture.declared,
                     fmt::format("texture '{}' has no path; '{} = file' is missing", texture.name,
                                 texture.name));
    }

    const fs::path& m_opened;
    SlangFiles& m_files;
    const SlangSettings* m_owner = nullptr;
    SlangPreset m_preset;
    std::set<std::string> m_texture_names;
    Diagnostics m_errors;
};
}  // namespace

Result<SlangPreset> read_slang_preset(const fs::path& file, SlangFiles& files) {
    return PresetReader(file, files).read();
}

SlangPreset slang_preset_of(const fs::path& shader) {
    SlangPreset preset;
    preset.passes.emplace_back();
    preset.passes.back().shader = shader;
    preset.passes.back().declared = {shader, 1};
    return preset;
}
