#include "lab/views/snapshot.h"

#include "base/text.h"
#include "gpu/objects/readback.h"
#include "io/pictures/picture_file.h"
#include "lab/messages/messages.h"
#include "lab/rendering/renderer.h"
#include "lab/views/inspector_view.h"
#include "model/picture/black.h"

#include <fmt/format.h>

std::optional<RawPicture> snapshot(const Renderer& renderer, int pass, Messages& messages) {
    if (!renderer.has_whole_picture()) {
        messages.say("The picture is still rendering. Try again when it is done.", true);
        return std::nullopt;
    }
    const Executor& executor = renderer.executor();
    RawPicture picture;
    gpu::read_raw(executor.target(pass), picture);
    picture.encoding = encoding_of(executor.look(), pass);
    if (renderer.executors().inputs().is_black)
        blacken(picture);
    return picture;
}

namespace {
// As the inspector displays it, in 8 bits.
Result<Picture> seen_picture(const gpu::Texture& target, const ViewOptions& options) {
    auto viewer = Viewer::make();
    if (!viewer)
        return fail(viewer.error());
    auto canvas = gpu::Canvas::make(target.extent(), Format::rgba8);
    if (!canvas)
        return fail(canvas.error());
    viewer->draw(target, *canvas, options);
    Picture picture = gpu::read_picture(canvas->texture());
    picture.encoding = Encoding::display;
    return picture;
}
}  // namespace

void save_target(const Renderer& renderer, const PassView& view, std::filesystem::path file,
                 Messages& messages) {
    const auto inspected = inspected_texture(renderer.executor(), view);
    if (!inspected)
        return;
    const bool is_there =
        inspected->choice.from != Input::From::pass ||
        !renderer.executor().plan().targets[static_cast<std::size_t>(inspected->pass)].onto;
    if (!is_there)
        return messages.say("This pass isn't being inspected. Open the inspector first.", true);
    if (!renderer.has_whole_picture())
        return messages.say("The pass is still rendering. Try again when it is done.", true);
    auto texels = TexelInspector::make();
    if (!texels)
        return messages.say(texels.error().front());
    if (file.extension().empty())
        file += ".exr";
    const gpu::Texture& target = texels->level_of(*inspected);
    const bool is_seen = to_lower(file.extension().string()) == ".png";
    const auto picture = is_seen ? seen_picture(target, options_for(view, inspected->encoding))
                                 : gpu::read_picture(target);
    const auto saved = picture ? save_picture(*picture, file) : fail(picture.error());
    if (saved)
        messages.say(fmt::format("Saved \"{}\" to \"{}\"", inspected->choice.label(),
                                 file.filename().string()));
    else
        messages.say(saved.error().front());
}
