#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// A centred modal window, open during its lifetime.
class DialogFrame {
public:
    /// `width` in multiples of the font size. `escape_closes`: false while the dialog itself uses
    /// the Escape key.
    DialogFrame(const char* title, float width, const Scene& scene, Edits& edits,
                bool escape_closes = true);
    ~DialogFrame();
    DialogFrame(const DialogFrame&) = delete;
    DialogFrame& operator=(const DialogFrame&) = delete;

    bool is_open() const { return m_is_open; }

private:
    bool m_is_open = false;
};

void close_dialog(Edits& edits);

/// The only button of a dialog. Enter activates it if `is_default`. Returns true when it is
/// activated.
bool draw_close_button(const char* label, Edits& edits, bool is_default = true);

/// Cancel and the default button, which Enter activates too. Returns true when the default
/// button is activated and `can_do`. Cancel closes the dialog.
bool draw_dialog_buttons(const char* label, bool can_do, Edits& edits);
