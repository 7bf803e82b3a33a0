// SPDX-License-Identifier: GPL-3.0-or-later
#define FUSE_USE_VERSION 35
#include "app/station/hidraw_node.h"

#include "station/protocol/station_frame.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <fuse.h>
#include <fuse_lowlevel.h>
#include <linux/hidraw.h>
#include <mutex>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace chiron::station {

namespace {

constexpr std::size_t kRing = 64; // HIDRAW_BUFFER_SIZE
constexpr const char* kFile = "/hidraw0";
constexpr std::uint16_t kUsb = 3; // BUS_USB

constexpr std::uint8_t low(unsigned value) {
    return static_cast<std::uint8_t>(value & 0xFF);
}
constexpr std::uint8_t high(unsigned value) {
    return static_cast<std::uint8_t>(value >> 8);
}
/// Unnumbered reports of 64 bytes in both directions.
// clang-format off
constexpr std::array<std::uint8_t, 26> kReportDescriptor{
    0x06, low(STATION_HID_USAGE_PAGE), high(STATION_HID_USAGE_PAGE), // usage page
    0x0A, low(STATION_HID_USAGE), high(STATION_HID_USAGE),           // usage
    0xA1, 0x01,                                                      // collection: application
    0x15, 0x00, 0x26, 0xFF, 0x00,                                    // 0 to 255
    0x75, 0x08, 0x95, 0x40,                                          // 64 times 8 bits
    0x09, 0x02, 0x81, 0x02,                                          // input
    0x09, 0x03, 0x91, 0x02,                                          // output
    0xC0};
// clang-format on

void closeIt(int& descriptor) noexcept {
    if (descriptor >= 0)
        ::close(descriptor);
    descriptor = -1;
}

/// Two ends of a TCP connection within this computer, which says how much the other end has not taken; -1 and
/// -1: none could be made.
std::array<int, 2> connectedPair() {
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    auto* const address = reinterpret_cast<sockaddr*>(&place);
    socklen_t size = sizeof place;
    const int on = 1;
    int listener = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    std::array<int, 2> pair{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0), -1};
    if (::bind(listener, address, size) == 0 && ::listen(listener, 1) == 0 &&
        ::getsockname(listener, address, &size) == 0 && ::connect(pair[0], address, size) == 0)
        pair[1] = ::accept4(listener, nullptr, nullptr, SOCK_CLOEXEC);
    closeIt(listener);
    if (pair[1] < 0)
        closeIt(pair[0]);
    for (const int end : pair)
        (void)::setsockopt(end, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    return pair;
}

/// Answers until the session is ended. (fuse_loop() notices an end with the next request alone, and a host
/// that keeps the file open may send none.)
void serveRequests(fuse_session& session) {
    constexpr int kLook_ms = 50;
    fuse_buf request{};
    while (!fuse_session_exited(&session)) {
        pollfd waited{fuse_session_fd(&session), POLLIN, 0};
        if (::poll(&waited, 1, kLook_ms) <= 0)
            continue;
        const int got = fuse_session_receive_buf(&session, &request);
        if (got == -EINTR || got == -EAGAIN)
            continue;
        if (got <= 0)
            break;
        fuse_session_process_buf(&session, &request);
    }
    std::free(request.mem);
}

} // namespace

struct HidrawNode::Served {
    fuse* handle = nullptr;
    std::thread server, pump;
    std::mutex mutex;
    std::deque<FrameBytes> ring;
    fuse_pollhandle* waiter = nullptr;
    int line = -1; ///< this end of the pair whose other end is the station's; -1: pulled out
    bool opened = false;

    /// Tells a host that waits in poll() that something has changed. The mutex is held.
    void wake() {
        if (waiter == nullptr)
            return;
        fuse_notify_poll(waiter);
        fuse_pollhandle_destroy(waiter);
        waiter = nullptr;
    }

    /// Takes what the station sends until its end is closed.
    void takeFrom(int descriptor) {
        FrameBytes frame{};
        while (::recv(descriptor, frame.data(), frame.size(), MSG_WAITALL) ==
               static_cast<ssize_t>(frame.size())) {
            const std::lock_guard lock(mutex);
            if (opened && ring.size() < kRing)
                ring.push_back(frame);
            wake();
        }
    }

    static Served& self() { return *static_cast<Served*>(fuse_get_context()->private_data); }

    static int attributes(const char* path, struct stat* about, fuse_file_info*) {
        *about = {};
        if (std::strcmp(path, "/") == 0) {
            about->st_mode = S_IFDIR | 0755;
            about->st_nlink = 2;
            return 0;
        }
        if (std::strcmp(path, kFile) != 0)
            return -ENOENT;
        about->st_mode = S_IFREG | 0600;
        about->st_nlink = 1;
        about->st_uid = ::getuid();
        about->st_size = 1 << 20;
        return 0;
    }

    static int open(const char* path, fuse_file_info* file) {
        Served& node = self();
        const std::lock_guard lock(node.mutex);
        if (std::strcmp(path, kFile) != 0 || node.line < 0)
            return -ENODEV;
        file->direct_io = 1;
        file->nonseekable = 1;
        node.ring.clear(); // as each open of the kernel's node begins
        node.opened = true;
        return 0;
    }

    static int release(const char*, fuse_file_info*) {
        Served& node = self();
        const std::lock_guard lock(node.mutex);
        node.opened = false;
        return 0;
    }

    static int read(const char*, char* bytes, std::size_t room, off_t, fuse_file_info*) {
        Served& node = self();
        const std::lock_guard lock(node.mutex);
        if (node.ring.empty())
            return node.line < 0 ? -EIO : -EAGAIN; // hidapi polls first
        const std::size_t count = std::min(room, kFrameBytes);
        std::memcpy(bytes, node.ring.front().data(), count);
        node.ring.pop_front();
        return static_cast<int>(count);
    }

    static int write(const char*, const char* bytes, std::size_t count, off_t, fuse_file_info*) {
        Served& node = self();
        const std::lock_guard lock(node.mutex);
        if (node.line < 0)
            return -ENODEV;
        if (count != kFrameBytes + 1 || bytes[0] != 0)
            return -EINVAL;
        // A station that does not take reports makes the kernel wait; here they are lost.
        (void)::send(node.line, bytes + 1, kFrameBytes, MSG_DONTWAIT | MSG_NOSIGNAL);
        return static_cast<int>(count);
    }

    static int poll(const char*, fuse_file_info*, fuse_pollhandle* handle, unsigned* events) {
        Served& node = self();
        const std::lock_guard lock(node.mutex);
        if (handle != nullptr) {
            if (node.waiter != nullptr)
                fuse_pollhandle_destroy(node.waiter);
            node.waiter = handle;
        }
        *events = POLLOUT | (node.ring.empty() ? 0u : unsigned{POLLIN}) |
                  (node.line < 0 ? unsigned{POLLERR | POLLHUP} : 0u);
        return 0;
    }

    static int ioctl(const char*, unsigned command, void*, fuse_file_info*, unsigned, void* data) {
        switch (command) {
        case HIDIOCGRDESCSIZE:
            *static_cast<int*>(data) = static_cast<int>(kReportDescriptor.size());
            return 0;
        case HIDIOCGRDESC: {
            auto& descriptor = *static_cast<hidraw_report_descriptor*>(data);
            descriptor.size = static_cast<std::uint32_t>(kReportDescriptor.size());
            std::copy(kReportDescriptor.begin(), kReportDescriptor.end(), descriptor.value);
            return 0;
        }
        case HIDIOCGRAWINFO:
            *static_cast<hidraw_devinfo*>(data) = {kUsb, static_cast<std::int16_t>(kTrialVendor),
                                                   static_cast<std::int16_t>(kTrialProduct)};
            return 0;
        default:
            return -EINVAL;
        }
    }
};

HidrawNode::HidrawNode(std::unique_ptr<Served> served) : m_served(std::move(served)) {}

core::Result<std::unique_ptr<HidrawNode>> HidrawNode::serve(const std::string& folder) {
    static constexpr fuse_operations kOperations = [] {
        fuse_operations operations{};
        operations.getattr = Served::attributes;
        operations.open = Served::open;
        operations.release = Served::release;
        operations.read = Served::read;
        operations.write = Served::write;
        operations.poll = Served::poll;
        operations.ioctl = Served::ioctl;
        return operations;
    }();
    auto served = std::make_unique<Served>();
    std::string name = "chiron-station";
    char* words[] = {name.data(), nullptr};
    fuse_args arguments = FUSE_ARGS_INIT(1, words);
    served->handle = fuse_new(&arguments, &kOperations, sizeof kOperations, served.get());
    if (served->handle == nullptr || fuse_mount(served->handle, folder.c_str()) != 0) {
        if (served->handle != nullptr)
            fuse_destroy(served->handle);
        return core::fail(core::ErrorCode::device,
                          folder +
                              ": no file system can be shown there; expected an empty folder, /dev/fuse, and "
                              "a person who may use it");
    }
    served->server = std::thread([handle = served->handle] { serveRequests(*fuse_get_session(handle)); });
    return std::unique_ptr<HidrawNode>(new HidrawNode(std::move(served)));
}

HidrawNode::~HidrawNode() {
    unplug();
    fuse_exit(m_served->handle);
    m_served->server.join();
    fuse_unmount(m_served->handle);
    fuse_destroy(m_served->handle);
}

FrameStream HidrawNode::plugIn() {
    unplug();
    const std::array<int, 2> pair = connectedPair();
    if (pair[0] < 0)
        return {};
    {
        const std::lock_guard lock(m_served->mutex);
        m_served->line = pair[0];
        m_served->ring.clear();
    }
    m_served->pump = std::thread([this, line = pair[0]] { m_served->takeFrom(line); });
    return {pair[1], Framing::concatenated};
}

void HidrawNode::unplug() noexcept {
    int line = -1;
    {
        const std::lock_guard lock(m_served->mutex);
        std::swap(line, m_served->line);
        m_served->ring.clear();
        m_served->wake();
    }
    if (line < 0)
        return;
    (void)::shutdown(line, SHUT_RDWR);
    m_served->pump.join();
    ::close(line);
}

} // namespace chiron::station
