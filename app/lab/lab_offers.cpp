// The part of Lab that offers to do what it does not do by itself.
#include "lab/lab.h"

void Lab::ask(std::string text, std::vector<Choice> choices) {
    say(std::move(text), true);
    m_notice->choices = std::move(choices);
    m_notice->goes_by = false;
}
