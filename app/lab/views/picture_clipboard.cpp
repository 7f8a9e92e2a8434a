#include "lab/views/picture_clipboard.h"

#include "io/pictures/picture_file.h"
#include "io/system/child_process.h"
#include "lab/document/sharing.h"
#include "lab/messages/messages.h"
#include "lab/views/snapshot.h"

#include <fmt/format.h>

#include <cstdlib>

namespace {
bool has_variable(const char* name) {
    const char* const value = std::getenv(name);
    return value && *value;
}

// wl-copy serves the clipboard from a process of its own.
Result<void> offer_on_wayland(const std::string& png) {
    auto copier = ChildProcess::start({"wl-copy", "--type", "image/png"}, {.inputs = 1});
    if (!copier)
        return fail({{},
                     0,
                     "copying pictures on Wayland needs the Debian package wl-clipboard. Install "
                     "it and try again."});
    copier->set_timeout(10.0);
    const bool is_read = copier->feed(0, png);
    copier->end_input(0);
    if (!copier->finish() || !is_read)
        return fail({{}, 0, fmt::format("can't copy the picture: {}", copier->complaint())});
    return {};
}
}  // namespace

Result<void> PictureClipboard::offer(std::string png) {
    if (!has_variable("DISPLAY") && has_variable("WAYLAND_DISPLAY"))
        return offer_on_wayland(png);
    if (!m_clipboard) {
        auto opened = gpu::ImageClipboard::open();
        if (!opened)
            return fail(opened.error());
        m_clipboard = std::move(*opened);
    }
    return m_clipboard->offer(std::move(png));
}

void PictureClipboard::copy(const Renderer& renderer, int pass, const Document& document,
                            const RecentMedia& recent, Messages& messages) {
    const auto picture = snapshot(renderer, pass, messages);
    if (!picture)
        return;
    auto png = png_of(picture_of(*picture), document, recent);
    if (!png) {
        messages.say(png.error().front());
        return;
    }
    if (messages.succeeded(offer(std::move(*png))))
        messages.say(fmt::format("Copied the picture ({} × {})", picture->extent.width,
                                 picture->extent.height));
}
