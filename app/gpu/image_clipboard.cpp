#include "gpu/image_clipboard.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <condition_variable>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <poll.h>
#include <string_view>
#include <sys/eventfd.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>
#include <xcb/xcb.h>

namespace gpu {

namespace {
struct Free {
    void operator()(void* memory) const { std::free(memory); }
};
template <class Reply>
using Owned = std::unique_ptr<Reply, Free>;
}  // namespace

/// The connection and the thread that answers requests.
class ImageClipboard::Server {
public:
    explicit Server(xcb_connection_t* connection) : m_connection(connection) {
        xcb_screen_t* const screen = xcb_setup_roots_iterator(xcb_get_setup(connection)).data;
        m_window = xcb_generate_id(connection);
        constexpr std::uint32_t events = XCB_EVENT_MASK_PROPERTY_CHANGE;
        xcb_create_window(connection, XCB_COPY_FROM_PARENT, m_window, screen->root, 0, 0, 1, 1, 0,
                          XCB_WINDOW_CLASS_INPUT_OUTPUT, screen->root_visual, XCB_CW_EVENT_MASK,
                          &events);
        m_piece = std::min<std::size_t>(std::size_t{xcb_get_maximum_request_length(connection)},
                                        std::size_t{1} << 18u);
        m_thread = std::thread([this] { run(); });
    }
    ~Server() {
        m_is_ending = true;
        wake();
        m_thread.join();
        xcb_disconnect(m_connection);
        ::close(m_wake);
    }
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    bool offer(std::string png) {
        constexpr auto timeout = std::chrono::seconds(3);
        std::unique_lock lock(m_mutex);
        m_next = std::make_shared<const std::string>(std::move(png));
        m_state = State::asked;
        wake();
        m_changed.wait_for(lock, timeout, [this] { return m_state != State::asked; });
        return m_state == State::owned;
    }

private:
    enum class State { none, asked, owned };

    using Data = std::shared_ptr<const std::string>;  // shared by the offer and running transfers

    /// A picture that is sent in pieces (ICCCM, 2.7.2): each time the requestor deletes the
    /// property, the next piece is written. An empty one ends it.
    struct Transfer {
        xcb_window_t requestor;
        xcb_atom_t property;
        Data data;
        std::size_t sent = 0;
    };

    struct Atoms {
        xcb_atom_t clipboard, targets, timestamp, multiple, incr, png;
    };

    void wake() const {
        const std::uint64_t one = 1;
        (void)!::write(m_wake, &one, sizeof one);
    }

    xcb_atom_t atom(std::string_view name) const {
        const Owned<xcb_intern_atom_reply_t> reply(xcb_intern_atom_reply(
            m_connection,
            xcb_intern_atom(m_connection, 0, static_cast<std::uint16_t>(name.size()), name.data()),
            nullptr));
        return reply ? reply->atom : static_cast<xcb_atom_t>(XCB_ATOM_NONE);
    }

    void run() {
        std::array<pollfd, 2> waits{pollfd{xcb_get_file_descriptor(m_connection), POLLIN, 0},
                                    pollfd{m_wake, POLLIN, 0}};
        while (!m_is_ending && xcb_connection_has_error(m_connection) == 0) {
            if (::poll(waits.data(), waits.size(), -1) < 0 && errno != EINTR)
                return;
            if ((waits[1].revents & POLLIN) != 0)
                ask_for_time();
            while (const Owned<xcb_generic_event_t> event{xcb_poll_for_event(m_connection)})
                handle(*event);
            xcb_flush(m_connection);
        }
    }

    // Owning a selection needs a time of the server, which a change of a property tells.
    void ask_for_time() {
        std::uint64_t count = 0;
        (void)!::read(m_wake, &count, sizeof count);
        const std::lock_guard lock(m_mutex);
        if (m_state == State::asked)
            xcb_change_property(m_connection, XCB_PROP_MODE_APPEND, m_window, m_atoms.png,
                                m_atoms.png, 8, 0, nullptr);
    }

    void take_selection(xcb_timestamp_t time) {
        const std::lock_guard lock(m_mutex);
        if (m_state != State::asked)
            return;
        xcb_set_selection_owner(m_connection, m_window, m_atoms.clipboard, time);
        const Owned<xcb_get_selection_owner_reply_t> owner(xcb_get_selection_owner_reply(
            m_connection, xcb_get_selection_owner(m_connection, m_atoms.clipboard), nullptr));
        const bool is_owned = owner && owner->owner == m_window;
        m_data = is_owned ? m_next : nullptr;
        m_time = time;
        m_next = nullptr;
        m_state = is_owned ? State::owned : State::none;
        m_changed.notify_all();
    }

    void handle(const xcb_generic_event_t& event) {
        const void* const whole = &event;
        switch (event.response_type & 0x7f) {
            case XCB_PROPERTY_NOTIFY:
                return handle(*static_cast<const xcb_property_notify_event_t*>(whole));
            case XCB_SELECTION_REQUEST:
                return answer(*static_cast<const xcb_selection_request_event_t*>(whole));
            case XCB_SELECTION_CLEAR:
                m_data = nullptr;
                return;
            case XCB_DESTROY_NOTIFY:
                std::erase_if(
                    m_transfers,
                    [gone = static_cast<const xcb_destroy_notify_event_t*>(whole)->window](
                        const Transfer& transfer) { return transfer.requestor == gone; });
                return;
            default:
                return;  // also errors, such as a requestor that is gone
        }
    }

    void handle(const xcb_property_notify_event_t& change) {
        if (change.window == m_window)
            return take_selection(change.time);
        if (change.state != XCB_PROPERTY_DELETE)
            return;
        const auto found = std::ranges::find_if(m_transfers, [&](const Transfer& transfer) {
            return transfer.requestor == change.window && transfer.property == change.atom;
        });
        if (found == m_transfers.end())
            return;
        const std::size_t count = std::min(m_piece, found->data->size() - found->sent);
        write(found->requestor, found->property,
              std::string_view(*found->data).substr(found->sent, count));
        found->sent += count;
        if (count == 0)
            m_transfers.erase(found);
    }

    void write(xcb_window_t window, xcb_atom_t property, std::string_view bytes) const {
        xcb_change_property(m_connection, XCB_PROP_MODE_REPLACE, window, property, m_atoms.png, 8,
                            static_cast<std::uint32_t>(bytes.size()), bytes.data());
    }

    void answer(const xcb_selection_request_event_t& request) {
        // Old requestors name no property (ICCCM, 2.2).
        const xcb_atom_t property =
            request.property == XCB_ATOM_NONE ? request.target : request.property;
        xcb_selection_notify_event_t notice{};
        notice.response_type = XCB_SELECTION_NOTIFY;
        notice.time = request.time;
        notice.requestor = request.requestor;
        notice.selection = request.selection;
        notice.target = request.target;
        notice.property = m_data && convert(request.requestor, request.target, property)
                              ? property
                              : static_cast<xcb_atom_t>(XCB_ATOM_NONE);
        std::array<char, 32> sent{};  // the size of every event
        std::memcpy(sent.data(), &notice, sizeof notice);
        xcb_send_event(m_connection, 0, request.requestor, XCB_EVENT_MASK_NO_EVENT, sent.data());
    }

    // Writes the clipboard in the form of a target; false: it has no such form.
    bool convert(xcb_window_t requestor, xcb_atom_t target, xcb_atom_t property) {
        if (target == m_atoms.targets) {
            const std::array<xcb_atom_t, 4> all{m_atoms.targets, m_atoms.timestamp,
                                                m_atoms.multiple, m_atoms.png};
            xcb_change_property(m_connection, XCB_PROP_MODE_REPLACE, requestor, property,
                                XCB_ATOM_ATOM, 32, all.size(), all.data());
            return true;
        }
        if (target == m_atoms.timestamp) {
            xcb_change_property(m_connection, XCB_PROP_MODE_REPLACE, requestor, property,
                                XCB_ATOM_INTEGER, 32, 1, &m_time);
            return true;
        }
        if (target == m_atoms.multiple)
            return convert_all(requestor, property);
        if (target != m_atoms.png)
            return false;
        if (m_data->size() <= m_piece)
            write(requestor, property, *m_data);
        else
            start_transfer(requestor, property);
        return true;
    }

    // The property has pairs of a target and a property; targets that we lack become 0.
    bool convert_all(xcb_window_t requestor, xcb_atom_t property) {
        constexpr std::uint32_t most_atoms = 64;
        const Owned<xcb_get_property_reply_t> list(
            xcb_get_property_reply(m_connection,
                                   xcb_get_property(m_connection, 0, requestor, property,
                                                    XCB_GET_PROPERTY_TYPE_ANY, 0, most_atoms),
                                   nullptr));
        if (!list || list->format != 32)
            return false;
        const auto* const atoms =
            static_cast<const xcb_atom_t*>(xcb_get_property_value(list.get()));
        std::vector<xcb_atom_t> pairs(atoms, atoms + list->value_len);
        for (std::size_t i = 0; i + 1 < pairs.size(); i += 2)
            if (pairs[i] == m_atoms.multiple || !convert(requestor, pairs[i], pairs[i + 1]))
                pairs[i + 1] = XCB_ATOM_NONE;
        xcb_change_property(m_connection, XCB_PROP_MODE_REPLACE, requestor, property, list->type,
                            32, static_cast<std::uint32_t>(pairs.size()), pairs.data());
        return true;
    }

    void start_transfer(xcb_window_t requestor, xcb_atom_t property) {
        constexpr std::uint32_t events =
            XCB_EVENT_MASK_PROPERTY_CHANGE | XCB_EVENT_MASK_STRUCTURE_NOTIFY;
        xcb_change_window_attributes(m_connection, requestor, XCB_CW_EVENT_MASK, &events);
        const auto size = static_cast<std::uint32_t>(m_data->size());
        xcb_change_property(m_connection, XCB_PROP_MODE_REPLACE, requestor, property, m_atoms.incr,
                            32, 1, &size);
        m_transfers.push_back({requestor, property, m_data});
    }

    xcb_connection_t* m_connection;
    xcb_window_t m_window = 0;
    std::size_t m_piece = 0;  // bytes of a property
    int m_wake = ::eventfd(0, EFD_CLOEXEC);
    std::atomic<bool> m_is_ending = false;
    std::mutex m_mutex;
    std::condition_variable m_changed;
    State m_state = State::none;
    Data m_next;
    Data m_data;  // null: another program owns the clipboard
    xcb_timestamp_t m_time = 0;
    std::vector<Transfer> m_transfers;
    const Atoms m_atoms{atom("CLIPBOARD"), atom("TARGETS"), atom("TIMESTAMP"),
                        atom("MULTIPLE"),  atom("INCR"),    atom("image/png")};
    std::thread m_thread;
};

Result<std::unique_ptr<ImageClipboard>> ImageClipboard::open() {
    xcb_connection_t* const connection = xcb_connect(nullptr, nullptr);
    if (xcb_connection_has_error(connection) != 0) {
        xcb_disconnect(connection);
        return fail({{}, 0, "can't reach the clipboard: no X server"});
    }
    return std::unique_ptr<ImageClipboard>(
        new ImageClipboard(std::make_unique<Server>(connection)));
}

ImageClipboard::ImageClipboard(std::unique_ptr<Server> server) : m_server(std::move(server)) {}
ImageClipboard::~ImageClipboard() = default;

Result<void> ImageClipboard::offer(std::string png) {
    if (m_server->offer(std::move(png)))
        return {};
    return fail({{}, 0, "can't copy the picture: the X server refused the clipboard"});
}

}  // namespace gpu
