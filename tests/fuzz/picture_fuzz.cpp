// Pictures. The first letter selects the file type.

#include "fuzz/fuzz_files.h"
#include "io/pictures/picture_file.h"

void fuzz_one(std::string_view input) {
    static const std::vector<std::string> names{"a.png", "b.jpg",  "c.exr", "d.hdr", "e.tga",
                                                "f.bmp", "g.tiff", "h.gif", "i.webp"};
    static FuzzFolder folder(names);
    if (input.empty())
        return;
    const std::size_t kind = static_cast<unsigned char>(input.front()) % names.size();
    folder.write(kind, input.substr(1));
    if (const auto picture = load_picture(folder.file(kind)); !picture)
        require_reasons(picture.error());
    else
        require(picture->pixels.size() == picture->index(0, picture->extent.height),
                "a picture has all pixels");
}
