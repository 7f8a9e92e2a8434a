#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Sends the look to a program that runs on this machine.
void draw_send_dialog(const Scene& scene, Edits& edits);

/// Opens the dialog. `program`: index of running_programs().
template <std::size_t program>
void send_look(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) { window.sending.program = program; });
    edits.show({.kind = Dialog::Kind::send_look});
}
