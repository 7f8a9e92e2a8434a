// ZIP files of unknown origin.

#include "fuzz/fuzz_files.h"
#include "io/files/zip.h"

void fuzz_one(std::string_view input) {
    static FuzzFolder folder({"pack.zip", "unpacked/keep"});
    folder.write(0, input);
    const ZipLimits limits{.files = 100, .bytes = 1 << 20, .ratio = 100.0};
    if (const auto checked = check_zip(folder.file(0), limits); !checked)
        require_reasons(checked.error());
    static_cast<void>(read_in_zip(folder.file(0), "pack.json", 1 << 16));
    const auto target = folder.file(1).parent_path();
    if (const auto unpacked = unzip(folder.file(0), target, limits); !unpacked)
        require_reasons(unpacked.error());
    std::error_code error;
    for (const auto& file : std::filesystem::directory_iterator(target, error))
        std::filesystem::remove_all(file.path(), error);
}
