#pragma once

#include "lab/document/document.h"
#include "lab/editor/external_programs.h"
#include "lab/library/library.h"
#include "lab/library/opened_files.h"
#include "lab/media/live_choices.h"
#include "lab/media/look_pictures.h"
#include "lab/media/media_input.h"
#include "lab/media/render_size.h"
#include "lab/messages/messages.h"
#include "lab/playback/player.h"
#include "lab/rendering/display_pace.h"
#include "lab/rendering/pending_redraw.h"
#include "lab/rendering/renderer.h"
#include "lab/send/look_sender.h"

#include <memory>

/// The open look, its media and its pictures. The parts of the lab share it.
struct Workspace {
    Library library;
    Messages messages = {};
    ExternalPrograms programs{messages, library.roots()};
    OpenedFiles opened_files = {};
    OpenDocument document = {};
    Player player{machine_sound_devices()};
    MediaInput media{RecentMedia(library.roots())};
    LiveChoices live = {};
    RenderSize size{document, media};
    LookSender sender{library.roots().cache / "sent"};
    std::unique_ptr<Renderer> renderer = {};  // null until a look has drawn
    LookPictures pictures = {};
    PendingRedraw redraw = {};
    std::shared_ptr<const CuePlan> cues = {};  // that play; null: none
    std::optional<Tempo> clock_tempo = {};     // of a MIDI clock, instead of the document's
    DisplayPace display = {};
    std::optional<HdrLight> hdr = {};  // that the picture is drawn for; nullopt: SDR
    bool draws_subframes = false;      // allowed by the user; otherwise the picture is steady

    explicit Workspace(Library opened) : library(std::move(opened)) {}
    Workspace(const Workspace&) = delete;
    Workspace& operator=(const Workspace&) = delete;
};
