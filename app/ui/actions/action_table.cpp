#include "ui/actions/action_table.h"

#include "ui/actions/compare_actions.h"
#include "ui/actions/display_actions.h"
#include "ui/actions/edit_actions.h"
#include "ui/actions/file_actions.h"
#include "ui/actions/help_actions.h"
#include "ui/actions/parameter_actions.h"
#include "ui/actions/pass_actions.h"
#include "ui/actions/pass_edit_actions.h"
#include "ui/actions/pass_switch_actions.h"
#include "ui/actions/playback_actions.h"
#include "ui/actions/sequencer_actions.h"
#include "ui/actions/tuning_actions.h"
#include "ui/actions/view_actions.h"

ActionTable make_action_table() {
    std::vector<Action> rows;
    for (const auto& part :
         {file_actions::list(), edit_actions::list(), tuning_actions::list(),
          parameter_actions::list(), view_actions::list(), display_actions::list(),
          compare_actions::list(), pass_actions::list(), pass_switch_actions::list(),
          pass_edit_actions::list(), playback_actions::list(), sequencer_actions::list(),
          help_actions::list()})
        rows.insert(rows.end(), part.begin(), part.end());
    return ActionTable(std::move(rows));
}
