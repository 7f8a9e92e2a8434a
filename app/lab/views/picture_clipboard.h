#pragma once

#include "gpu/image_clipboard.h"

#include <memory>

class Document;
class Messages;
class RecentMedia;
class Renderer;

/// Copies pictures to the clipboard of the desktop: of an X server, otherwise by the program
/// wl-copy to that of a Wayland compositor.
class PictureClipboard {
public:
    /// Copies the displayed picture as image/png with the preset, and reports the result. `pass` is
    /// the pass that is displayed as the picture.
    void copy(const Renderer& renderer, int pass, const Document& document,
              const RecentMedia& recent, Messages& messages);

private:
    Result<void> offer(std::string png);

    std::unique_ptr<gpu::ImageClipboard> m_clipboard;  // null: not used yet
};
