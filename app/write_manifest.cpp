// Writes the list of shipped files as C++; runs at build time.
#include "base/file.h"
#include "base/text.h"

#include <cstdio>
#include <fstream>

/// write_manifest ROOT OUTPUT FILE...: FILE is a path below ROOT.
int main(int count, char** arguments) {
    if (count < 3)
        return 2;
    std::ofstream output(arguments[2]);
    output
        << "#include \"lab/library/shipped_files.h\"\n\n#include <cstdint>\n#include <iterator>\n"
           "#include <utility>\n\nnamespace {\n"
           "constexpr std::pair<const char*, std::uint64_t> files[] = {\n";
    for (int i = 3; i < count; ++i) {
        const auto bytes = read_bytes(std::filesystem::path(arguments[1]) / arguments[i]);
        if (!bytes) {
            std::fputs(to_string(bytes.error()).c_str(), stderr);
            return 1;
        }
        output << "    {\"" << arguments[i] << "\", " << digest_of(*bytes) << "ULL},\n";
    }
    output << "};\n}  // namespace\n\nShippedFiles files_of_build() {\n"
              "    return {std::begin(files), std::end(files)};\n}\n";
    return output.flush() ? 0 : 1;
}
