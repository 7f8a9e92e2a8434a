#include "formats/stack_format.h"

#include "formats/stacked_look.h"

#include <algorithm>
#include <map>

namespace fs = std::filesystem;

namespace {
void append(Diagnostics& all, const Diagnostics& some) {
    for (const Diagnostic& diagnostic : some)
        if (std::ranges::find(all, diagnostic) == all.end())
            all.push_back(diagnostic);
}

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

LoadedLook load_stack(Stack stack, const fs::path& shared_includes, const ReadingHelp& help) {
    std::map<fs::path, LoadedLook> read;
    std::vector<Look> looks;
    LoadedLook whole;
    whole.is_parsed = true;
    Diagnostics errors;
    for (const StackPart& part : stack) {
        const bool is_new = !read.contains(part.place);
        if (is_new)
            read.emplace(part.place, load_look(part.place, shared_includes, help));
        const LoadedLook& loaded = read.at(part.place);
        if (loaded.look)
            looks.push_back(*loaded.look);
        if (!is_new)
            continue;
        if (!loaded.look)
            append(errors, loaded.look.error());
        append(whole.warnings, loaded.warnings);
        whole.is_parsed = whole.is_parsed && loaded.is_parsed;
        for (const fs::path& file : loaded.files)
            if (std::ranges::find(whole.files, file) == whole.files.end())
                whole.files.push_back(file);
    }
    if (!errors.empty()) {
        whole.look = fail(std::move(errors));
        return whole;
    }
    name_parts(stack, looks);
    const bool is_alone = stack.size() == 1 && !stack.front().is_bypassed;
    whole.look = is_alone ? std::move(looks.front()) : stacked_look(looks, stack, whole.warnings);
    whole.look->stack = std::move(stack);
    return whole;
}
