#include "lab/snapshot.h"

#include "gpu/readback.h"
#include "lab/sharing.h"

void save_snapshot(Lab& lab, std::filesystem::path file) {
    if (!lab.document() || !lab.renderer())
        return;
    if (file.extension().empty())
        file += ".png";
    const Executor& executor = lab.renderer()->executor();
    const int last = static_cast<int>(executor.look().passes.size()) - 1;
    Picture picture = gpu::read_picture(executor.target(last));
    picture.encoding = executor.look().output;
    const auto saved =
        save_picture_with_preset(picture, *lab.document(), file, lab.drive().recent());
    if (saved)
        lab.say("Saved the picture as '" + file.filename().string() + "'");
    else
        lab.say(saved.error().front());
}
