// Whole looks, compilers included, which are a hundred times slower. The first letter of a text
// selects the kind of file.

#include "formats/look_format.h"
#include "fuzz/fuzz_files.h"

void fuzz_one(std::string_view input) {
    static FuzzFolder folder({"0.slangp", "0.slang", "0.fs", "0.vs", "0.json", "0.frag", "0.txt"});
    if (input.empty())
        return;
    const auto kind = static_cast<std::size_t>(static_cast<unsigned char>(input.front())) % 6;
    const std::size_t first = kind < 3 ? kind : kind + 1;
    const std::string text(input.substr(1));
    folder.fill(std::string(first, '\f') + text);
    const LoadedLook loaded = load_look(folder.file(first), folder.file(0).parent_path());
    if (!loaded.look)
        require_reasons(loaded.look.error());
}
