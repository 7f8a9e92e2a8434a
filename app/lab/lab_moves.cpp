// The part of Lab that writes down what is turned.
#include "io/files/atomic_file.h"
#include "lab/document/moves_file.h"
#include "lab/lab.h"

#include <fmt/format.h>

namespace fs = std::filesystem;

void Lab::record_moves(bool is_recording) {
    if (!is_recording || !m_document)
        return m_moves.stop();
    m_moves.start(m_document->look(), m_document->values());
    say("Recording automation");
}

void Lab::save_moves(const fs::path& given) {
    const fs::path file = given.has_extension() ? given : fs::path(given.string() + ".txt");
    if (!succeeded(write_atomically(file, moves_text(m_moves.moves(), m_moves.look()))))
        return;
    const std::string name = file.filename().string();
    const std::size_t count = m_moves.moves().size();
    say(count == 1 ? fmt::format("Saved 1 parameter change to \"{}\"", name)
                   : fmt::format("Saved {} parameter changes to \"{}\"", count, name));
}

// Of the frame that was drawn: there they are seen first.
void Lab::note_moves() {
    if (!m_moves.is_running() || m_document->is_restacking())
        return;
    if (m_document->look().id == m_moves.look().id)
        return m_moves.note(m_document->values(), m_player.time());
    m_moves.stop();
    say("Recording stopped because another look was opened. You can still save the automation.");
}
