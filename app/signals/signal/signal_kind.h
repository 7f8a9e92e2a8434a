#pragma once

#include "base/diagnostic.h"
#include "model/look/parameter.h"
#include "model/look/spec.h"
#include "signals/signal/signal.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

class Settings;

enum class SettingType { number, word, text };

/// When a setting has a say: while another one, a word, is one of these. No key: always.
struct UsedWhile {
    std::string key = {};
    std::vector<std::string> words = {};
};

/// One setting of a kind of signal: what a list, a control and the manual say about it.
struct SettingFacts {
    std::string key = {};
    std::string label = {};
    std::string unit = {};
    std::string help = {};
    SettingType type = SettingType::number;
    double low = 0.0;  // soft ends of a slider
    double high = 1.0;
    double step = 0.0;  // 0: any value; 1: whole numbers only
    double initial = 0.0;
    bool logarithmic = false;
    Limit limit = {-1e6, 1e6};            // a number beyond it is refused
    std::vector<std::string> words = {};  // word: all that are allowed
    std::string initial_word = {};        // word and text; "" where a text must be given
    std::string group = {};               // a heading that it stands under; "": none
    UsedWhile used_while = {};
    bool may_be_empty = false;  // of a text
    bool is_hidden = false;     // has no control of its own in a form
};

/// A setting with a few words to choose from, the first of them at the start.
SettingFacts choice_setting(std::string key, std::string label, std::string help,
                            std::vector<std::string> words);
/// How a signal that draws in x and y lies in the picture: "look", "whole", "stretch" or "crop".
SettingFacts fit_setting(UsedWhile used_while = {});
/// The settings under a heading, and only of use while `used_while` holds.
std::vector<SettingFacts> in_group(const std::string& group, const UsedWhile& used_while,
                                   std::vector<SettingFacts> settings);

/// A kind of signal; everything about it that is not its formula.
struct SignalKind {
    using Make = Result<std::unique_ptr<Signal>> (*)(const Settings& settings,
                                                     const SignalMedia& media);

    std::string kind = {};
    std::string label = {};
    std::string help = {};
    std::vector<SettingFacts> settings = {};
    std::string file_setting = {};  // the key that names a file; "": none
    std::string bare_setting = {};  // the key that a bare first word stands for; "": none
    bool is_live = false;           // needs a sound that comes in from a device
    bool is_sent = false;           // needs a beam that another program sends
    Make make = nullptr;
};

const SettingFacts* find_setting(const SignalKind& kind, std::string_view key);
/// Whether the setting has a say in a completed spec.
bool is_used(const SettingFacts& setting, const Spec& completed_spec);
