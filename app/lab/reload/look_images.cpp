#include "lab/reload/look_images.h"

#include "graph/targets/image_texture.h"
#include "lab/media/image_budget.h"
#include "lab/media/look_media.h"

namespace fs = std::filesystem;

Result<ImageTextures> LookImages::load(const Look& look, Diagnostics& warnings) {
    ImageTextures images;
    std::map<fs::path, ReadImage> read;
    Diagnostics problems;
    ImageBudget budget;
    const auto note = [&problems](const Diagnostics& some) {
        problems.insert(problems.end(), some.begin(), some.end());
    };
    for (const Image& image : look.images) {
        std::error_code error;
        ReadImage now{last_write_time_of(image, error), image, look.source_encoding,
                      reads_mipmaps(look, Input::From::image, image.name), nullptr};
        const auto before = m_read.find(image.file);
        if (!error && before != m_read.end() && before->second.serves(now)) {
            now.texture = before->second.texture;
        } else {
            const auto picture = load_image(image, warnings);
            if (!picture)
                note(picture.error());
            if (!picture || !*picture)
                continue;
            const auto fits = budget.take(image, **picture);
            if (!fits)
                return fail(fits.error());
            auto texture = image_texture(look, image.name, **picture);
            if (!texture) {
                note(texture.error());
                continue;
            }
            now.texture = std::move(*texture);
        }
        images[image.name] = now.texture;
        if (!image.file.empty())  // otherwise it is generated
            read.insert_or_assign(image.file, std::move(now));
    }
    m_read = std::move(read);
    if (!problems.empty())
        return fail(std::move(problems));
    return images;
}
