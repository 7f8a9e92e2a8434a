#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// A window in the middle, above all else, until it ends. Escape closes it.
class DialogFrame {
public:
    /// `width` in letters' heights.
    DialogFrame(const char* title, float width, const Scene& scene, Edits& edits);
    ~DialogFrame();
    DialogFrame(const DialogFrame&) = delete;
    DialogFrame& operator=(const DialogFrame&) = delete;

    bool is_open() const { return m_is_open; }

private:
    bool m_is_open = false;
};

void close_dialog(Edits& edits);

/// The only button of a dialog that tells something. Gives whether it was left by it.
bool draw_close_button(const char* label, Edits& edits);

/// The buttons at the end: the first does it, Cancel closes. Gives whether it was asked for.
bool draw_dialog_buttons(const char* label, bool can_do, Edits& edits);
