// Sound files. The first letter selects the file type.

#include "fuzz/fuzz_files.h"
#include "io/sound/sound_file.h"

void fuzz_one(std::string_view input) {
    static const std::vector<std::string> names{"a.wav", "b.flac", "c.ogg", "d.mp3", "e.aiff"};
    static FuzzFolder folder(names);
    if (input.empty())
        return;
    const std::size_t kind = static_cast<unsigned char>(input.front()) % names.size();
    folder.write(kind, input.substr(1));
    Diagnostics notes;
    if (const auto sound = load_sound(folder.file(kind), nullptr, &notes); !sound)
        require_reasons(sound.error());
}
