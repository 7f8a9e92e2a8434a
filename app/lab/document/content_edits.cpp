#include "lab/document/content_edits.h"

#include "lab/document/users_content.h"

namespace {
void change_content(Document& document, DocumentState next, std::string step_name,
                    bool continues_step) {
    document.change(std::move(next), std::move(step_name), continues_step,
                    Document::StepKind::content);
}
}  // namespace

Content content_of(const Document& document) {
    const DocumentState& state = document.state();
    return {state.signal, state.source, state.locks};
}

Driver driver_of(const Document& document) {
    const Look& look = document.look();
    if (!look.has_other_driver || !document.has_pending_stack())
        return look.driven_by;
    return is_picture_driven(document.state().stack) ? Driver::picture : Driver::signal;
}

bool is_content_locked(const Document& document) {
    return is_locked_in(driver_of(document), document.state().locks);
}

void set_signal(Document& document, Spec signal, bool continues_step, std::string step_name) {
    DocumentState next = document.state();
    if (is_users_content(signal) && !is_same_content(signal, next.signal))
        next.locks.signal = true;
    next.signal = std::move(signal);
    if (document.look().has_other_driver)
        next.stack = with_picture_driven(std::move(next.stack), false);
    change_content(document, std::move(next), std::move(step_name), continues_step);
}

void set_source(Document& document, std::string source, bool continues_step,
                std::string step_name) {
    DocumentState next = document.state();
    if (is_users_content(source) && !is_same_content(source, next.source))
        next.locks.source = true;
    next.source = std::move(source);
    if (document.look().has_other_driver)
        next.stack = with_picture_driven(std::move(next.stack), true);
    change_content(document, std::move(next), std::move(step_name), continues_step);
}

void use_content(Document& document, const Content& content) {
    DocumentState next = document.state();
    Driver driver = driver_of(document);
    if (document.look().has_other_driver) {
        driver = content.source.empty() ? Driver::signal : Driver::picture;
        next.stack = with_picture_driven(std::move(next.stack), driver == Driver::picture);
    }
    if (driver == Driver::signal) {
        next.signal = content.signal;
        next.locks.signal = false;
    } else if (driver == Driver::picture) {
        next.source = content.source;
        next.locks.source = false;
    }
    change_content(document, std::move(next), use_content_label(driver), false);
}

void keep_content(Document& document, const Content& content) {
    document.amend([&content](DocumentState& state) {
        state = with_locked_content(std::move(state), content);
    });
}

void lock_content(Document& document, bool is_locked) {
    document.amend([&, driver = driver_of(document)](DocumentState& state) {
        if (driver == Driver::signal)
            state.locks.signal = is_locked;
        else if (driver == Driver::picture)
            state.locks.source = is_locked;
    });
}

DocumentState with_locked_content(DocumentState state, const Content& content) {
    state.locks = content.locks;
    if (content.locks.signal)
        state.signal = content.signal;
    if (content.locks.source)
        state.source = content.source;
    return state;
}

DocumentState with_locked_content(DocumentState state, const Document& document) {
    if (document.look().has_other_driver && is_content_locked(document))
        state.stack =
            with_picture_driven(std::move(state.stack), driver_of(document) == Driver::picture);
    return with_locked_content(std::move(state), content_of(document));
}
