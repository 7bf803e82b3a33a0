// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/station/hidraw_node.h"
#include "core/result.h"
#include "station/stream/frame_stream.h"

#include <cstdint>
#include <memory>
#include <string>

namespace chiron::station {

/// The station's end of a line to one host: a TCP port, a pseudo-terminal that stands in for a serial line,
/// or a file that stands in for a USB HID device. Thread: one.
class HostLine {
public:
    HostLine() = default;
    HostLine(const HostLine&) = delete;
    HostLine& operator=(const HostLine&) = delete;
    ~HostLine();

    /// Listens on a port; 0: any free one. `host`: the address of this machine that hosts may use.
    /// Errors: device.
    core::Result<void> listenTcp(const std::string& host, std::uint16_t port);
    /// Makes a pseudo-terminal, and a link to it if `link` is not empty.
    /// Errors: device.
    core::Result<void> openTerminal(const std::string& link);
    /// Shows FOLDER/hidraw0 as the node of a USB HID device with this serial number.
    /// Errors: device.
    core::Result<void> openHidraw(const std::string& folder, const std::string& serialNumber);

    /// How a host reaches it, as drivers write addresses: tcp:HOST:PORT, serial:/dev/pts/N or
    /// hid:VVVV:PPPP:SERIAL.
    std::string address() const;
    bool connected() const noexcept { return m_stream.isOpen(); }
    FrameStream& stream() noexcept { return m_stream; }

    /// Lets a waiting host in, if there is none or the one before has closed; any other is turned away, so
    /// that nobody takes a station from under a hand. True if one came in. Does not wait.
    bool admitHost();
    /// The host has gone. Nothing but TCP has a connection that could end.
    void hostGone() noexcept;
    void unplug() noexcept;    ///< nobody reaches it any more
    core::Result<void> plug(); ///< and again, at the same address (a pseudo-terminal: by the link)

private:
    core::Result<void> listen();
    core::Result<void> openPair();

    enum class Kind { tcp, terminal, hidraw };
    Kind m_kind = Kind::tcp;
    std::string m_host;
    std::uint16_t m_port = 0;
    std::string m_link;
    std::string m_path; ///< of the pseudo-terminal
    int m_listener = -1;
    int m_otherEnd = -1; ///< of the pseudo-terminal: kept open, so that it lives while no host is there
    std::unique_ptr<HidrawNode> m_node;
    std::string m_serialNumber; ///< of the node
    FrameStream m_stream;
};

} // namespace chiron::station
