#include "formats/stack/stack_format.h"

#include "formats/stack/stacked_look.h"
#include "glsl/cache/check_cache.h"

#include <algorithm>
#include <optional>

namespace fs = std::filesystem;

namespace {
void name_parts(Stack& stack, const std::vector<Look>& looks) {
    for (std::size_t i = 0; i < stack.size(); ++i)
        if (stack[i].look.empty())
            stack[i].look = looks[i].id;
    const std::vector<std::string> keys = stack_keys(stack);
    for (std::size_t i = 0; i < stack.size(); ++i)
        if (stack[i].tag.empty())
            stack[i].tag = keys[i];
}
}  // namespace

namespace {
// The values of one part of a stack, under the part's own names.
Values values_of_part(const Values& values, const Stack& stack, std::size_t part) {
    const std::string scope = name_prefix(stack, part);
    Values own;
    for (const auto& [name, value] : values)
        if (name.starts_with(scope))
            own[name.substr(scope.size())] = value;
    return own;
}

/// Loads the looks of a stack; looks with equal values only once.
class PartReader {
public:
    PartReader(Stack stack, const IncludeFolders& includes, const LoadOptions& help)
        : m_stack(std::move(stack)), m_includes(includes), m_help(help) {
        for (StackPart& part : m_stack)  // so that values_of_part() finds their values
            if (part.look.empty())
                part.look = look_id_at(part.path);
    }

    void read(std::size_t part, LoadedLook& whole) {
        const Values values =
            m_help.values ? values_of_part(*m_help.values, m_stack, part) : Values{};
        const auto is_same = [&](const Read& read) {
            return read.path == m_stack[part].path && read.values == values &&
                   read.is_picture_driven == m_stack[part].is_picture_driven;
        };
        const auto known = std::ranges::find_if(m_read, is_same);
        if (known != m_read.end()) {
            if (known->look)
                looks.push_back(*known->look);
            return;
        }
        LoadedLook loaded = load_look(
            m_stack[part].path, m_includes,
            {m_help.cache, m_help.progress, &values, m_help.disk, m_stack[part].is_picture_driven});
        add_new(whole.warnings, loaded.warnings);
        whole.is_parsed = whole.is_parsed && loaded.is_parsed;
        for (const fs::path& file : loaded.files)
            if (std::ranges::find(whole.files, file) == whole.files.end())
                whole.files.push_back(file);
        m_read.push_back({m_stack[part].path, values, m_stack[part].is_picture_driven, {}});
        if (!loaded.look)
            return add_new(errors, loaded.look.error());
        looks.push_back(*loaded.look);
        m_read.back().look = std::move(*loaded.look);
    }

    std::vector<Look> looks;
    Diagnostics errors;

private:
    struct Read {
        fs::path path;
        Values values;
        bool is_picture_driven = false;
        std::optional<Look> look;
    };

    Stack m_stack;
    const IncludeFolders& m_includes;
    const LoadOptions& m_help;
    std::vector<Read> m_read;
};
}  // namespace

LoadedLook load_stack(Stack stack, const IncludeFolders& includes, const LoadOptions& help) {
    LoadedLook whole;
    whole.is_parsed = true;
    PartReader reader(stack, includes, help);
    for (std::size_t i = 0; i < stack.size(); ++i)
        reader.read(i, whole);
    std::vector<Look>& looks = reader.looks;
    if (!reader.errors.empty()) {
        whole.look = fail(std::move(reader.errors));
        return whole;
    }
    name_parts(stack, looks);
    const bool is_alone = stack.size() == 1 && !stack.front().is_bypassed;
    whole.look = is_alone ? std::move(looks.front()) : stacked_look(looks, stack, whole.warnings);
    whole.look->stack = std::move(stack);
    whole.look->includes = includes;
    if (help.cache)
        whole.look->shader_limits = help.cache->limits();
    return whole;
}

LoadedLook load_again(const Look& look, const Stack& stack, const LoadOptions& help) {
    CheckCache checks(nullptr, look.shader_limits);
    LoadOptions all = help;
    if (!all.cache)
        all.cache = &checks;
    return load_stack(stack, look.includes, all);
}
