#pragma once

/// The senders that a network port accepts.
enum class NetworkReach {
    this_machine,   // 127.0.0.1
    local_network,  // also the networks that this machine is part of
};
