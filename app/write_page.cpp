// Writes the parts of the exported web page as C++; runs at build time.
#include "base/file.h"
#include "formats/web/packed_text.h"

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <string>

namespace {
// Compilers limit the length of a literal.
std::string literal_of(std::string_view text) {
    constexpr std::size_t longest = 8000;
    std::string literal;
    for (std::size_t at = 0; at < text.size(); at += longest)
        literal += fmt::format("\n    R\"page({})page\"", text.substr(at, longest));
    return literal.empty() ? "\"\"" : literal;
}
}  // namespace

/// write_page OUTPUT FILE...: the files are the members of PageParts, in order. Scripts are packed.
int main(int count, char** arguments) {
    if (count < 3)
        return 2;
    std::ofstream output(arguments[1]);
    output << "#include \"formats/web/page_parts.h\"\n\nPageParts page_parts() {\n    return {";
    for (int i = 2; i < count; ++i) {
        const auto bytes = read_bytes(arguments[i]);
        if (!bytes) {
            std::fputs(to_string(bytes.error()).c_str(), stderr);
            return 1;
        }
        const bool is_script = std::string_view(arguments[i]).ends_with(".js");
        output << (i > 2 ? ",\n    " : "") << literal_of(is_script ? gzip_base64(*bytes) : *bytes);
    }
    output << "};\n}\n";
    return output.flush() ? 0 : 1;
}
