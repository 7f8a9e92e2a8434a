#include "cli/cli.h"
#include "cli/common.h"
#include "cli/progress.h"
#include "lab/document/sharing.h"

#include <fmt/format.h>

#include <iostream>

int render_instead_of_window(const std::string& look, const DataFolders& data) {
    const auto library = open_library(data);
    if (!library)
        return report(library.error());
    RenderRequest request;
    request.look = look.empty() ? "phosphor" : look;
    auto prepared = prepare(request, *library);
    if (!prepared)
        return report(prepared.error());
    auto offline = Offline::create(std::move(*prepared), request.size, request.fps);
    if (!offline)
        return report(offline.error());
    const int frames = offline->document().look().settle_frames;
    Progress progress(Progress::Kind::rendering_frames, frames);
    for (int frame = 0; frame < frames; ++frame) {
        frame + 1 < frames ? offline->advance_unseen() : offline->advance();
        progress.show(frame + 1);
    }
    const auto file =
        std::filesystem::absolute("afterglow-" + offline->document().look().id + ".png");
    const auto saved = save_picture_with_preset(offline->picture(), offline->document(), file,
                                                RecentMedia(library->roots()));
    if (!saved)
        return report(saved.error());
    std::cout << fmt::format("Rendered to {}\n", file.string());
    return exit_done;
}
