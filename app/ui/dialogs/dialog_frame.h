#pragma once

#include "lab/storage/name_check.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <optional>
#include <string>
#include <utility>

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

/// The height that is left for a list in a dialog of full height, with `rest` around it.
float list_height(float wanted, float rest);

/// Shows why the last attempt of the dialog failed, if it did.
void draw_dialog_problem(const std::string& problem, Edits& edits);

/// Surround the edits of the dialog's default button. If they report a problem, the dialog shows
/// the problem and stays open; otherwise it closes.
void begin_attempt(Edits& edits);
void end_attempt(Edits& edits);

/// The same around one change.
template <class Change>
void finish_dialog(Edits& edits, Change change) {
    begin_attempt(edits);
    edits.change(std::move(change));
    end_attempt(edits);
}

/// Shows what is wrong with a name, and a button with a valid one. Returns that name on a click.
std::optional<std::string> draw_name_advice(const NameCheck& check, Edits& edits);

/// The only button of a dialog. Enter activates it if `is_default`. Returns true when it is
/// activated.
bool draw_close_button(const char* label, Edits& edits, bool is_default = true);

/// A button that closes the dialog, and the default button, which Enter activates too. Returns true
/// when the default button is activated and `can_do`.
bool draw_dialog_buttons(const char* label, bool can_do, Edits& edits,
                         const char* closing = "Cancel");
