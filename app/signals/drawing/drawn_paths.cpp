#include "signals/drawing/drawn_paths.h"

#include "signals/drawing/path_signals.h"
#include "signals/signal/settings.h"

Result<DrawnPaths> drawn_paths(const Spec& completed, const SignalMedia& media) {
    const Settings settings(completed);
    DrawnPaths paths;
    if (completed.kind == "text") {
        paths.scene = text_scene(settings);
    } else if (completed.kind == "scene") {
        auto scene = file_scene(media, settings);
        if (!scene)
            return fail(scene.error());
        paths.scene = std::move(*scene);
    } else if (completed.kind == "drawing") {
        auto drawing = drawing_steps(media, settings);
        if (!drawing)
            return fail(drawing.error());
        paths.drawing = std::move(*drawing);
    }
    return paths;
}
