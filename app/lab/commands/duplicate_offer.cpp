#include "lab/commands/duplicate_offer.h"

#include "lab/storage/name_check.h"
#include "lab/window/window_state.h"

void offer_duplicate(Workspace& work, const std::string& reason) {
    const std::string id = valid_look_id(work.document->look().id) + "-copy";
    work.messages.offer(reason, {.name = "Duplicate look",
                                 .commands = {[id](WindowState& window) {
                                     window.dialog = {.kind = Dialog::Kind::duplicate_look,
                                                      .text = id};
                                 }}});
}
