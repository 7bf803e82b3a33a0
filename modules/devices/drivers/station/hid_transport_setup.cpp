// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/station/hid_transport.h"

#include "station/protocol/station_frame.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <hidapi.h>
#include <linux/hidraw.h>
#include <string>
#include <sys/ioctl.h>
#include <unistd.h>
#include <vector>

namespace chiron::devices {

namespace {

constexpr std::int64_t kMillisecond_ns = 1'000'000;
/// hidapi waits for whole milliseconds; shorter waits look at the device this often.
constexpr std::int64_t kLook_ns = 50'000;

class HidTransport final : public IStationTransport {
public:
    explicit HidTransport(hid_device* device) noexcept : m_device(device) {}
    ~HidTransport() override { closeIt(); }

    station::Sent send(const station::FrameBytes& frame) noexcept override {
        if (m_device == nullptr)
            return station::Sent::gone;
        std::array<unsigned char, station::kFrameBytes + 1> report{}; // begins with the report's number: none
        std::copy(frame.begin(), frame.end(), report.begin() + 1);
        return ::hid_write(m_device, report.data(), report.size()) < 0 ? station::Sent::gone
                                                                       : station::Sent::sent;
    }
    station::Received receive(station::FrameBytes& frame, std::int64_t deadline_ns) noexcept override {
        if (m_device == nullptr)
            return station::Received::gone;
        for (;;) {
            const std::int64_t left_ns = deadline_ns - station::steadyNow_ns();
            const auto wait_ms =
                static_cast<int>(std::clamp<std::int64_t>(left_ns / kMillisecond_ns, 0, 1000));
            const int got = ::hid_read_timeout(m_device, frame.data(), frame.size(), wait_ms);
            if (got < 0)
                return station::Received::gone;
            if (got == static_cast<int>(frame.size()))
                return station::Received::frame;
            if (got > 0)
                ++m_malformed;
            if (left_ns <= 0)
                return station::Received::nothing;
            if (got > 0)
                continue;
            if (wait_ms == 0) {
                const timespec rest{0, std::min(left_ns, kLook_ns)};
                (void)::clock_nanosleep(CLOCK_MONOTONIC, 0, &rest, nullptr);
            }
        }
    }
    void close() noexcept override { closeIt(); }
    std::uint64_t malformed() const noexcept override { return m_malformed; }

private:
    void closeIt() noexcept {
        if (m_device != nullptr)
            ::hid_close(m_device);
        m_device = nullptr;
    }

    hid_device* m_device;
    std::uint64_t m_malformed = 0;
};

/// A node of the kernel's that reaches a device.
struct PluggedIn {
    std::string path;
    std::string model;
    std::string serialNumber;
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;
    bool saysStation = false; ///< by its usage
};

/// USB's texts are Unicode; what is not ASCII is shown as "?".
std::string asciiOf(const wchar_t* text) {
    std::string ascii;
    for (; text != nullptr && *text != 0; ++text)
        ascii += *text >= 0x20 && *text < 0x7F ? static_cast<char>(*text) : '?';
    return ascii;
}

/// What is plugged in, each node once; vendor and product 0: whatever they are. Nothing is opened.
std::vector<PluggedIn> pluggedIn(std::uint16_t vendor, std::uint16_t product) {
    std::vector<PluggedIn> found;
    hid_device_info* const all = ::hid_enumerate(vendor, product);
    for (const hid_device_info* each = all; each != nullptr; each = each->next) {
        const bool saysStation =
            each->usage_page == STATION_HID_USAGE_PAGE && each->usage == STATION_HID_USAGE;
        const auto known = std::find_if(found.begin(), found.end(),
                                        [each](const PluggedIn& other) { return other.path == each->path; });
        if (known != found.end()) // a node has an entry for each of its usages
            known->saysStation = known->saysStation || saysStation;
        else
            found.push_back({each->path, asciiOf(each->product_string), asciiOf(each->serial_number),
                             each->vendor_id, each->product_id, saysStation});
    }
    ::hid_free_enumeration(all);
    return found;
}

/// The nodes that an address can mean.
std::vector<PluggedIn> meantBy(const StationAddress& address) {
    std::vector<PluggedIn> found = pluggedIn(address.vendor, address.product);
    if (!address.serialNumber.empty())
        std::erase_if(found,
                      [&address](const PluggedIn& one) { return one.serialNumber != address.serialNumber; });
    // A device with a keyboard or a mouse of its own has a node for each.
    if (std::any_of(found.begin(), found.end(), [](const PluggedIn& one) { return one.saysStation; }))
        std::erase_if(found, [](const PluggedIn& one) { return !one.saysStation; });
    return found;
}

std::string addressOf(std::uint16_t vendor, std::uint16_t product, const std::string& serialNumber) {
    char ids[16];
    (void)std::snprintf(ids, sizeof ids, "%04x:%04x", unsigned{vendor}, unsigned{product});
    return std::string("hid:") + ids + (serialNumber.empty() ? "" : ":" + serialNumber);
}

/// Why this node cannot be opened, as errno; 0: it can. hidapi 0.13.1 uses freed memory in hid_open_path()
/// where a node opens and then does not answer: after this look, only one that goes in between can do that.
int problemOf(const std::string& path) {
    const int node = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
    if (node < 0)
        return errno;
    int size = 0;
    const int problem = ::ioctl(node, HIDIOCGRDESCSIZE, &size) < 0 ? errno : 0;
    ::close(node);
    return problem;
}

} // namespace

std::vector<FoundStation> findHidStations() {
    std::vector<FoundStation> stations;
    if (::hid_init() != 0)
        return stations;
    for (const PluggedIn& one : pluggedIn(0, 0))
        if (one.saysStation)
            stations.push_back(
                {one.model, one.serialNumber, addressOf(one.vendor, one.product, one.serialNumber)});
    std::sort(stations.begin(), stations.end(),
              [](const FoundStation& a, const FoundStation& b) { return a.serialNumber < b.serialNumber; });
    return stations;
}

core::Result<std::unique_ptr<IStationTransport>> openHid(const StationAddress& address) {
    const auto refuse = [&address](const std::string& why) {
        return core::fail(core::ErrorCode::device,
                          "station at " + addressOf(address.vendor, address.product, address.serialNumber) +
                              ": " + why);
    };
    if (::hid_init() != 0)
        return refuse("USB HID is not available on this computer");
    const std::vector<PluggedIn> found = meantBy(address);
    if (found.empty())
        return refuse("no such USB device is plugged in; check that it is plugged in and switched on");
    if (found.size() > 1) {
        std::string serials;
        for (const PluggedIn& one : found)
            serials +=
                (serials.empty() ? "" : ", ") + (one.serialNumber.empty() ? "(none)" : one.serialNumber);
        return refuse("several are plugged in, with the serial numbers " + serials +
                      "; add the one that is meant, as hid:VVVV:PPPP:SERIAL");
    }
    const std::string& path = found.front().path;
    const int problem = problemOf(path);
    if (problem == EACCES || problem == EPERM)
        return refuse("this person may not open " + path +
                      "; install the rule packaging/udev/70-chiron-station.rules, then plug the station in "
                      "again");
    if (hid_device* const device = problem == 0 ? ::hid_open_path(path.c_str()) : nullptr; device != nullptr)
        return std::make_unique<HidTransport>(device);
    return refuse(path + " cannot be opened; plug the station in again");
}

} // namespace chiron::devices
